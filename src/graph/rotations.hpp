// Simplifies rotations that cancel.
//
// Rotating a point (x, y) by an angle u gives (x cos u - y sin u, x sin u + y cos u). The normal of
// a twist rotates it back, since the derivative of a rotated point is the perpendicular point,
// rotated:
//
//   (x cos u - y sin u) cos u + (x sin u + y cos u) sin u = x
//
// For the point (1, 0) this is sin² u + cos² u = 1.
#pragma once

#include <array>
#include <optional>

#include "graph/graph.hpp"
#include "graph/identities.hpp"

namespace warpjet {

namespace patterns {

inline constexpr Pattern k{Kind::Factor, 'k'}, u{Kind::Anything, 'u'};

// These match sums and differences in any order and with any signs; the factors x, y and k may be
// missing. A constant k may have a minus on one side.
inline constexpr std::array turns{
    Identity{k * (x * cos(u) - y * sin(u)) * cos(u) + k * (x * sin(u) + y * cos(u)) * sin(u), x* k,
             ifNumber(rounding)},
    Identity{k * (x * cos(u)) * cos(u) + k * (x * sin(u)) * sin(u), x* k, ifNumber(rounding)},
};

}  // namespace patterns

// Returns the simplified sum or difference of two products if the sines and cosines in them cancel.
// Examines two factors of each product, and two factors of each of these.
std::optional<NodeId> cancelRotation(Graph& graph, Op op, NodeId first, NodeId second);

}  // namespace warpjet
