// What the rows of the table compute, as functions that write instructions.
#pragma once

#include "eval/staged.hpp"

namespace warpjet {

using Stage = Staged (*)(const Operands<Staged>&);

// Null for what is done on each lane.
Stage stageOf(Op op);

}  // namespace warpjet
