// Triangles of warped samples as a view shows them, four at once.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

#include "detail/four_triangles.hpp"
#include "detail/samples.hpp"

namespace warpjet {

// A view of the mesh. A mesh that is drawn several times in a frame has several views.
struct ScreenView {
  glm::mat4 clip;      // from the space of warped positions to clip space
  glm::vec2 halfSize;  // of the viewport, in pixels
  // 1: triangles that face away are not drawn. -1: triangles that face the eye are not. 0: all are.
  float facing = 0;
};

// Tests whether all of these points in clip space are beyond the same border of the view, which is
// enlarged by the factor `margin`, or all are behind the eye.
Mask areOutside(std::span<const Vec4> clip, float margin);

// Tests whether the view does not draw flat triangles because of the direction that they face:
// whether their signed area on the screen, which is positive if they are drawn, is below minus
// `share` times the product of two of their sides.
Mask areHidden(const ScreenView& view, const std::array<Vec4, 3>& clip, float share);

class TrianglesOnScreen {
 public:
  // Keeps references to both.
  TrianglesOnScreen(const ScreenView& view, const Samples& samples);

  // Returns false for triangles whose samples are all far beyond the same border of the view, or
  // whose cells are all hidden because of the direction that they face.
  Mask areVisible() const;

  // The second differences of samples along the sides of a cell, in pixels.
  std::array<Vec2, 3> secondDifferences(const Cell& cell) const;

  // The largest distance, in pixels, of a sample from the flat triangle between these corners, and
  // between the samples at the corners.
  Lanes errorFrom(const std::array<Vec3, 3>& corners) const;
  Lanes flatError() const;
  // The lengths of the sides between their ends, in pixels.
  std::array<Lanes, 3> sideLengths() const;

 private:
  // The change in clip space from sample 0 to a point. Differences of these have smaller rounding
  // errors than differences of positions.
  Vec4 changeTo(const Vec3& point) const {
    return transformVector(view_.clip, point - samples_[0]);
  }
  // The corners are changes from sample 0.
  Lanes errorFromChanges(const std::array<Vec4, 3>& corners) const;
  // Returns by how many pixels a small change in clip space moves a sample, if that were the
  // nearest.
  Vec2 toPixels(const Vec4& change, int sample) const;

  const ScreenView& view_;
  const Samples& samples_;
  std::array<Vec4, samplesPerTriangle> changes_, clip_;
  // The depth of the nearest sample, and the places of all, in halves of the view from its middle.
  // Both are limited (see criterion.hpp): points behind the eye have no place, and points close to
  // it are almost infinitely far from the middle.
  Lanes depth_;
  std::array<Vec2, samplesPerTriangle> places_;
};

}  // namespace warpjet
