// A triangle of warped samples as a view shows it.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

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
bool areOutside(std::span<const glm::vec4> clip, float margin);

// Tests whether the view does not draw a flat triangle because of the direction that it faces:
// whether its signed area on the screen, which is positive if it is drawn, is below minus `share`
// times the product of two of its sides.
bool isHidden(const ScreenView& view, const std::array<glm::vec4, 3>& clip, float share);

class TriangleOnScreen {
 public:
  // Keeps references to both.
  TriangleOnScreen(const ScreenView& view, const Samples& samples);

  // Returns false if all samples are far beyond the same border of the view, or if all cells are
  // hidden because of the direction that they face.
  bool isVisible() const;

  // The second differences of samples along the sides of a cell, in pixels.
  std::array<glm::vec2, 3> secondDifferences(const Cell& cell) const;

  // The largest distance, in pixels, of a sample from the flat triangle between the corners.
  float flatError() const;

 private:
  glm::vec4 findNearest() const;

  const ScreenView& view_;
  const Samples& samples_;
  std::array<glm::vec4, samplesPerTriangle> clip_;
  // The Jacobian of the position on the screen, in pixels, at the nearest sample.
  glm::mat3x2 jacobian_;
};

}  // namespace warpjet
