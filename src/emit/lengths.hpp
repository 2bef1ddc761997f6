// Approximate lengths of texts, in characters, for each number: where it is computed, and where it
// is read.
//
// All lengths are found once, operands before users. After that, a statement that changes its name
// corrects the texts that read it, up to where those texts have names of their own. So asking is
// free, and nothing ever has to be forgotten.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

class Lengths {
 public:
  // Deeper operands count as `usualNumber`. Texts have fewer levels, unless somebody wants them
  // deeper.
  static constexpr int deepest = 16;
  static constexpr int usualNumber = 5, name = 3, member = 2;

  Lengths(const Graph& graph, ops::Language language)
      : graph_(graph), language_(language), texts_(graph.size()) {}

  // The node is read by a name of this length, before `measure` or after it.
  void setName(NodeId id, int length);
  // The node is written where it is read again.
  void removeName(NodeId id);

  // `nodes` are all that are written, ascending. Their names are known.
  void measure(std::span<const NodeId> nodes);

  // The length where the node is read; operands below `levels` operations are not looked at.
  int whereRead(NodeId id, int levels) const;
  // The length of its operation.
  int ofOperation(NodeId id, int levels) const;
  // The characters of a spelling that are no operands.
  static int around(const ops::Spelling& spelling, int operands) {
    return static_cast<int>(spelling.text.size()) - member * operands;
  }

 private:
  struct Text {
    int whereRead = usualNumber, operation = usualNumber;
    // Levels of operations, one within another, up to one more than the deepest: where the node is
    // computed.
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
  // The operations that read each node, as often as they do.
  std::vector<std::uint32_t> userEnds_;
  std::vector<NodeId> users_;
};

}  // namespace warpjet
