#include "mesh/refine/subdivide.hpp"

#include <algorithm>
#include <utility>

#include "mesh/refine/refiner.hpp"
#include "mesh/refine/surface.hpp"

namespace warpjet {

namespace {

// Where all triangles had two corners in one place, nothing is left to index.
Mesh orElse(Mesh finer, const Mesh& mesh) { return finer.indices.empty() ? mesh : finer; }

}  // namespace

Refined subdivide(const Mesh& mesh, const Refinement& refinement, const WarpFunction& warp) {
  if (mesh.triangleCount() == 0) return {mesh, true, true, 0, 0, false, true};
  Refined refined = Refiner(mesh, refinement, warp).run();
  refined.mesh = orElse(std::move(refined.mesh), mesh);
  return refined;
}

Divided subdivideUniformly(const Mesh& mesh, int levels, std::size_t maxTriangles) {
  if (mesh.triangleCount() == 0) return {mesh, levels};
  maxTriangles = std::min(maxTriangles, mostTriangles);
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
  return {orElse(std::move(surface).takeMesh(), mesh), made};
}

}  // namespace warpjet
