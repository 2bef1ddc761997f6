// The bends of the warped surface of triangles, each as a metric in the plane of its triangle.
#pragma once

#include <array>
#include <span>

#include "detail/base_mesh.hpp"
#include "detail/four_triangles.hpp"
#include "detail/interpolation.hpp"

namespace warpjet {

// Triangles in their planes: corner 0 is the origin, corner 1 on the first axis.
struct PlanarTriangles {
  Lanes width;  // the first coordinate of corner 1
  Vec2 apex;    // corner 2

  // The corners are those at the present positions of the mesh.
  PlanarTriangles(const BaseMesh& base, const FourTriangles& triangles);
};

// The sides of triangles in their planes, and those of the given triangles that their patches are
// parts of. Without patches, the triangles are the given ones.
struct Directions {
  std::array<Vec2, 3> sides, givenSides;
};
Directions directionsOf(const PlanarTriangles& planar, std::span<const Patch> patches,
                        const FourTriangles& triangles);

// The symmetric matrices ((xx, xy), (xy, yy)).
struct Quadratics {
  Lanes xx, xy, yy;

  Lanes along(const Vec2& v) const {
    return xx * v.x * v.x + 2.0f * xy * v.x * v.y + yy * v.y * v.y;
  }
  // Tests whether the numbers are finite.
  Mask areFinite() const;
};

// Returns the weights of a corner of patches.
Vec3 weightsOf(int corner, std::span<const Patch> patches, const FourTriangles& triangles);

// Returns M such that e' M e bounds the second derivative along e, from the second derivatives
// along the sides. M is the root of the sum of the squared Hessians of x and y on the screen, in
// the plane of the triangle. Second derivatives along the sides alone would miss the bend of a
// saddle. It is NaN where the surface does not bend.
Quadratics bendOf(const PlanarTriangles& planar, const std::array<Vec2, 3>& alongSides);

// Returns the error of flat triangles, whose sides have these squares in the metric of their bend:
// half of the squared radius of the smallest circle around a triangle. That is the circle through
// its corners, unless an angle is obtuse.
Lanes errorOf(Lanes a, Lanes b, Lanes c);

}  // namespace warpjet
