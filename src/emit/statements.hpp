// Decides which nodes become statements: takes needed nodes and outputs, returns statements and
// what each of them reads. The order is decided elsewhere.
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
  // The node that it computes; noNode if it assigns an output from values computed by other
  // statements. A fold stands for its loop, and the first of several lanes for all of them.
  NodeId node = noNode;
  // The output that it assigns; null for a temporary.
  const Output* output = nullptr;
  // The pack whose lanes it computes, or `none`; see packs.hpp.
  std::uint32_t pack = none;
};

// The statements of one body; `work` has the variables that each of them reads.
struct Statements {
  // A set of statements, as a range of `work.reads`. Only the last set can grow.
  struct Set {
    std::uint32_t first = 0, count = 0;
  };

  std::vector<Statement> all;
  Work work;

  Set emptySet() const { return {static_cast<std::uint32_t>(work.reads.size()), 0}; }
  void include(Set& set, std::uint32_t statement);
  std::uint32_t add(const Statement& statement, Set reads);
};

// Returns the statements outside of all loops, then those of each loop's body. `nodes` are all
// nodes that the outputs need, ascending; `uses` has the number of reads of each; `loops` is null
// if there are none; `sums` says which outputs are sums, and `products` which sums are not split
// into statements.
std::vector<Statements> makeStatements(const Graph& graph, std::span<const NodeId> nodes,
                                       std::span<const std::uint32_t> uses, const Loops* loops,
                                       std::span<const Output> outputs,
                                       std::span<const std::optional<Sum>> sums,
                                       const MatrixProducts& products, const EmitOptions& options);

}  // namespace warpjet
