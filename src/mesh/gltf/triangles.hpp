// Strips and fans as separate triangles.
#pragma once

#include <cstdint>
#include <vector>

namespace warpjet {

enum class Primitives { Triangles = 4, Strip = 5, Fan = 6 };  // as glTF and OpenGL number them

// How many triangles so many corners make.
std::size_t trianglesOf(Primitives primitives, std::size_t corners);

// Three corners a triangle, all wound the same way (glTF 2.0, section 3.7.2.1). Strips and fans
// lose the triangles that use a corner twice, since those only lead to the next piece of a strip;
// corners too many are dropped.
std::vector<std::uint32_t> separateTriangles(Primitives primitives,
                                             std::vector<std::uint32_t> corners);

// Turns the triangles from an index on over.
void reverseWinding(std::vector<std::uint32_t>& indices, std::size_t from);

}  // namespace warpjet
