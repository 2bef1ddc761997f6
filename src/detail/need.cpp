#include "detail/need.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "detail/criterion.hpp"
#include "detail/tessellation.hpp"

namespace warpjet {

namespace {

using glm::vec2, glm::vec3;

// A triangle in its plane: corner 0 is the origin, corner 1 on the first axis.
struct PlanarTriangle {
  float width;  // the first coordinate of corner 1
  vec2 apex;    // corner 2

  PlanarTriangle(vec3 a, vec3 b, vec3 c) {
    const vec3 u = b - a, v = c - a;
    width = glm::length(u);
    apex.x = dot(u, v) / width;
    const float lowest = criterion.lowest * std::sqrt(dot(u, u) + dot(v, v));
    apex.y = std::max(lowest, std::sqrt(std::max(0.0f, dot(v, v) - apex.x * apex.x)));
  }
};

// The symmetric matrix ((xx, xy), (xy, yy)).
struct Quadratic {
  float xx = 0, xy = 0, yy = 0;

  float along(vec2 v) const { return xx * v.x * v.x + 2 * xy * v.x * v.y + yy * v.y * v.y; }
};

// Returns M such that e' M e bounds the second derivative along e. M is the root of the sum of the
// squared Hessians of x and y on the screen, in the plane of the triangle. Second derivatives along
// the sides alone would miss the bend of a saddle.
Quadratic bendOf(const PlanarTriangle& triangle, const std::array<vec2, 3>& alongSides) {
  Quadratic sum;
  for (int k = 0; k < 2; ++k) {
    const float first = alongSides[0][k], second = alongSides[1][k], third = alongSides[2][k];
    const float mixed = 0.5f * (first + third - second);
    const auto [x, y] = std::array{triangle.apex.x, triangle.apex.y};
    const float xx = first / (triangle.width * triangle.width);
    const float xy = (mixed - xx * triangle.width * x) / (triangle.width * y);
    const float yy = (third - xx * x * x - 2 * xy * x * y) / (y * y);
    sum.xx += xx * xx + xy * xy;
    sum.xy += xy * (xx + yy);
    sum.yy += xy * xy + yy * yy;
  }
  const float root = std::sqrt(std::max(0.0f, sum.xx * sum.yy - sum.xy * sum.xy));
  const float scale = 1 / std::sqrt(sum.xx + sum.yy + 2 * root);
  return {(sum.xx + root) * scale, sum.xy * scale, (sum.yy + root) * scale};
}

// The sides of a triangle in its plane, then those of the given triangle that its patch is a part
// of.
using Directions = std::array<vec2, 6>;

Directions directionsOf(const PlanarTriangle& triangle, const Patch* patch) {
  const vec2 first(triangle.width, 0), second = triangle.apex;
  Directions directions{first, second - first, second};
  if (!patch) return directions;
  // u and v are the sides of the patch at its first corner, as changes of the weights of corners 1
  // and 2 of the given triangle, whose sides are (1, 0), (-1, 1) and (0, 1) in these coordinates.
  const auto& [a, b, c] = patch->corners;
  const vec2 u(b[1] - a[1], b[2] - a[2]), v(c[1] - a[1], c[2] - a[2]);
  const float area = u.x * v.y - u.y * v.x;
  const vec2 wholeFirst = (v.y * first - u.y * second) / area;
  const vec2 wholeSecond = (u.x * second - v.x * first) / area;
  directions[3] = wholeFirst;
  directions[4] = wholeSecond - wholeFirst;
  directions[5] = wholeSecond;
  return directions;
}

// Returns the error of a flat triangle, whose sides have these squares in the metric of its bend:
// half of the squared radius of the smallest circle around it. That is the circle through its
// corners, unless an angle is obtuse.
float errorOf(float a, float b, float c) {
  const float longest = std::max({a, b, c});
  const float others = a + b + c - longest;
  if (others <= longest) return longest / 8;
  const float squaredArea = 4 * (a * b + b * c + c * a) - (a + b + c) * (a + b + c);  // times 16
  return a * b * c / squaredArea / 2;
}

// The needs of a triangle for an error of one pixel.
struct TriangleNeeds {
  // The squares of the numbers of pieces of its sides.
  SquaredSides sides{};
  // The square of the number of pieces per side, if all sides of the given mesh have the same.
  float uniform = 0;
};

TriangleNeeds needsOf(const PlanarTriangle& triangle, const Directions& directions,
                      const TriangleOnScreen& screen) {
  SquaredSides sum{};
  TriangleNeeds needs;
  for (const Cell& cell : cells) {
    std::array<vec2, 3> alongSides = screen.secondDifferences(cell);
    for (vec2& along : alongSides) along *= float{sampleIntervals * sampleIntervals};
    const Quadratic bend = bendOf(triangle, alongSides);
    // A flat cell has no bend, but NaN: a root of zero divided by zero.
    if (!std::isfinite(bend.xx + bend.xy + bend.yy)) continue;
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const float along = bend.along(directions[i]);
      needs.sides[i] = std::max(needs.sides[i], along);
      sum[i] += along;
    }
    needs.uniform = std::max(
        needs.uniform,
        errorOf(bend.along(directions[3]), bend.along(directions[4]), bend.along(directions[5])));
  }
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const float max = needs.sides[i], mean = sum[i] / static_cast<float>(cells.size());
    needs.sides[i] = (max + criterion.beyondCells * (max - mean)) * criterion.error;
  }
  return needs;
}

}  // namespace

