// Determines whether a warp mirrors space, which makes cof(M) n point to the inner side of a
// surface.
#pragma once

#include <optional>
#include <span>

#include "graph/expression.hpp"

namespace warpjet {

// Returns the sign of a determinant if it is equal for all vertices, as a node: the constant 1 or
// -1 if the sign is known from the range, or an expression of the host's uniforms if these
// determine it, possibly as a factor of something with a known sign. The sign is 1 where the
// determinant is 0. Returns nullopt if the determinant can have both signs within a frame, or if
// the sign can't be determined. `vertexInputs` are the inputs that vary per vertex.
std::optional<Expression> orientation(Expression determinant, std::span<const NodeId> vertexInputs);

}  // namespace warpjet
