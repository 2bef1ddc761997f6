// Helpers for the tests of detail.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "detail/detail.hpp"

namespace warpjet {

// Looks along -x such that y and z are across the screen, with 100 pixels per unit.
inline ScreenView viewAlongX() {
  ScreenView view{};
  view.clip = glm::mat4(0);
  view.clip[1][0] = view.clip[2][1] = view.clip[3][3] = 1;
  view.halfSize = {100, 100};
  return view;
}

// Moves all samples by `warp`.
template <class F>
void warpSamples(Detail& detail, F&& warp) {
  detail.warped() = detail.samples()[0].values;
  for (std::size_t i = 0; i < detail.warped().size(); i += 3) warp(&detail.warped()[i]);
  detail.forgetSamples();
}

// Returns the samples that the view shows for the first time.
inline std::vector<std::uint32_t> show(Detail& detail, const ScreenView& view) {
  std::vector<float>& numbers = detail.viewNumbers();
  numbers.clear();
  for (int i = 0; i < 16; ++i) numbers.push_back(view.clip[i / 4][i % 4]);
  numbers.insert(numbers.end(), {view.halfSize.x, view.halfSize.y, view.facing});
  return detail.show();
}

// Moves the samples by `warp`, and divides the mesh for `viewAlongX` and a tolerance of a pixel.
template <class F>
bool divide(Detail& detail, F&& warp) {
  warpSamples(detail, warp);
  show(detail, viewAlongX());
  return detail.update(1);
}

// A hill around (1, 0, 0), for which a uniform division would be wasteful.
inline void hill(float* p) {
  const float x = p[0] - 1;
  p[2] += 0.3f * std::exp(-40 * (x * x + p[1] * p[1] + p[2] * p[2]));
}

// Expects that each side of a triangle is also a side of exactly one neighbor, with the same bits.
inline void expectClosed(const Detail& detail) {
  const std::vector<float>& positions = detail.division().attributes[0].values;
  const auto place = [&](std::uint32_t vertex) {
    return std::array{positions[3 * vertex] + 0, positions[3 * vertex + 1] + 0,
                      positions[3 * vertex + 2] + 0};
  };
  std::map<std::pair<std::array<float, 3>, std::array<float, 3>>, int> sides;
  for (const Corners& t : detail.division().triangles)
    for (int i = 0; i < 3; ++i) ++sides[{place(t[i]), place(t[(i + 1) % 3])}];
  for (const auto& [ends, count] : sides) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(sides.count({ends.second, ends.first}));
  }
}

}  // namespace warpjet
