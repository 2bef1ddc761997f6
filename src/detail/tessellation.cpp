#include "detail/tessellation.hpp"

#include <algorithm>
#include <cmath>

namespace warpjet {

namespace {

using glm::dvec2, glm::dvec3;

// The height of a triangle with sides of length 1.
const double heightOfRow = std::sqrt(0.75);

// Places the corners such that the sides have these lengths, counterclockwise from the start of the
// longest. The number of pieces of each side is the largest that is needed anywhere along it, and
// rounded up, so the three numbers may be lengths of the sides of a degenerate triangle, or of
// none. Therefore, the longest side is at most as long as the other two together, with shorter
// pieces then, and the triangle is at least as high as one whose shortest side is at 60 degrees to
// the longest.
std::array<dvec2, 3> cornersFor(const SidePieces& pieces, int longest) {
  const double right = pieces[(longest + 1) % 3], left = pieces[(longest + 2) % 3];
  const double base = std::min<double>(pieces[longest], left + right);
  const double x = (base * base + left * left - right * right) / (2 * base);
  const double y = std::sqrt(std::max(0.0, left * left - x * x));
  std::array<dvec2, 3> corners{dvec2(0), dvec2(0), dvec2(0)};
  corners[(longest + 1) % 3] = {base, 0};
  corners[(longest + 2) % 3] = {x, std::max(y, heightOfRow * std::min(left, right))};
  return corners;
}

// Lists the points of the sides, as weights of the corners.
std::vector<dvec3> pointsOfSides(const SidePieces& pieces) {
  std::vector<dvec3> points;
  for (int side = 0; side < 3; ++side) {
    for (std::uint32_t i = 0; i < pieces[side]; ++i) {
      const double along = static_cast<double>(i) / pieces[side];
      dvec3 weights(0);
      weights[side] = 1 - along;
      weights[(side + 1) % 3] = along;
      points.push_back(weights);
    }
  }
  return points;
}

// Lists inner points in rows parallel to the longest side, as weights of the corners.
std::vector<dvec3> rowsOfPoints(double length, double height, int longest) {
  std::vector<dvec3> points;
  const int rows = static_cast<int>(std::lround(height / heightOfRow));
  for (int row = 1; row < rows; ++row) {
    const double up = static_cast<double>(row) / rows;
    const double width = length * (1 - up);
    if (width < 0.6) continue;
    const int pieces = std::max(1, static_cast<int>(std::lround(width)));
    for (int i = 1; i < pieces; ++i) {
      const double along = static_cast<double>(i) / pieces;
      dvec3 weights;
      weights[longest] = (1 - up) * (1 - along);
      weights[(longest + 1) % 3] = (1 - up) * along;
      weights[(longest + 2) % 3] = up;
      points.push_back(weights);
    }
  }
  return points;
}

// Returns how far a point of a side is moved outwards: the sides bulge a little, so that their
// points are the corners of a convex polygon.
dvec2 bulgeAt(const dvec3& weights, const std::array<dvec2, 3>& corners, double scale) {
  dvec2 sum(0);
  for (int side = 0; side < 3; ++side) {
    const dvec2 along = corners[(side + 1) % 3] - corners[side];
    if (weights[(side + 2) % 3] == 0)
      sum += dvec2(along.y, -along.x) / length(along) * (weights[side] * weights[(side + 1) % 3]);
  }
  return scale * sum;
}

// Sorts triangles into columns, so that successive ones share vertices that a GPU has just
// computed.
void orderByColumns(std::vector<Corners>& triangles, std::span<const dvec2> points) {
  const auto middleOf = [&](const Corners& t) {
    return (points[t[0]] + points[t[1]] + points[t[2]]) / 3.0;
  };
  std::stable_sort(triangles.begin(), triangles.end(), [&](const Corners& s, const Corners& t) {
    const dvec2 p = middleOf(s), q = middleOf(t);
    const double column = std::floor(p.x), other = std::floor(q.x);
    return column != other ? column < other : p.y < q.y;
  });
}

bool areEqual(const SidePieces& pieces) { return pieces[0] == pieces[1] && pieces[1] == pieces[2]; }

// Divides the triangle into n * n triangles, by lines parallel to its sides.
Tessellation makeRegular(std::uint32_t n) {
  Tessellation tessellation;
  // Returns the index of the point that is i pieces from corner 0 towards corner 1, and k towards
  // corner 2. Inner points are numbered row by row; row k has n - 1 - k of them.
  const auto pointAt = [n](std::uint32_t i, std::uint32_t k) {
    if (k == 0) return i;
    if (i + k == n) return n + k;
    if (i == 0) return 3 * n - k;
    return 3 * n + (k - 1) * (n - 1) - (k - 1) * k / 2 + i - 1;
  };
  const auto share = [n](std::uint32_t i) { return static_cast<float>(i) / static_cast<float>(n); };
  for (std::uint32_t k = 1; k < n; ++k) {
    for (std::uint32_t i = 1; i + k < n; ++i)
      tessellation.inner.push_back({share(n - i - k), share(i), share(k)});
  }
  // Many GPUs remember about 16 vertices, so that rows of at most 12 pieces share theirs.
  constexpr std::uint32_t maxRow = 12;
  for (std::uint32_t first = 0; first < n; first += maxRow) {
    for (std::uint32_t k = 0; k + first < n; ++k) {
      for (std::uint32_t i = first; i < std::min(first + maxRow, n - k); ++i) {
        tessellation.triangles.push_back({pointAt(i, k), pointAt(i + 1, k), pointAt(i, k + 1)});
        if (i + k + 1 < n)
          tessellation.triangles.push_back(
              {pointAt(i + 1, k), pointAt(i + 1, k + 1), pointAt(i, k + 1)});
      }
    }
  }
  return tessellation;
}

}  // namespace

Tessellation makeTessellation(const SidePieces& pieces) {
  if (areEqual(pieces)) return makeRegular(pieces[0]);
  const int longest =
      static_cast<int>(std::max_element(pieces.begin(), pieces.end()) - pieces.begin());
  const std::array<dvec2, 3> corners = cornersFor(pieces, longest);
  const double base = corners[(longest + 1) % 3].x, height = corners[(longest + 2) % 3].y;
  std::vector<dvec3> points = pointsOfSides(pieces);
  const std::size_t hullSize = points.size();
  Tessellation tessellation;
  for (const dvec3& w : rowsOfPoints(base, height, longest)) {
    points.push_back(w);
    tessellation.inner.push_back(
        {static_cast<float>(w[0]), static_cast<float>(w[1]), static_cast<float>(w[2])});
  }
  std::vector<dvec2> placed;
  for (const dvec3& w : points)
    placed.push_back(corners[0] * w[0] + corners[1] * w[1] + corners[2] * w[2] +
                     bulgeAt(w, corners, 0.08 * std::min(1.0, height)));
  tessellation.triangles = triangulate(placed, hullSize);
  orderByColumns(tessellation.triangles, placed);
  const auto square = [](std::uint32_t count) { return static_cast<float>(count * count); };
  tessellation.flips = orderIntoPairs(tessellation.triangles, points,
                                      {square(pieces[0]), square(pieces[1]), square(pieces[2])});
  return tessellation;
}

const Tessellation& Tessellations::get(const SidePieces& pieces) {
  if (areEqual(pieces)) {
    Tessellation& tessellation = regular_[pieces[0]];
    if (tessellation.triangles.empty()) tessellation = makeRegular(pieces[0]);
    return tessellation;
  }
  std::size_t index = 0;
  for (const std::uint32_t count : pieces) {
    const auto place = std::lower_bound(pieceCounts.begin(), pieceCounts.end(), count);
    index = index * pieceCounts.size() + static_cast<std::size_t>(place - pieceCounts.begin());
  }
  std::unique_ptr<Tessellation>& tessellation = irregular_[index];
  if (!tessellation) tessellation = std::make_unique<Tessellation>(makeTessellation(pieces));
  return *tessellation;
}

}  // namespace warpjet
