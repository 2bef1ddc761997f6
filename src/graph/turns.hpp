// What is turned back.
//
// A point (a, b) that is turned by an angle u is (a cos u - b sin u, a sin u + b cos u). The normal
// of a twist turns it back, since the slope of a turned point is that point across, and turned:
//
//   (a cos u - b sin u) cos u + (a sin u + b cos u) sin u = a
//
// where sin² u + cos² u = 1 is the case of the point (1, 0).
#pragma once

#include <optional>

#include "graph/graph.hpp"

namespace warpjet {

// What the sum or difference of two products is, if one of them turns back what the other turned;
// looks at two factors of each, and at two of theirs.
std::optional<NodeId> turnedBack(Graph& graph, NodeId x, NodeId y, bool isDifference);

}  // namespace warpjet
