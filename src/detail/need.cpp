#include "detail/need.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "detail/criterion.hpp"
#include "detail/tessellation.hpp"

namespace warpjet {

namespace {

using glm::vec2, glm::vec3, glm::vec4;

// Warped samples of a triangle: row by row from corner 0, which is alone in its row, to the side
// opposite to it, each from the side of corner 1 to that of corner 2.
constexpr int intervals = 4;  // per side
using Samples = std::array<vec3, (intervals + 1) * (intervals + 2) / 2>;
constexpr int sampleAt(int row, int i) { return row * (row + 1) / 2 + i; }

// A part of a triangle with six samples: its corners, and the middles of its sides.
struct Cell {
  std::array<int, 3> corners, middles;
};
constexpr std::array cells = [] {
  std::array<Cell, 6> all{};
  int count = 0;
  for (int row = 0; row <= intervals - 2; ++row) {
    for (int i = 0; i <= row; ++i)
      all[count++] = {{sampleAt(row, i), sampleAt(row + 2, i), sampleAt(row + 2, i + 2)},
                      {sampleAt(row + 1, i), sampleAt(row + 2, i + 1), sampleAt(row + 1, i + 1)}};
  }
  return all;
}();

// A triangle in its plane: corner 0 is the origin, corner 1 on the first axis.
struct Flat {
  float width;  // of corner 1
  vec2 apex;    // corner 2

