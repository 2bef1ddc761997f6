// Replaces nodes of a graph by others of the same graph, from operands to users.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/graph.hpp"
#include "module/comments.hpp"

namespace warpjet {

class Rewriter {
 public:
  Rewriter(Graph& graph, Comments& comments)
      : graph_(graph), comments_(comments), replacements_(graph.size()) {}
  virtual ~Rewriter() = default;

  // Returns the nodes that replace these. The new nodes have the comments of those that they
  // replace.
  std::vector<NodeId> rewrite(std::span<const NodeId> roots);

 protected:
  // These functions return the replacement of a node whose operands and arguments have been
  // replaced.
  virtual NodeId replace(NodeId id);
  virtual NodeId replaceOperation(NodeId id);
  virtual NodeId replaceCall(NodeId id);

  NodeId replacementOf(NodeId id) const { return isKept(id) ? id : replacements_[index(id)]; }
  Operands<NodeId> newOperands(NodeId id) const;
  std::vector<NodeId> newArguments(NodeId call) const;

  Graph& graph_;

 private:
  void visit(NodeId id);
  bool isKept(NodeId id) const { return graph_.isConstant(id) || graph_.isLocal(id); }
  NodeId replaceFold(NodeId id);
  NodeId end() const { return NodeId{static_cast<std::uint32_t>(graph_.size())}; }

  Comments& comments_;
  std::vector<NodeId> replacements_;  // by node
};

}  // namespace warpjet
