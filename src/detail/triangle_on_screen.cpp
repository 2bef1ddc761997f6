#include "detail/triangle_on_screen.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "detail/criterion.hpp"

namespace warpjet {

using glm::vec2, glm::vec3, glm::vec4;

bool areOutside(std::span<const vec4> clip, float margin) {
  const auto areAll = [&](auto&& isOutside) {
    return std::all_of(clip.begin(), clip.end(), isOutside);
  };
  for (int i = 0; i < 2; ++i) {
    if (areAll([=](vec4 c) { return c[i] > margin * std::abs(c.w); })) return true;
    if (areAll([=](vec4 c) { return -c[i] > margin * std::abs(c.w); })) return true;
  }
  return areAll([](vec4 c) { return c.w <= 0; });
}

bool isHidden(const ScreenView& view, const std::array<vec4, 3>& clip, float share) {
  if (view.facing == 0) return false;
  std::array<vec2, 3> screen;
  for (int i = 0; i < 3; ++i) {
    if (clip[i].w <= 0) return false;
    screen[i] = view.halfSize * vec2(clip[i]) / clip[i].w;
  }
  const vec2 u = screen[1] - screen[0], v = screen[2] - screen[0];
  const float area = view.facing * (u.x * v.y - u.y * v.x);
  return area < -share * glm::length(u) * glm::length(v);
}

TriangleOnScreen::TriangleOnScreen(const ScreenView& view, const Samples& samples)
    : view_(view), samples_(samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) clip_[i] = view.clip * vec4(samples[i], 1);
  // A position on the screen is halfSize * xy / w.
  const vec4 nearest = findNearest();
  for (int k = 0; k < 3; ++k) {
    const vec4 change = view.clip[k];
    jacobian_[k] =
        view.halfSize * (vec2(change) - vec2(nearest) * (change.w / nearest.w)) / nearest.w;
  }
}

// Tests whether any cell is drawn, or almost drawn: then the surface between its samples may be.
bool TriangleOnScreen::isVisible() const {
  if (areOutside(clip_, criterion.margin)) return false;
  return std::any_of(cells.begin(), cells.end(), [&](const Cell& cell) {
    const auto [a, b, c] = cell.corners;
    return !isHidden(view_, {clip_[a], clip_[b], clip_[c]}, criterion.away);
  });
}

std::array<vec2, 3> TriangleOnScreen::secondDifferences(const Cell& cell) const {
  std::array<vec2, 3> differences;
  for (int i = 0; i < 3; ++i)
    differences[i] = jacobian_ * (samples_[cell.corners[i]] + samples_[cell.corners[(i + 1) % 3]] -
                                  2.0f * samples_[cell.middles[i]]);
  return differences;
}

float TriangleOnScreen::flatError() const {
  const vec3 start = samples_[cornerSamples[0]];
  const vec3 toFirst = (samples_[cornerSamples[1]] - start) / float{sampleIntervals};
  const vec3 toSecond = (samples_[cornerSamples[2]] - start) / float{sampleIntervals};
  float maxSquare = 0;
  for (int row = 1; row <= sampleIntervals; ++row) {
    for (int i = 0; i <= row; ++i) {
      const vec3 flat =
          start + static_cast<float>(row - i) * toFirst + static_cast<float>(i) * toSecond;
      const vec2 error = jacobian_ * (samples_[sampleAt(row, i)] - flat);
      maxSquare = std::max(maxSquare, dot(error, error));
    }
  }
  return std::sqrt(maxSquare);
}

// Limits the depth and the distance from the middle: points behind the eye have no position on the
// screen, and points close to it an almost infinite one.
vec4 TriangleOnScreen::findNearest() const {
  const auto [a, b, c] = cornerSamples;
  const vec4 middle = (clip_[a] + clip_[b] + clip_[c]) / 3.0f;
  vec4 found =
      *std::min_element(clip_.begin(), clip_.end(), [](vec4 p, vec4 q) { return p.w < q.w; });
  found.w = std::max(found.w, criterion.nearest * std::abs(middle.w));
  const float aside = criterion.aside * found.w;
  for (int i = 0; i < 2; ++i) found[i] = std::clamp(found[i], -aside, aside);
  return found;
}

}  // namespace warpjet
