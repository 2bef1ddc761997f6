// The values that JavaScript refers to by handle.
#pragma once

#include <cstdint>
#include <vector>

#include "algebra/value.hpp"

namespace warpjet {

class Values {
 public:
  // More than any sketch can use; see Graph::maxNodes.
  static constexpr std::size_t maxValues = std::size_t{1} << 23;

  bool isFull() const { return slots_.size() >= maxValues; }

  int add(const Value& value) {
    const auto nodes = value.nodes();
    if (nodes.size() == 1) {
      slots_.push_back({value.shape(), index(nodes[0])});
    } else {
      slots_.push_back({value.shape(), static_cast<std::uint32_t>(nodes_.size())});
      nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
    }
    return static_cast<int>(slots_.size() - 1);
  }

  Shape shape(int handle) const { return slots_[handle].shape; }

  Value get(Graph& graph, int handle) const {
    const auto [shape, first] = slots_[handle];
    if (shape.size() == 1) return Expression{&graph, NodeId{first}};
    return fill(graph, shape, [&, at = first](int i) {
      return Expression{&graph, nodes_[at + i]};
    });
  }

 private:
  // `first` is the node of a number, or the position of the first node of a vector or matrix.
  struct Slot {
    Shape shape;
    std::uint32_t first;
  };

  std::vector<Slot> slots_;
  std::vector<NodeId> nodes_;
};

}  // namespace warpjet
