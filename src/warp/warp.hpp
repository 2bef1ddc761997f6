// The warp: an offset function enters as a graph, the turned normal leaves as nodes of the same
// graph. The only room that knows what a warp is.
#pragma once

#include "algebra/value.hpp"
#include "diff/differentiator.hpp"

namespace warpjet {

// The unit normal of the moved surface, or zero where the warp collapses the surface so that it has
// none; a cof(M) n outside of 1e-19 ... 1e19 counts as collapsed, since float32 cannot hold its
// square. `position` must be the three components of one input. All other inputs, normal and uv
// among them, count as constant over the surface.
//
// With M = I + J, where J is the Jacobian of the offset by the position, tangents u and v of the
// surface become M u and M v, and (M u) x (M v) = cof(M) (u x v): the cofactor matrix, whose
// columns are m2 x m3, m3 x m1 and m1 x m2, turns normals. It equals equation 1 of Pagurek van
// Mossel's "Vertex Shader Domain Warping with Automatic Differentiation" (2024) for every choice of
// tangents. Where M collapses a direction (section 5.1 there) cof(M) n can vanish.
Value warpedNormal(Differentiator& differentiator, const Value& offset, const Value& normal,
                   const Value& position);

}  // namespace warpjet
