// Finds two-sided surfaces, on which each triangle occurs twice, facing both ways.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"

namespace warpjet {

// Both lists are empty if a mesh has no two-sided triangles.
struct Sheets {
  // Maps corner (3 × triangle + 0 to 2) → an id from 0 to `count - 1`. Corners at one position have
  // the same id if they are on the same side of the same sheet. `none` at positions that no
  // two-sided triangle uses, and in triangles without area.
  std::vector<std::uint32_t> sheetOfCorner;
  std::uint32_t count = 0;  // the number of ids
  // Maps vertex → true if a triangle and the one that faces the other way both use the vertex.
  std::vector<bool> isOnBothSides;
};

// `positionIds` has equal numbers for vertices at one position. A sheet continues across an edge
// where two two-sided triangles meet, or where one meets a single one-sided triangle. At edges with
// more triangles, the continuation is ambiguous and the sheet ends; but corners of triangles on one
// side that use the same vertex of the mesh still get the same id.
Sheets findSheets(const Mesh& mesh, const std::vector<std::uint32_t>& positionIds);

}  // namespace warpjet