  Flat(vec3 a, vec3 b, vec3 c) {
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
// the sides alone would miss that of a saddle.
Quadratic bendOf(const Flat& flat, const std::array<vec2, 3>& alongSides) {
  Quadratic sum;
  for (int k = 0; k < 2; ++k) {
    const float first = alongSides[0][k], second = alongSides[1][k], third = alongSides[2][k];
    const float mixed = 0.5f * (first + third - second);
    const auto [x, y] = std::array{flat.apex.x, flat.apex.y};
    const float xx = first / (flat.width * flat.width);
    const float xy = (mixed - xx * flat.width * x) / (flat.width * y);
    const float yy = (third - xx * x * x - 2 * xy * x * y) / (y * y);
    sum.xx += xx * xx + xy * xy;
    sum.xy += xy * (xx + yy);
    sum.yy += xy * xy + yy * yy;
  }
  const float root = std::sqrt(std::max(0.0f, sum.xx * sum.yy - sum.xy * sum.xy));
  const float scale = 1 / std::sqrt(sum.xx + sum.yy + 2 * root);
  return {(sum.xx + root) * scale, sum.xy * scale, (sum.yy + root) * scale};
}

class ScreenOf {
 public:
  ScreenOf(const ScreenView& view, const Samples& samples) : view_(view) {
    for (std::size_t i = 0; i < samples.size(); ++i) clip_[i] = view.clip * vec4(samples[i], 1);
    nearest_ = findNearest();
  }

  // False if all samples are far outside of one side of the view, or hidden since they face away.
  bool isVisible() const {
    const auto areOutside = [&](auto&& isOutside) {
      return std::all_of(clip_.begin(), clip_.end(), isOutside);
    };
    for (int i = 0; i < 2; ++i) {
      if (areOutside([i](vec4 c) { return c[i] > criterion.margin * std::abs(c.w); })) return false;
      if (areOutside([i](vec4 c) { return -c[i] > criterion.margin * std::abs(c.w); }))
        return false;
    }
    if (areOutside([](vec4 c) { return c.w <= 0; })) return false;
    return view_.facing == 0 || !facesAway();
  }

  // The changes on the screen, in pixels, for small changes of the position at the nearest sample.
  vec2 pixels(vec3 change) const {
    const vec4 clip = view_.clip * vec4(change, 0);
    return view_.halfSize * (vec2(clip) - vec2(nearest_) * (clip.w / nearest_.w)) / nearest_.w;
  }

 private:
  // Behind the eye and close to it, positions have no or almost infinite places on the screen.
  vec4 findNearest() const {
    const vec4 middle =
        (clip_[0] + clip_[sampleAt(intervals, 0)] + clip_[sampleAt(intervals, intervals)]) / 3.0f;
    vec4 found =
        *std::min_element(clip_.begin(), clip_.end(), [](vec4 a, vec4 b) { return a.w < b.w; });
    found.w = std::max(found.w, criterion.nearest * std::abs(middle.w));
    const float aside = criterion.aside * found.w;
    for (int i = 0; i < 2; ++i) found[i] = std::clamp(found[i], -aside, aside);
    return found;
  }

  // Tests whether all cells face away, clearly enough that what is between the samples does, too.
  bool facesAway() const {
    return std::all_of(cells.begin(), cells.end(), [&](const Cell& cell) {
      std::array<vec2, 3> screen;
      for (int i = 0; i < 3; ++i) {
        const vec4 clip = clip_[cell.corners[i]];
        if (clip.w <= 0) return false;
        screen[i] = view_.halfSize * vec2(clip) / clip.w;
      }
      const vec2 u = screen[1] - screen[0], v = screen[2] - screen[0];
      const float area = view_.facing * (u.x * v.y - u.y * v.x);
      return area < -criterion.away * glm::length(u) * glm::length(v);
    });
  }

  const ScreenView& view_;
  std::array<vec4, std::tuple_size_v<Samples>> clip_;
  vec4 nearest_;
};

// The sides of a triangle in its plane, and those of the triangle that its patch is a part of.
using Directions = std::array<vec2, 6>;

Directions directionsOf(const Flat& flat, const Patch* patch) {
  const vec2 first(flat.width, 0), second = flat.apex;
  Directions directions{first, second - first, second};
  if (!patch) return directions;
  // The patch has two sides at its first corner, by the weights of the corners 1 and 2 that they
  // add; the whole triangle has the sides (1, 0), (-1, 1) and (0, 1).
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

using Squares = std::array<float, std::tuple_size_v<Directions>>;

// The squares of the numbers of pieces that lines in these directions need, for an error of one
// pixel.
Squares squaredNeeds(const Flat& flat, const Directions& directions, const ScreenOf& screen,
                     const Samples& samples) {
  Squares max{}, sum{};
  for (const Cell& cell : cells) {
    std::array<vec2, 3> alongSides;
    for (int i = 0; i < 3; ++i) {
      const vec3 bend = samples[cell.corners[i]] + samples[cell.corners[(i + 1) % 3]] -
                        2.0f * samples[cell.middles[i]];
      alongSides[i] = screen.pixels(static_cast<float>(intervals * intervals) * bend);
    }
    const Quadratic bend = bendOf(flat, alongSides);
    // A flat cell has no bend, but NaN: a root of zero divided by zero.
    if (!std::isfinite(bend.xx + bend.xy + bend.yy)) continue;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const float along = bend.along(directions[i]);
      max[i] = std::max(max[i], along);
      sum[i] += along;
    }
  }
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const float mean = sum[i] / static_cast<float>(cells.size());
    max[i] = (max[i] + criterion.beyondCells * (max[i] - mean)) * criterion.error;
  }
  return max;
}

// Reads the warped samples of a triangle.
Samples samplesOf(const BaseMesh& base, std::size_t triangle, std::span<const float> warped) {
  const auto read = [&](std::uint32_t sample) {
    return vec3(warped[3 * sample], warped[3 * sample + 1], warped[3 * sample + 2]);
  };
  const Corners& corners = base.triangles()[triangle];
  Samples samples;
  samples[0] = read(corners[0]);
  samples[sampleAt(intervals, 0)] = read(corners[1]);
  samples[sampleAt(intervals, intervals)] = read(corners[2]);
  for (int k = 1; k < intervals; ++k) {
    const std::array places{sampleAt(k, 0), sampleAt(intervals, k),
                            sampleAt(intervals - k, intervals - k)};
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t side = base.sidesOf(triangle)[i];
      const int indexOnSide = base.startsAt(side, corners[i]) ? k - 1 : intervals - 1 - k;
      samples[places[i]] = read(base.sampleOfSide(side, indexOnSide));
    }
  }
  samples[sampleAt(2, 1)] = read(base.sampleOfTriangle(triangle, 0));
  samples[sampleAt(3, 1)] = read(base.sampleOfTriangle(triangle, 1));
  samples[sampleAt(3, 2)] = read(base.sampleOfTriangle(triangle, 2));
  return samples;
}

}  // namespace

std::uint32_t roundUp(float need) {
  const auto found = std::find_if(pieceCounts.begin(), pieceCounts.end(), [&](std::uint32_t count) {
    return static_cast<float>(count) >= need;
  });
  return found == pieceCounts.end() ? maxPieces : *found;
}

bool Needs::update(const BaseMesh& base, std::span<const Patch> patches,
                   std::span<const float> warped, std::span<const ScreenView> views,
                   float tolerance) {
  const auto place = [&](std::uint32_t vertex) {
    const float* p = base.attributes()[0].values.data() + 3 * vertex;
    return vec3(p[0], p[1], p[2]);
  };
  needs_.assign(base.edgeCount(), 0);
  float uniform = 0;
  pieces_.resize(base.edgeCount(), 1);
  for (std::size_t t = 0; t < base.triangles().size(); ++t) {
    const auto [a, b, c] = base.triangles()[t];
    const Flat flat(place(a), place(b), place(c));
    const Directions directions = directionsOf(flat, patches.empty() ? nullptr : &patches[t]);
    const Samples samples = samplesOf(base, t, warped);
    for (const ScreenView& view : views) {
      const ScreenOf screen(view, samples);
      if (!screen.isVisible()) continue;
      const Squares squares = squaredNeeds(flat, directions, screen, samples);
      for (int i = 0; i < 3; ++i) {
        float& need = needs_[base.edgeOf(t, i)];
        need = std::max(need, squares[i] / (criterion.aim * tolerance));
        uniform = std::max(uniform, squares[3 + i] / tolerance);
      }
    }
  }
  uniform_ = std::sqrt(uniform);
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
