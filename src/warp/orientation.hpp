// Whether a warp mirrors space, so that what was the outer side of a surface is where cof(M) n does
// not point.
#pragma once

#include <span>

#include "graph/expression.hpp"

namespace warpjet {

// The sign of a determinant that is the same for all vertices, as a node: the constant 1 or -1 where
// the sign is known from its range, and a number of the host's uniforms where these decide it, be it
// as a factor of something whose sign is known. It is 1 where the determinant is 0, and wherever it
// can have either sign for one and the same frame. `vertexInputs` are the inputs that differ by vertex.
Expression orientation(Expression determinant, std::span<const NodeId> vertexInputs);

}  // namespace warpjet
