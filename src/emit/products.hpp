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

// Those of `nodes` that are made a unit vector. It has to pay: where all entries are differences,
// as the cofactors of a full matrix are, cross products are shorter, and where some are 0 or 1,
// sums are.
MatrixProducts findProducts(const Graph& graph, std::span<const NodeId> nodes);

}  // namespace warpjet
