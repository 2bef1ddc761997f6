// Applies an operation of the table to four lanes, one by one as numbers: for operations that are
// not written for lanes, such as those on integers.
#pragma once

#include "eval/lanes.hpp"
#include "graph/graph.hpp"

namespace warpjet {

// Conditions are masks; for integers, a lane contains the bits.
Lanes eachLane(Op op, const Operands<Lanes>& x);

}  // namespace warpjet