std::uint32_t roundUp(float need) {
  const auto found = std::find_if(pieceCounts.begin(), pieceCounts.end(), [&](std::uint32_t count) {
    return static_cast<float>(count) >= need;
  });
  return found == pieceCounts.end() ? maxPieces : *found;
}

bool Needs::update(const WarpedMesh& mesh, std::span<const ScreenView> views, float tolerance) {
  const BaseMesh& base = mesh.base;
  const std::span<const Patch> patches = mesh.patches;
  const auto place = [&](std::uint32_t vertex) {
    const float* p = base.attributes()[0].values.data() + 3 * vertex;
    return vec3(p[0], p[1], p[2]);
  };
  const float aim = criterion.aim * tolerance;
  needs_.assign(base.edgeCount(), 0);
  float squaredUniformNeed = 0;
  squaredSides_.assign(base.triangles().size(), {});
  pieces_.resize(base.edgeCount(), 1);
  for (const std::uint32_t t : mesh.triangles) {
    const Samples samples = samplesOf(base, t, mesh.warped);
    const auto raise = [&](int side, float squaredNeed) {
      float& need = needs_[base.edgeOf(t, side)];
      need = std::max(need, squaredNeed);
    };
    for (const ScreenView& view : views) {
      const TriangleOnScreen screen(view, samples);
      if (!screen.isVisible()) continue;
      // A triangle within which the surface bends back and forth can be close to all samples,
      // although the bends ask for pieces.
      const float errorShare = screen.flatError() * criterion.beyondFlat / aim;
      const bool isFine = errorShare <= 1;
      if (isFine) {
        for (int i = 0; i < 3; ++i) raise(i, errorShare);
        if (patches.empty()) continue;
      }
      const auto [a, b, c] = base.triangles()[t];
      const PlanarTriangle planar(place(a), place(b), place(c));
      const TriangleNeeds needs =
          needsOf(planar, directionsOf(planar, patches.empty() ? nullptr : &patches[t]), screen);
      // All triangles have samples, and the worst one decides, so no margin like `aim` is needed.
      squaredUniformNeed = std::max(squaredUniformNeed, needs.uniform / tolerance);
      for (int i = 0; i < 3 && !isFine; ++i) {
        raise(i, needs.sides[i] / aim);
        squaredSides_[t][i] = std::max(squaredSides_[t][i], needs.sides[i]);
      }
    }
  }
  uniformNeed_ = std::sqrt(squaredUniformNeed);
  bool isChanged = false;
  for (std::size_t edge = 0; edge < needs_.size(); ++edge) {
    const float need = std::sqrt(needs_[edge]);
    const std::uint32_t next =
        std::clamp(pieces_[edge], roundUp(need), roundUp(need * criterion.hysteresis));
    isChanged |= next != pieces_[edge];
    pieces_[edge] = next;
  }
  return isChanged;
}

}  // namespace warpjet
