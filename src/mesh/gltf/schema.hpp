// The part of a glTF's JSON that a static mesh needs, checked member by member before tinygltf sees
// it: 2.7.0 cuts integers to 32 bits, walks `extras` recursively and takes some shapes for granted.
#pragma once

#include <nlohmann/json.hpp>

namespace warpjet {

// Leaves nothing but known members of the right types: indices are whole numbers below 2^31, sizes
// below 2^32, lists of numbers have their length. Whether an index has its element is for whoever
// follows it. Throws a FileProblem that names the member. Nothing is copied: a description can be
// most of a file.
void reduceToSchema(nlohmann::json& tree);

}  // namespace warpjet
