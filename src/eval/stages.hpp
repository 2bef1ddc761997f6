// The formulas of the table's rows, as functions that write instructions.
#pragma once

#include "eval/staged.hpp"

namespace warpjet {

using Stage = Staged (*)(const Operands<Staged>&);

// Null for operations that are computed lane by lane.
Stage stageOf(Op op);

}  // namespace warpjet
