// Finds two-sided surfaces, on which each triangle occurs twice, facing both ways.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"

namespace warpjet {

// Both lists are empty if a mesh has no two-sided triangles.
struct Sheets {
  // A number per corner, three per triangle, counted from 0 and shared by the corners at the same
  // position that are on the same side of the same sheet. `none` outside of two-sided triangles,
  // and in triangles without area.
  std::vector<std::uint32_t> sheetOfCorner;
  std::uint32_t count = 0;  // of different numbers
  // By vertex: true if a triangle and the one that faces the other way both use it.
  std::vector<bool> isOnBothSides;
};

// `positionIds` has equal numbers for vertices at one position. A sheet continues across an edge
// where two two-sided triangles meet, or where one meets a single one-sided triangle. At edges with
// more triangles the continuation is ambiguous, and the sheet ends, except for vertices that
// triangles of one side share.
Sheets findSheets(const Mesh& mesh, const std::vector<std::uint32_t>& positionIds);

}  // namespace warpjet
