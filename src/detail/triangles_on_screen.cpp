#include "detail/triangles_on_screen.hpp"

#include <cstddef>

#include "detail/criterion.hpp"

namespace warpjet {

namespace {

Vec2 scaleToPixels(const ScreenView& view, const Vec2& v) {
  return {v.x * view.halfSize.x, v.y * view.halfSize.y};
}

Lanes clamp(Lanes x, Lanes low, Lanes high) { return min(max(x, low), high); }

}  // namespace

Mask areOutside(std::span<const Vec4> clip, float margin) {
  Mask behind = le(clip[0].w, 0.0f);
  std::array<Mask, 4> beyond;
  for (std::size_t i = 0; i < clip.size(); ++i) {
    const Vec4& c = clip[i];
    const Lanes limit = margin * abs(c.w);
    const std::array<Mask, 4> is{gt(c.x, limit), gt(-c.x, limit), gt(c.y, limit), gt(-c.y, limit)};
    for (std::size_t k = 0; k < beyond.size(); ++k)
      beyond[k] = i == 0 ? is[k] : logicalAnd(beyond[k], is[k]);
    behind = logicalAnd(behind, le(c.w, 0.0f));
  }
  const Mask beyondX = logicalOr(beyond[0], beyond[1]), beyondY = logicalOr(beyond[2], beyond[3]);
  return logicalOr(behind, logicalOr(beyondX, beyondY));
}

Mask areHidden(const ScreenView& view, const std::array<Vec4, 3>& clip, float share) {
  if (view.facing == 0) return Mask{};
  Mask inFront = gt(clip[0].w, 0.0f);
  std::array<Vec2, 3> screen;
  for (int i = 0; i < 3; ++i) {
    inFront = logicalAnd(inFront, gt(clip[i].w, 0.0f));
    screen[i] = scaleToPixels(view, Vec2(clip[i]) / clip[i].w);
  }
  const Vec2 u = screen[1] - screen[0], v = screen[2] - screen[0];
  const Lanes area = view.facing * (u.x * v.y - u.y * v.x);
  return logicalAnd(inFront, lt(area, -share * sqrt(dot(u, u) * dot(v, v))));
}

TrianglesOnScreen::TrianglesOnScreen(const ScreenView& view, const Samples& samples)
    : view_(view), samples_(samples) {
  const Vec4 first = transformPoint(view.clip, samples[0]);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    changes_[i] = changeTo(samples[i]);
    clip_[i] = first + changes_[i];
  }
  const auto [a, b, c] = cornerSamples;
  const Lanes minDepth =
      criterion.nearest * max(max(abs(clip_[a].w), abs(clip_[b].w)), abs(clip_[c].w));
  depth_ = clip_[a].w;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    depth_ = min(depth_, clip_[i].w);
    const Vec2 place = Vec2(clip_[i]) / max(clip_[i].w, minDepth);
    const Lanes aside = criterion.aside;
    places_[i] = {clamp(place.x, -aside, aside), clamp(place.y, -aside, aside)};
  }
  depth_ = max(depth_, minDepth);
}

// Tests whether any cell is drawn, or almost drawn: then the surface between its samples may be.
Mask TrianglesOnScreen::areVisible() const {
  const Mask outside = areOutside(clip_, criterion.margin);
  if (view_.facing == 0) return logicalNot(outside);
  Mask isDrawn{};
  for (const Cell& cell : cells) {
    const auto [a, b, c] = cell.corners;
    const Mask hidden = areHidden(view_, {clip_[a], clip_[b], clip_[c]}, criterion.away);
    isDrawn = logicalOr(isDrawn, logicalNot(hidden));
  }
  return logicalAnd(isDrawn, logicalNot(outside));
}

// A place on the screen is halfSize * xy / w.
Vec2 TrianglesOnScreen::toPixels(const Vec4& change, int sample) const {
  return scaleToPixels(view_, (Vec2(change) - places_[sample] * change.w) / depth_);
}

std::array<Vec2, 3> TrianglesOnScreen::secondDifferences(const Cell& cell) const {
  const auto& [corners, middles] = cell;
  std::array<Vec2, 3> differences;
  for (int i = 0; i < 3; ++i) {
    const Vec4 change =
        changes_[corners[i]] + changes_[corners[(i + 1) % 3]] - changes_[middles[i]] * Lanes(2.0f);
    differences[i] = toPixels(change, middles[i]);
  }
  return differences;
}

Lanes TrianglesOnScreen::errorFrom(const std::array<Vec3, 3>& corners) const {
  return errorFromChanges({changeTo(corners[0]), changeTo(corners[1]), changeTo(corners[2])});
}

Lanes TrianglesOnScreen::flatError() const {
  const auto [a, b, c] = cornerSamples;
  return errorFromChanges({changes_[a], changes_[b], changes_[c]});
}

Lanes TrianglesOnScreen::errorFromChanges(const std::array<Vec4, 3>& corners) const {
  const Lanes scale = 1.0f / sampleIntervals;
  const Vec4 toFirst = (corners[1] - corners[0]) * scale;
  const Vec4 toSecond = (corners[2] - corners[0]) * scale;
  Lanes maxSquare = 0.0f;
  for (int row = 0; row <= sampleIntervals; ++row) {
    for (int i = 0; i <= row; ++i) {
      const int sample = sampleAt(row, i);
      const Vec4 flat = corners[0] + toFirst * Lanes(static_cast<float>(row - i)) +
                        toSecond * Lanes(static_cast<float>(i));
      const Vec2 error = toPixels(changes_[sample] - flat, sample);
      maxSquare = max(maxSquare, dot(error, error));
    }
  }
  return sqrt(maxSquare);
}

std::array<Lanes, 3> TrianglesOnScreen::sideLengths() const {
  std::array<Lanes, 3> lengths;
  for (int i = 0; i < 3; ++i) {
    const Vec2 side =
        scaleToPixels(view_, places_[cornerSamples[(i + 1) % 3]] - places_[cornerSamples[i]]);
    lengths[i] = sqrt(dot(side, side));
  }
  return lengths;
}

}  // namespace warpjet
