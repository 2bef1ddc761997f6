// The warp: an offset function enters as a graph, the turned normal leaves as nodes of the same
// graph. The only room that knows what a warp is.
#pragma once

#include "algebra/value.hpp"
#include "diff/differentiator.hpp"

namespace warpjet {

// M = I + J, where J is the Jacobian of the offset by the position: what the warp makes of
// directions. Its determinant says how volume grows; where it is not above zero, the warp turns
// space inside out. `position` must be the three components of one input. All other inputs, normal
// and uv among them, count as constant.
Value deformation(Differentiator& differentiator, const Value& offset, const Value& position);

// How the normal and the texture coordinates vary over the surface, which an offset along the
// normal makes part of its derivative. The derivative of the unit normal is the shape operator (up
// to the sign that authors give it) as a symmetric matrix: 1/r across the normal of a sphere of
// radius r, 0 along it. It comes as its diagonal (xx, yy, zz) and what is beside that (yz, xz, xy).
// The gradients lie in the surface too.
struct SurfaceVariation {
  const Value& normal;  // an input, as are u and v
  Expression u, v;
  const Value &shapeDiagonal, &shapeOffDiagonal;
  const Value &uGradient, &vGradient;
};

// The same M for an offset that depends on them: by the chain rule it is
// I + df/dp + df/dn W + df/du (du/dp) + df/dv (dv/dp). It holds for tangents of the surface. Since
// W and the gradients are zero along the normal, its determinant is that of the thin layer around
// the surface in which normal and uv stay the same along each normal.
Value surfaceDeformation(Differentiator& differentiator, const Value& offset, const Value& position,
                         const SurfaceVariation& variation);

// The unit normal of the surface whose tangents M turns, or zero where M collapses the surface so
// that it has none; a cof(M) n outside of 1e-19 ... 1e19 counts as collapsed, since float32 cannot
// hold its square.
//
// Tangents u and v of the surface become M u and M v, and (M u) x (M v) = cof(M) (u x v): the
// cofactor matrix, whose columns are m2 x m3, m3 x m1 and m1 x m2, turns normals. It equals
// equation 1 of Pagurek van Mossel's "Vertex Shader Domain Warping with Automatic Differentiation"
// (2024) for every choice of tangents. Where M collapses a direction (section 5.1 there) cof(M) n
// can vanish.
Value turnedNormal(const Value& m, const Value& normal);

// The unit tangent M t, less what of it goes along `normal`, the turned one; zero where M collapses
// it. The side of the bitangent stays: with t x b = n, (M t) x (M b) is cof(M) n for every M, a
// mirror too, since that turns the normal as well.
Value turnedTangent(const Value& m, const Value& tangent, const Value& normal);

}  // namespace warpjet
