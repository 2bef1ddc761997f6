// More triangles where a warp needs them: a mesh and a warp enter, the same surface with more
// vertices leaves, not warped yet. There are no cracks and no T-junctions that were not there
// before: vertices at equal positions (split normals, UVs or colours) count as one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "mesh/mesh.hpp"

namespace warpjet {

// Moved positions and normals of vertices, three numbers each, in order. The normals may be
// missing.
struct Moved {
  std::vector<float> positions, normals;
};

// The warp, on as many vertices as come: only attributes matter, there are no indices.
using WarpFunction = std::function<Moved(const Mesh& vertices)>;

// So that every vertex has a number of 32 bits, and what counts unless another limit is given.
inline constexpr std::size_t mostTriangles = std::size_t{1} << 28,
                             usualTriangles = std::size_t{1} << 20;

struct Refinement {
  float tolerance;  // model units, above 0: how far the warped surface may leave the triangles
  // Radians, above 0: how far warped normals may turn away from those interpolated between corners.
  // Infinity leaves normals out.
  float angle = 0.17f;
  std::size_t maxTriangles = usualTriangles;
};

// Where a finer mesh comes from: of each new vertex, in order, the two that it is in the middle of,
// and of each triangle the number of the one that it is a part of.
struct Origins {
  std::vector<std::uint32_t> ends, triangles;
};

struct Refined {
  Mesh mesh;  // indexed; what was there comes first, in its order
  Origins origins;
  bool reachedTolerance, reachedAngle;
  float worst;       // model units: the largest distance that is left, where it was measured
  float worstAngle;  // radians, likewise
  bool isFull;       // whether `maxTriangles` ended it
  bool isDefined;    // whether the warp gave finite positions
};

// Edges are split in the middle, over and over, until the warped surface is as near as wanted to
// the warped triangles. New vertices interpolate all attributes. Where the warp gives NaN or
// infinity, where it tears the surface apart, or where floats have no room between two positions,
// nothing is split. More than `maxTriangles` are never made: the worst edges are split first.
// Triangles with two corners in one place (as at the poles of many spheres) go when a side of
// theirs is split. Without any triangle the mesh comes back as it was.
Refined subdivide(const Mesh& mesh, const Refinement& refinement, const WarpFunction& warp);

struct Divided {
  Mesh mesh;
  Origins origins;
  int levels;  // how often each triangle became four
};

// Each triangle into four, `levels` times, or as often as `maxTriangles` allows; those with two
// corners in one place go. Without any triangle the mesh comes back as it was.
Divided subdivideUniformly(const Mesh& mesh, int levels, std::size_t maxTriangles = usualTriangles);

}  // namespace warpjet
