// Two-sided surfaces: each triangle is there twice, facing both ways.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"

namespace warpjet {

// Both lists are empty where a mesh has no two-sided triangles.
struct Sheets {
  // By corner, three a triangle: a number from 0 that it shares with the corners at its place that
  // are on the same side of the same sheet. `none` away from two-sided triangles, and in triangles
  // without area.
  std::vector<std::uint32_t> ofCorners;
  std::uint32_t count = 0;  // of those numbers
  // By vertex: whether a triangle and the one that faces the other way both use it.
  std::vector<bool> isOnBothSides;
};

// `places` has equal numbers for vertices at one place. A sheet goes on across an edge where two
// two-sided triangles meet, or where one meets a single triangle that has no other side. At the
// edges of more it is open which side goes on where, and it ends, but for vertices that triangles
// of one side have in common.
Sheets findSheets(const Mesh& mesh, const std::vector<std::uint32_t>& places);

}  // namespace warpjet
