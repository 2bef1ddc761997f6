// The warp: an offset function enters as a graph, the turned normal leaves as nodes of the same
// graph. The only room that knows what a warp is.
#pragma once

#include "algebra/value.hpp"
#include "diff/differentiator.hpp"

namespace warpjet {

// M = I + J, where J is the Jacobian of the offset by the position: what the warp makes of
// directions. Its determinant says how volume grows; where it is not above zero, the warp turns
// space inside out. `position` must be the three components of one input. All other inputs, normal
// and uv among them, count as constant over the surface.
Value deformation(Differentiator& differentiator, const Value& offset, const Value& position);

// The unit normal of the moved surface, or zero where the warp collapses the surface so that it has
// none; a cof(M) n outside of 1e-19 ... 1e19 counts as collapsed, since float32 cannot hold its
// square.
//
// Tangents u and v of the surface become M u and M v, and (M u) x (M v) = cof(M) (u x v): the
// cofactor matrix, whose columns are m2 x m3, m3 x m1 and m1 x m2, turns normals. It equals
// equation 1 of Pagurek van Mossel's "Vertex Shader Domain Warping with Automatic Differentiation"
// (2024) for every choice of tangents. Where M collapses a direction (section 5.1 there) cof(M) n
// can vanish.
Value warpedNormal(Differentiator& differentiator, const Value& offset, const Value& normal,
                   const Value& position);

// The unit tangent M t, less what of it goes along `normal`, the warped one; zero where the warp
// collapses it. The side of the bitangent stays: with t x b = n, (M t) x (M b) is cof(M) n for
// every M, a mirror too, since that turns the normal as well.
Value warpedTangent(Differentiator& differentiator, const Value& offset, const Value& tangent,
                    const Value& normal, const Value& position);

}  // namespace warpjet
