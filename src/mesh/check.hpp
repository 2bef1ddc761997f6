// Checks that the arrays of a mesh are consistent.
#pragma once

#include <string>

#include "mesh/mesh.hpp"

namespace warpjet {

// Returns the problem as the end of a message such as "subdivide: …", or an empty string. Checks
// the lengths, that every number is finite, and that every index has its vertex. A mesh without
// vertices is valid.
std::string problemOf(const Mesh& mesh);

}  // namespace warpjet
