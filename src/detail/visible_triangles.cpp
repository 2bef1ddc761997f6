#include "detail/visible_triangles.hpp"

#include <algorithm>
#include <array>

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
  const std::size_t count = base.triangles().size();
  for (std::size_t first = 0; first < count; first += Lanes::count) {
    const auto triangleAt = [&](std::size_t lane) -> const Corners& {
      return base.triangles()[std::min(first + lane, count - 1)];
    };
    std::array<Vec4, 3> corners;
    for (int i = 0; i < 3; ++i) {
      const auto at = [&](std::size_t lane) { return &clip_[triangleAt(lane)[i]][0]; };
      const std::array<const float*, Lanes::count> clip{at(0), at(1), at(2), at(3)};
      for (int k = 0; k < 4; ++k) corners[i][k] = gather(clip, k);
    }
    const Mask areShown = logicalNot(logicalOr(areOutside(corners, criterion.flatMargin),
                                               areHidden(view, corners, criterion.flatAway)));
    for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
      if (areShown.bits[lane] == 0) continue;
      for (const std::uint32_t vertex : triangleAt(lane)) isMarked_[base.placeOf(vertex)] = true;
    }
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
