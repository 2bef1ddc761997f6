// Chooses the triangles that views may show, by their warped corners. The warp is evaluated only at
// samples of these.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "detail/base_mesh.hpp"
#include "detail/triangles_on_screen.hpp"

namespace warpjet {

class VisibleTriangles {
 public:
  // Forgets all triangles, since the mesh or its surface has changed.
  void clear() { triangles_.clear(); }

  // Adds the triangles that a view may show: those that it would show if they were flat, and their
  // neighbors. The first numbers of `warped` are the positions of the vertices. If `listsSamples`,
  // returns the samples of the added triangles, except vertices, and samples of triangles that were
  // added before.
  const std::vector<std::uint32_t>& add(const BaseMesh& base, std::span<const float> warped,
                                        std::span<const ScreenView> views, bool listsSamples);
  // Returns what `add` returned last.
  const std::vector<std::uint32_t>& samples() const { return samples_; }

  // All triangles that were added since `clear`.
  std::span<const std::uint32_t> triangles() const { return triangles_; }

 private:
  void markCorners(const BaseMesh& base, std::span<const float> warped, const ScreenView& view);
  void listSamples(const BaseMesh& base, std::uint32_t triangle);

  std::vector<std::uint32_t> triangles_, samples_;
  std::vector<bool> isAdded_, hasSamples_;  // by triangle, and by side
  std::vector<bool> isMarked_;              // by place of vertices
  std::vector<glm::vec4> clip_;             // by vertex
};

}  // namespace warpjet
