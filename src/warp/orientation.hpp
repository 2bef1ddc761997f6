// Finds out whether a warp mirrors space, so that cof(M) n points to the inner side of a surface.
#pragma once

#include <optional>
#include <span>

#include "graph/expression.hpp"

namespace warpjet {

// The sign of a determinant that is the same for all vertices, as a node: the constant 1 or -1
// where the sign is known from its range, and a number of the host's uniforms where these decide
// it, be it as a factor of something whose sign is known. It is 1 where the determinant is 0. The
// result is empty if the determinant can have either sign within one frame, or if the sign is not
// found. `vertexInputs` are the inputs that differ by vertex.
std::optional<Expression> orientation(Expression determinant, std::span<const NodeId> vertexInputs);

}  // namespace warpjet
