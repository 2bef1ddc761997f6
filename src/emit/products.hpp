// Finds three sums that are a vector of the host times a matrix, as a warped normal is: `normal *
// mat3(…)`.
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
  std::array<Entry, 9> entries;  // the factors of each sum, column by column
};

struct MatrixProducts {
  std::vector<MatrixProduct> all;
  Flags terms;  // by node: true for the sums and their terms, but not their factors
};

// Searches where `nodes` normalize a vector; `uses` has the number of reads of each node. All nine
// factors must be present: with 0 or 1 among them, the sums are shorter. Not all factors may be
// differences, as cofactors are, which are written as cross products. Sums remain sums if one of
// their terms is read elsewhere.
MatrixProducts findProducts(const Graph& graph, std::span<const NodeId> nodes,
                            std::span<const std::uint32_t> uses);

}  // namespace warpjet
