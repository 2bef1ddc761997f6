// The part of a glTF's JSON that a static mesh needs, checked member by member before tinygltf sees
// it: tinygltf 2.7.0 truncates integers to 32 bits, walks `extras` recursively and doesn't check
// the types of some members.
#pragma once

#include <nlohmann/json.hpp>

namespace warpjet {

// Removes everything but known members of the right types: indices are whole numbers below 2^31,
// sizes below 2^32, lists of numbers have their length. The code that uses an index checks that it
// is in range. Throws a FileProblem that names the member. Nothing is copied, since a description
// can be most of a file.
void reduceToSchema(nlohmann::json& tree);

}  // namespace warpjet
