// A triangle of warped samples as a view shows it.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

#include "detail/samples.hpp"

namespace warpjet {

// A view of the mesh. If it is drawn several times in a frame, there are several.
struct ScreenView {
  glm::mat4 clip;      // from the space of warped positions to clip space
  glm::vec2 halfSize;  // of the viewport, in pixels
  // 1: triangles that face away are not drawn. -1: triangles that face the eye are not. 0: all are.
  float facing = 0;
};

// Tests whether all of these places in clip space are outside of one side of the view, times a
// margin, or behind the eye.
bool areOutside(std::span<const glm::vec4> clip, float margin);

// Tests whether the view does not draw a flat triangle since it faces away, or the eye: whether its
// signed area on the screen is below minus this share of its sides.
bool isHidden(const ScreenView& view, const std::array<glm::vec4, 3>& clip, float share);

class TriangleOnScreen {
 public:
  // Keeps references to both.
  TriangleOnScreen(const ScreenView& view, const Samples& samples);

  // False if all samples are far outside of one side of the view, or hidden since they face away.
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
  // The Jacobian of the place on the screen, in pixels, at the nearest sample.
  glm::mat3x2 jacobian_;
};

}  // namespace warpjet
