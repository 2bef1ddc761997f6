// Which nodes become statements of their own: needed nodes and outputs enter, statements and what
// each of them reads leave. The order of writing is not decided here.
#pragma once

#include <cstdint>
#include <vector>

#include "emit/emit.hpp"
#include "emit/sums.hpp"
#include "graph/folds.hpp"
#include "graph/schedule.hpp"

namespace warpjet {

struct Statement {
  // What it computes, unless it assigns an output from what others have computed. A fold stands for
  // its loop.
  std::optional<NodeId> node;
  // The output that it assigns; null for a temporary.
  const Output* output;
};

// `work` has the variables that each statement reads.
struct Statements {
  std::vector<Statement> all;
  Work work;
};

// Those outside of all loops, then those of the body of each loop. `nodes` are all that the outputs
// need, ascending, and `loops` what they are in, unless there are none; `sums` says which of the
// outputs are sums.
std::vector<Statements> makeStatements(const Graph& graph, std::span<const NodeId> nodes,
                                       const Loops* loops, std::span<const Output> outputs,
                                       std::span<const std::optional<Sum>> sums,
                                       const EmitOptions& options);

}  // namespace warpjet
