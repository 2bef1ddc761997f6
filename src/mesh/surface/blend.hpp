// Vertices out of vertices, with all their attributes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "mesh/mesh.hpp"

namespace warpjet {

// A point of a triangle, or of an edge when the last weight is 0. The weights sum to 1.
struct Blend {
  std::array<std::uint32_t, 3> vertices;
  std::array<float, 3> weights;
};

// Appends the vertex, its attributes interpolated linearly, to `to`, which may be `from` itself.
// Normals and tangents have length 1 again; where they cancel out, and for the sign of the
// bitangent, the first vertex has its way.
void appendBlend(Mesh& to, const Mesh& from, const Blend& blend);

// The vertices from `first` to before `end`, without indices.
Mesh slice(const Mesh& mesh, std::size_t first, std::size_t end);

}  // namespace warpjet
