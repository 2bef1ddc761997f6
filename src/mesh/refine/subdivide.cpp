#include "mesh/refine/subdivide.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "mesh/refine/refiner.hpp"
#include "mesh/refine/surface.hpp"

namespace warpjet {

namespace {

Origins originsOf(const Mesh& mesh) {
  Origins origins;
  origins.triangles.resize(mesh.triangleCount());
  std::iota(origins.triangles.begin(), origins.triangles.end(), 0);
  return origins;
}

// Returns the original mesh if no triangle is left: all of them had two corners in one place, so
// that they were removed.
template <class Finer>
Finer keepIfEmpty(Finer finer, const Mesh& mesh) {
  if (!finer.mesh.indices.empty()) return finer;
  finer.mesh = mesh;
  finer.origins = originsOf(mesh);
  return finer;
}

}  // namespace

Refined subdivide(const Mesh& mesh, const Refinement& refinement, const WarpFunction& warp) {
  if (mesh.triangleCount() == 0) return {mesh, {}, true, true, 0, 0, false, true};
  return keepIfEmpty(Refiner(mesh, refinement, warp).run(), mesh);
}

Divided subdivideUniformly(const Mesh& mesh, int levels, std::size_t maxTriangles) {
  if (mesh.triangleCount() == 0) return {mesh, {}, levels};
  maxTriangles = std::min(maxTriangles, triangleLimit);
  Surface surface(mesh);
  int made = 0;
  for (; made < levels && surface.triangles().size() <= maxTriangles / 4; ++made) {
    std::vector<std::uint32_t> edges;
    for (std::uint32_t i = 0; i < surface.edges().size(); ++i) {
      if (surface.edges()[i].uses > 0) edges.push_back(i);
    }
    surface.addMiddles(edges);
    surface.divide(surface.mesh().positions);
  }
  Origins origins = surface.origins();
  return keepIfEmpty(Divided{std::move(surface).takeMesh(), std::move(origins), made}, mesh);
}

}  // namespace warpjet
