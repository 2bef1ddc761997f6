// Which nodes become statements of their own: needed nodes and outputs enter, statements and what
// each of them reads leave. The order of writing is not decided here.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "emit/emit.hpp"
#include "graph/graph.hpp"

namespace warpjet {

struct Statement {
  // What it computes, unless it assigns an output from what others have computed.
  std::optional<NodeId> node;
  // The output that it assigns; null for a temporary.
  const Output* output;
  // In `Statements::reads`.
  std::uint32_t firstRead, readCount;
};

// Each statement reads only earlier ones.
struct Statements {
  std::vector<Statement> all;
  std::vector<std::uint32_t> reads;

  // The statements whose variables the i-th one reads, each once.
  std::span<const std::uint32_t> readsOf(std::uint32_t i) const {
    return {reads.data() + all[i].firstRead, all[i].readCount};
  }
};

// `nodes` are all that the outputs need, ascending.
Statements makeStatements(const Graph& graph, std::span<const NodeId> nodes,
                          std::span<const Output> outputs, const EmitOptions& options);

}  // namespace warpjet
