#include "detail/visible_triangles.hpp"

#include <algorithm>

#include "detail/criterion.hpp"

namespace warpjet {

const std::vector<std::uint32_t>& VisibleTriangles::add(const BaseMesh& base,
                                                        std::span<const float> warped,
                                                        std::span<const ScreenView> views,
                                                        bool listsSamples) {
  if (triangles_.empty()) {
    isAdded_.assign(base.triangles().size(), false);
    hasSamples_.assign(base.sides().size(), false);
  }
  isMarked_.assign(base.vertexCount(), false);
  for (const ScreenView& view : views) markCorners(base, warped, view);
  samples_.clear();
  for (std::uint32_t t = 0; t < base.triangles().size(); ++t) {
    const Corners& corners = base.triangles()[t];
    const bool mayBeShown = std::any_of(corners.begin(), corners.end(), [&](std::uint32_t vertex) {
      return isMarked_[base.placeOf(vertex)];
    });
    if (!mayBeShown || isAdded_[t]) continue;
    isAdded_[t] = true;
    triangles_.push_back(t);
    if (listsSamples) listSamples(base, t);
  }
  return samples_;
}

// Marks the corners of all triangles that the view would show if they were flat.
void VisibleTriangles::markCorners(const BaseMesh& base, std::span<const float> warped,
                                   const ScreenView& view) {
  clip_.clear();
  for (std::size_t i = 0; i < 3 * base.vertexCount(); i += 3)
    clip_.push_back(view.clip * glm::vec4(warped[i], warped[i + 1], warped[i + 2], 1));
  for (const auto& [a, b, c] : base.triangles()) {
    const std::array corners{clip_[a], clip_[b], clip_[c]};
    if (areOutside(corners, criterion.flatMargin)) continue;
    if (isHidden(view, corners, criterion.flatAway)) continue;
    for (const std::uint32_t vertex : {a, b, c}) isMarked_[base.placeOf(vertex)] = true;
  }
}

void VisibleTriangles::listSamples(const BaseMesh& base, std::uint32_t triangle) {
  const auto addThree = [this](std::uint32_t first) {
    for (std::uint32_t i = 0; i < 3; ++i) samples_.push_back(first + i);
  };
  for (const std::uint32_t side : base.sidesOf(triangle)) {
    if (!hasSamples_[side]) addThree(base.sampleOfSide(side, 0));
    hasSamples_[side] = true;
  }
  addThree(base.sampleOfTriangle(triangle, 0));
}

}  // namespace warpjet
