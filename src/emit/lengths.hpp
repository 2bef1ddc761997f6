// Approximate lengths of expressions, in characters. Each node has two: of the operation that
// computes it, and of the text with which it is read.
//
// All lengths are computed once, operands before users. After that, a statement whose name changes
// updates the expressions that read it, up to those that have their own names. So queries are
// free, and no cache needs to be invalidated.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

class Lengths {
 public:
  // Deeper operands count as `typicalNumber`. Expressions nest less deep, unless `maxDepth` was
  // raised.
  static constexpr int maxLevels = 16;
  static constexpr int typicalNumber = 5, name = 3, member = 2;

  Lengths(const Graph& graph, ops::Language language)
      : graph_(graph), language_(language), texts_(graph.size()) {}

  // Reads the node by a name of this length from now on. May be called before or after `measure`.
  void setName(NodeId id, int length);
  // Writes the node inline again.
  void removeName(NodeId id);

  // `nodes` are all nodes to write, in ascending order, with their names set.
  void measure(std::span<const NodeId> nodes);

  // Returns the length where the node is read. Operands more than `levels` operations deep are not
  // measured.
  int whereRead(NodeId id, int levels) const;
  // Returns the length of the node's operation.
  int lengthOfOperation(NodeId id, int levels) const;
  // Returns the number of characters of a spelling that don't belong to operands.
  static int around(const ops::Spelling& spelling, int operands) {
    return static_cast<int>(spelling.text.size()) - member * operands;
  }

 private:
  struct Text {
    int whereRead = typicalNumber, operation = typicalNumber;
    // The depth of nested operations where the node is computed; at most `maxLevels` + 1.
    std::uint8_t depth = 0;
    bool isNamed = false;
  };

  int measureOperation(NodeId id, int levels) const;
  int depthOfOperation(NodeId id) const;
  int lengthOfInput(NodeId id) const;
  void gatherUsers(std::span<const NodeId> nodes);
  void changeReaders(NodeId id, int difference);

  const Graph& graph_;
  ops::Language language_;
  std::vector<Text> texts_;  // by node
  // The operations that read each node, once per read.
  std::vector<std::uint32_t> userEnds_;
  std::vector<NodeId> users_;
};

}  // namespace warpjet
