// Adds triangles where a warp needs them: takes a mesh and a warp, returns the same surface with
// more vertices, not warped yet. It adds no cracks and no T-junctions: vertices at equal positions
// (split normals, UVs or colors) are treated as one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "mesh/mesh.hpp"

namespace warpjet {

// Warped positions and normals of vertices, three numbers each, in order. The normals may be
// missing.
struct Moved {
  std::vector<float> positions, normals;
};

// Warps any number of vertices, which are passed without indices.
using WarpFunction = std::function<Moved(const Mesh& vertices)>;

// The first limit ensures that vertex numbers fit 32 bits, the second one is the default.
inline constexpr std::size_t triangleLimit = std::size_t{1} << 28,
                             defaultTriangles = std::size_t{1} << 20;

struct Refinement {
  float tolerance;  // in model units, above 0: the max distance of the warped surface from the
                    // triangles
  // In radians, above 0: the max angle of warped normals from those interpolated between corners.
  // Infinity ignores normals.
  float angle = 0.17f;
  std::size_t maxTriangles = defaultTriangles;
};

// The origins of a finer mesh: for each new vertex, in order, the two vertices that it is in the
// middle of, and for each triangle the original triangle that it is a part of.
struct Origins {
  std::vector<std::uint32_t> ends, triangles;
};

struct Refined {
  Mesh mesh;  // indexed; original vertices come first, in their order
  Origins origins;
  bool reachedTolerance, reachedAngle;
  float worst;       // the largest remaining distance in model units, where it was measured
  float worstAngle;  // the same for angles, in radians
  bool isFull;       // true if `maxTriangles` was reached
  bool isDefined;    // true if all positions of the warp were finite
};

// Splits edges in the middle repeatedly, until the warped surface is as close as required to the
// warped triangles. New vertices interpolate all attributes. Nothing is split where the warp
// returns NaN or infinity, where it tears the surface apart, or where floats have no position in
// between. The result never exceeds `maxTriangles`: the worst edges are split first. Triangles with
// two corners in one place (as at the poles of many spheres) are removed when one of their sides is
// split. A mesh without triangles is returned unchanged.
Refined subdivide(const Mesh& mesh, const Refinement& refinement, const WarpFunction& warp);

struct Divided {
  Mesh mesh;
  Origins origins;
  int levels;  // the number of times that each triangle was split into four
};

// Splits each triangle into four, `levels` times, or as often as `maxTriangles` allows; triangles
// with two corners in one place are removed. A mesh without triangles is returned unchanged.
Divided subdivideUniformly(const Mesh& mesh, int levels,
                           std::size_t maxTriangles = defaultTriangles);

}  // namespace warpjet
