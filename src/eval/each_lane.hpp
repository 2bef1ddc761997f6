// Any operation of the table on four lanes, one by one as numbers: for those that are not written
// for lanes, such as those of whole numbers.
#pragma once

#include "eval/lanes.hpp"
#include "graph/graph.hpp"

namespace warpjet {

// Conditions are masks, and of an int a lane holds the bits.
Lanes eachLane(Op op, const Operands<Lanes>& x);

}  // namespace warpjet
