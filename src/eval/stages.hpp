// Finds the function that writes the machine code of an operation, from the formula in its row.
#pragma once

#include "eval/staged.hpp"

namespace warpjet {

using Stage = Staged (*)(const Operands<Staged>&);

// Null for operations that are computed lane by lane.
Stage stageOf(Op op);

}  // namespace warpjet
