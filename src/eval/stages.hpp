// Provides the functions that write the machine code of operations. Each evaluates the formula in
// the operation's row with `Staged`.
#pragma once

#include "eval/staged.hpp"

namespace warpjet {

using Stage = Staged (*)(const Operands<Staged>&);

// Returns null for operations that are computed lane by lane.
Stage stageOf(Op op);

}  // namespace warpjet
