// Whether the arrays of a mesh fit together.
#pragma once

#include <string>

#include "mesh/mesh.hpp"

namespace warpjet {

// What is wrong, as the end of a sentence to be put behind "subdivide: ", or nothing. Checked are
// the lengths, that every number is finite, and that every index has its vertex. A mesh of no
// vertices is right.
std::string problemOf(const Mesh& mesh);

}  // namespace warpjet
