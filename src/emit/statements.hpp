// Which nodes become statements of their own: needed nodes and outputs enter, statements and what
// each of them reads leave. The order of writing is not decided here.
#pragma once

#include <cstdint>
#include <vector>

#include "emit/emit.hpp"
#include "emit/products.hpp"
#include "emit/sums.hpp"
#include "graph/folds.hpp"
#include "graph/schedule.hpp"

namespace warpjet {

struct Statement {
  // What it computes; noNode if it assigns an output from what others have computed. A fold stands
  // for its loop, and the first of several lanes for all.
  NodeId node = noNode;
  // The output that it assigns; null for a temporary.
  const Output* output = nullptr;
  // The lanes that it computes at once, or none; see packs.hpp.
  std::uint32_t pack = none;
};

// Those of one body; `work` has the variables that each of them reads.
struct Statements {
  // Some of them, as a part of `work.reads`: while it grows, the last one.
  struct Set {
    std::uint32_t first = 0, count = 0;
  };

  std::vector<Statement> all;
  Work work;

  Set noReads() const { return {static_cast<std::uint32_t>(work.reads.size()), 0}; }
  void include(Set& set, std::uint32_t statement);
  std::uint32_t add(const Statement& statement, Set reads);
};

// Those outside of all loops, then those of the body of each loop. `nodes` are all that the outputs
// need, ascending, `uses` how often each is read, and `loops` what they are in, unless there are
// none; `sums` says which of the outputs are sums, and `products` what stays whole.
std::vector<Statements> makeStatements(const Graph& graph, std::span<const NodeId> nodes,
                                       std::span<const std::uint32_t> uses, const Loops* loops,
                                       std::span<const Output> outputs,
                                       std::span<const std::optional<Sum>> sums,
                                       const MatrixProducts& products, const EmitOptions& options);

}  // namespace warpjet
