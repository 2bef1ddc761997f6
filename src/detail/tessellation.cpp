#include "detail/tessellation.hpp"

#include <algorithm>
#include <cmath>

namespace warpjet {

namespace {

using glm::dvec2, glm::dvec3;

// Returns lengths of sides that are those numbers, or nearly, if these contradict the triangle
// inequality: the two shorter sides grow until they exceed the longest one by 2%.
dvec3 lengthsOf(const SidePieces& pieces, int longest) {
  dvec3 lengths(pieces[0], pieces[1], pieces[2]);
  double& next = lengths[(longest + 1) % 3];
  double& last = lengths[(longest + 2) % 3];
  const double growth = 1.02 * lengths[longest] / (next + last);
  if (growth > 1) {
    next *= growth;
    last *= growth;
  }
  return lengths;
}

// Places the corners such that the sides have these lengths, counterclockwise.
std::array<dvec2, 3> cornersFor(const dvec3& lengths) {
  const double base = lengths[0], right = lengths[1], left = lengths[2];
  const double x = (base * base + left * left - right * right) / (2 * base);
  return {dvec2(0), dvec2(base, 0), dvec2(x, std::sqrt(std::max(0.0, left * left - x * x)))};
}

// Lists the weights of inner points in rows parallel to the longest side.
std::vector<dvec3> rowsOfPoints(const dvec3& lengths, double height, int longest) {
  std::vector<dvec3> points;
  const double heightOfRow = std::sqrt(0.75);
  const int rows = static_cast<int>(std::lround(height / heightOfRow));
  for (int row = 1; row < rows; ++row) {
    const double up = static_cast<double>(row) / rows;
    const double width = lengths[longest] * (1 - up);
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

}  // namespace

Tessellation makeTessellation(const SidePieces& pieces) {
  const int longest =
      static_cast<int>(std::max_element(pieces.begin(), pieces.end()) - pieces.begin());
  const dvec3 lengths = lengthsOf(pieces, longest);
  const std::array<dvec2, 3> corners = cornersFor(lengths);
  const double height = corners[2].y * lengths[0] / lengths[longest];

  // The sides bulge a little, so that their points are the corners of a convex polygon.
  std::vector<dvec2> points;
  for (int side = 0; side < 3; ++side) {
    const dvec2 start = corners[side], along = corners[(side + 1) % 3] - start;
    const dvec2 outward = dvec2(along.y, -along.x) / lengths[side];
    for (std::uint32_t i = 0; i < pieces[side]; ++i) {
      const double t = static_cast<double>(i) / pieces[side];
      const double bulge = 0.08 * t * (1 - t) * std::min(1.0, height);
      points.push_back(start + along * t + outward * bulge);
    }
  }
  const std::size_t hull = points.size();
  Tessellation tessellation;
  for (const dvec3& w : rowsOfPoints(lengths, height, longest)) {
    points.push_back(corners[0] * w[0] + corners[1] * w[1] + corners[2] * w[2]);
    tessellation.inner.push_back(
        {static_cast<float>(w[0]), static_cast<float>(w[1]), static_cast<float>(w[2])});
  }
  tessellation.triangles = triangulate(points, hull);
  return tessellation;
}

const Tessellation& Tessellations::of(const SidePieces& pieces) {
  std::size_t number = 0;
  for (const std::uint32_t count : pieces) {
    const auto place = std::lower_bound(pieceCounts.begin(), pieceCounts.end(), count);
    number = number * pieceCounts.size() + static_cast<std::size_t>(place - pieceCounts.begin());
  }
  Tessellation& tessellation = made_[number];
  if (tessellation.triangles.empty()) tessellation = makeTessellation(pieces);
  return tessellation;
}

}  // namespace warpjet
