// Two-sided surfaces: each triangle is there twice, facing both ways.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"

namespace warpjet {

struct Sheets {
  std::vector<bool> isTwoSided;  // by triangle
  // For each vertex of such triangles, a number that it shares with those at its place that are on
  // the same side of the same sheet.
  std::vector<std::uint32_t> ofVertices;
};

// `places` has equal numbers for vertices at one place. A sheet goes on across an edge where two
// two-sided triangles meet; at the edges of more it is open which side goes on where, and they end.
Sheets findSheets(const Mesh& mesh, const std::vector<std::uint32_t>& places);

}  // namespace warpjet
