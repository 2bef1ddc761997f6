// Divides a triangle whose sides are split into pieces of equal length.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "detail/flips.hpp"
#include "detail/triangulate.hpp"

namespace warpjet {

// The allowed numbers of pieces of a side. Without 5, 7 and 10, the warps of the gallery need 4%
// more triangles; but the table for compute passes grows with the cube of their count.
inline constexpr std::array<std::uint32_t, 13> pieceCounts{1, 2,  3,  4,  5,  6, 7,
                                                           8, 10, 12, 16, 24, 32};
inline constexpr std::uint32_t maxPieces = pieceCounts.back();

// Has one number per side. Side i goes from corner i to the next one.
using SidePieces = std::array<std::uint32_t, 3>;

struct Tessellation {
  // The weights of the corners for each inner point.
  std::vector<std::array<float, 3>> inner;
  // Corners are indices of points: first those of sides 0, 1 and 2, each without its end, then the
  // inner ones.
  std::vector<Corners> triangles;
  // The flips of the first triangles: see `orderIntoPairs`. Empty if all sides have the same number
  // of pieces: then each side of a triangle is exactly one piece, and no diagonal is better.
  std::vector<Flip> flips{};
};

// Makes the tessellation with triangles of about equal sides, in the metric in which all pieces of
// the sides have length 1. Every piece of a side is a side of a triangle, so that neighbors fit.
Tessellation makeTessellation(const SidePieces& pieces);

// Makes each tessellation on first use. `pieces` are all from `pieceCounts`, or all equal.
class Tessellations {
 public:
  const Tessellation& get(const SidePieces& pieces);

 private:
  std::map<std::uint32_t, Tessellation> regular_;  // by the number of pieces per side
  std::array<std::unique_ptr<Tessellation>,
             pieceCounts.size() * pieceCounts.size() * pieceCounts.size()>
      irregular_;
};

}  // namespace warpjet
