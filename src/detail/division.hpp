// The divided mesh: writes vertices and triangles for given numbers of pieces.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "detail/base_mesh.hpp"
#include "detail/interpolation.hpp"
#include "detail/tessellation.hpp"

namespace warpjet {

// Vertices: those of the base, then those of sides, in the order of the sides, then inner ones, in
// the order of the triangles. Its arrays keep their memory when they are written again.
struct Division {
  std::vector<Attribute> attributes;
  std::vector<Corners> triangles;
  // Maps a triangle of the base -> its first triangle here. The last entry is the number of
  // triangles.
  std::vector<std::uint32_t> firstTriangles;
  // Maps a side of the base -> its first vertex here, if it is divided.
  std::vector<std::uint32_t> firstVertices;

  // `pieces` has the number of pieces of each edge: all are from `pieceCounts`, or all are equal.
  // `sides` has the squared sides of each triangle in the metric of its bend, by which diagonals
  // are flipped; if it is empty, none is.
  void write(const Interpolation& interpolation, std::span<const std::uint32_t> pieces,
             Tessellations& tessellations, std::span<const SquaredSides> sides = {});

 private:
  void writeSides(const Interpolation& interpolation, std::span<const std::uint32_t> pieces);
  void writeTriangles(const Interpolation& interpolation, std::span<const std::uint32_t> pieces,
                      Tessellations& tessellations, std::span<const SquaredSides> sides);
};

// Returns the numbers of pieces of the sides of a triangle; `pieces` are by edge.
SidePieces piecesOf(const BaseMesh& base, std::size_t triangle,
                    std::span<const std::uint32_t> pieces);

// Returns the parts of patches that the triangles of a divided mesh are.
std::vector<Patch> dividePatches(const Interpolation& interpolation,
                                 std::span<const std::uint32_t> pieces,
                                 Tessellations& tessellations);

}  // namespace warpjet
