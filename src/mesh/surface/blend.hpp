// Interpolates vertices with all their attributes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "mesh/mesh.hpp"

namespace warpjet {

// A point of a triangle, or of an edge if the last weight is 0. The weights add up to 1.
struct Blend {
  std::array<std::uint32_t, 3> vertices;
  std::array<float, 3> weights;
};

// Appends the vertex, with linearly interpolated attributes, to `to`, which may be `from` itself.
// Normals and tangents are normalized; if they cancel, and for the sign of the bitangent, the first
// vertex is used.
void appendBlend(Mesh& to, const Mesh& from, const Blend& blend);

// Returns the vertices from `first` up to but excluding `end`, without indices.
Mesh slice(const Mesh& mesh, std::size_t first, std::size_t end);

}  // namespace warpjet
