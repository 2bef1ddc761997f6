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
  Vec4 findNearest() const;
  Vec2 toScreen(const Vec3& change) const {
    return jacobian_[0] * change.x + jacobian_[1] * change.y + jacobian_[2] * change.z;
  }

  const ScreenView& view_;
  const Samples& samples_;
  std::array<Vec4, samplesPerTriangle> clip_;
  // The columns of the Jacobian of the position on the screen, in pixels, at the nearest sample.
  std::array<Vec2, 3> jacobian_;
};

}  // namespace warpjet
