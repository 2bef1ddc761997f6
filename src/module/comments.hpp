// Comments to write above the statements of nodes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

struct Comments {
  // Applies to the nodes from `first` up to but excluding `end`.
  struct Range {
    NodeId first, end;
    std::uint32_t text;
  };

  std::vector<std::string> texts;
  std::vector<Range> ranges;  // in the order of nodes, disjoint

  const Range* find(NodeId id) const {
    const auto range =
        std::lower_bound(ranges.begin(), ranges.end(), id,
                         [](const Range& other, NodeId node) { return other.end <= node; });
    return range != ranges.end() && range->first <= id ? &*range : nullptr;
  }
};

}  // namespace warpjet
