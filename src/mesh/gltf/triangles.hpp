// Converts strips and fans to separate triangles.
#pragma once

#include <cstdint>
#include <vector>

namespace warpjet {

enum class Primitives { Triangles = 4, Strip = 5, Fan = 6 };  // the values of glTF and OpenGL

// Returns the number of triangles in a primitive with that many corners.
std::size_t trianglesOf(Primitives primitives, std::size_t corners);

// Returns three corners per triangle, all with the same winding (glTF 2.0, section 3.7.2.1).
// Removes triangles of strips and fans that use a corner twice, since those only connect the pieces
// of a strip; drops surplus corners.
std::vector<std::uint32_t> separateTriangles(Primitives primitives,
                                             std::vector<std::uint32_t> corners);

// Reverses the triangles from an index on.
void reverseWinding(std::vector<std::uint32_t>& indices, std::size_t from);

}  // namespace warpjet
