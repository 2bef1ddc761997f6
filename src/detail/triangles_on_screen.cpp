#include "detail/triangles_on_screen.hpp"

#include <cstddef>

#include "detail/criterion.hpp"

namespace warpjet {

namespace {

Vec2 select(Mask where, const Vec2& yes, const Vec2& no) {
  return {ifElse(where, yes.x, no.x), ifElse(where, yes.y, no.y)};
}

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
  for (std::size_t i = 0; i < samples.size(); ++i) clip_[i] = transform(view.clip, samples[i]);
  // A position on the screen is halfSize * xy / w.
  const Vec4 nearest = findNearest();
  const Vec2 place = Vec2(nearest) / nearest.w;
  for (int k = 0; k < 3; ++k) {
    const glm::vec4& change = view.clip[k];
    const Vec2 moved(change.x - place.x * change.w, change.y - place.y * change.w);
    jacobian_[k] = scaleToPixels(view, moved / nearest.w);
  }
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

std::array<Vec2, 3> TrianglesOnScreen::secondDifferences(const Cell& cell) const {
  std::array<Vec2, 3> differences;
  for (int i = 0; i < 3; ++i)
    differences[i] = toScreen(samples_[cell.corners[i]] + samples_[cell.corners[(i + 1) % 3]] -
                              Lanes(2.0f) * samples_[cell.middles[i]]);
  return differences;
}

Lanes TrianglesOnScreen::errorFrom(const std::array<Vec3, 3>& corners) const {
  const Lanes scale = 1.0f / sampleIntervals;
  const Vec3 toFirst = (corners[1] - corners[0]) * scale;
  const Vec3 toSecond = (corners[2] - corners[0]) * scale;
  Lanes maxSquare = 0.0f;
  for (int row = 0; row <= sampleIntervals; ++row) {
    for (int i = 0; i <= row; ++i) {
      const Vec3 flat = corners[0] + toFirst * Lanes(static_cast<float>(row - i)) +
                        toSecond * Lanes(static_cast<float>(i));
      const Vec2 error = toScreen(samples_[sampleAt(row, i)] - flat);
      maxSquare = max(maxSquare, dot(error, error));
    }
  }
  return sqrt(maxSquare);
}

Lanes TrianglesOnScreen::flatError() const {
  return errorFrom(
      {samples_[cornerSamples[0]], samples_[cornerSamples[1]], samples_[cornerSamples[2]]});
}

std::array<Lanes, 3> TrianglesOnScreen::sideLengths() const {
  std::array<Lanes, 3> lengths;
  for (int i = 0; i < 3; ++i) {
    const Vec2 side = toScreen(samples_[cornerSamples[(i + 1) % 3]] - samples_[cornerSamples[i]]);
    lengths[i] = sqrt(dot(side, side));
  }
  return lengths;
}

// Limits the depth and the distance from the middle: points behind the eye have no position on the
// screen, and points close to it an almost infinite one.
Vec4 TrianglesOnScreen::findNearest() const {
  const auto [a, b, c] = cornerSamples;
  const Lanes middle = (clip_[a].w + clip_[b].w + clip_[c].w) / 3.0f;
  Lanes depth = clip_[0].w;
  Vec2 place(clip_[0]);
  for (const Vec4& point : clip_) {
    const Mask isNearer = lt(point.w, depth);
    depth = ifElse(isNearer, point.w, depth);
    place = select(isNearer, Vec2(point), place);
  }
  depth = max(depth, criterion.nearest * abs(middle));
  const Lanes aside = criterion.aside * depth;
  return {clamp(place.x, -aside, aside), clamp(place.y, -aside, aside), 0.0f, depth};
}

}  // namespace warpjet
