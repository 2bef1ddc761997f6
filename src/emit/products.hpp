// Three sums that are a vector of the host times a matrix, as the turned normal is:
// `normal * mat3(…)`.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "graph/flags.hpp"
#include "graph/graph.hpp"

namespace warpjet {

struct MatrixProduct {
  struct Entry {
    NodeId factor;
    bool isMinus;
  };

  std::uint32_t vector;          // the input
  std::array<NodeId, 3> sums;    // the components
  std::array<Entry, 9> entries;  // column by column, which are the factors of each sum
};

struct MatrixProducts {
  std::vector<MatrixProduct> all;
  Flags terms;  // by node, whether it is one of their sums or in one, but for factors
};

// Looked for where `nodes` make a vector a unit one; `uses` says how often each node is read. All
// nine factors must be there, since with 0 or 1 among them the sums are shorter, and not all may be
// differences, as cofactors are: those make cross products. Sums stay sums if something else reads
// a term of theirs.
MatrixProducts findProducts(const Graph& graph, std::span<const NodeId> nodes,
                            std::span<const std::uint32_t> uses);

}  // namespace warpjet
