// What is turned back.
//
// A point (x, y) that is turned by an angle u is (x cos u - y sin u, x sin u + y cos u). The normal
// of a twist turns it back, since the slope of a turned point is that point across, and turned:
//
//   (x cos u - y sin u) cos u + (x sin u + y cos u) sin u = x
//
// where sin² u + cos² u = 1 is the case of the point (1, 0).
#pragma once

#include <array>
#include <optional>

#include "graph/graph.hpp"
#include "graph/identities.hpp"

namespace warpjet {

namespace patterns {

inline constexpr Pattern k{Kind::Factor, 'k'}, u{Kind::Anything, 'u'};

// These match sums and differences in any order and with any signs; the factors x, y and k may be
// missing. k may have a minus on one side, if it is a constant.
inline constexpr std::array turns{
    Identity{k * (x * cos(u) - y * sin(u)) * cos(u) + k * (x * sin(u) + y * cos(u)) * sin(u), x* k,
             ifNumber(rounding)},
    Identity{k * (x * cos(u)) * cos(u) + k * (x * sin(u)) * sin(u), x* k, ifNumber(rounding)},
};

}  // namespace patterns

// What the sum or difference of two products is, if one of them turns back what the other turned;
// looks at two factors of each, and at two of theirs.
std::optional<NodeId> turnedBack(Graph& graph, Op op, NodeId first, NodeId second);

}  // namespace warpjet
