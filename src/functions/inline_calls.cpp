#include "functions/library.hpp"
#include "graph/multi_index.hpp"
#include "graph/reachable.hpp"

namespace warpjet {

namespace {

class Inliner {
 public:
  Inliner(Graph& graph, Library& library)
      : graph_(graph), library_(library), inlined_(graph.size(), noNode) {}

  // Operands are visited before their users.
  void visit(NodeId id) {
    if (graph_.isList(id) || graph_.isOurCall(id)) return;
    inlined_[index(id)] = replacement(id);
  }

  NodeId inlined(NodeId id) const { return inlined_[index(id)]; }

 private:
  // A call whose body is being copied: by node of the body, its copy.
  struct Copy {
    NodeId call;
    std::vector<NodeId> nodes = {};
  };

  Copy& copyOf(NodeId call) {
    for (Copy& copy : copies_) {
      if (copy.call == call) return copy;
    }
    return copies_.emplace_back(Copy{call});
  }

  NodeId replacement(NodeId id) {
    if (graph_.isLeaf(id)) return id;
    if (graph_.isResult(id)) return result(id);
    if (graph_.isCall(id)) return graph_.call(graph_.node(id).operands[1], argumentsOf(id));
    Operands<NodeId> operands{};
    bool changed = false;
    for (int i = 0; i < graph_.arity(id); ++i) {
      operands[i] = inlined(graph_.operand(id, i));
      changed |= operands[i] != graph_.operand(id, i);
    }
    return changed ? graph_.apply(graph_.node(id).op, operands) : id;
  }

  std::vector<NodeId> argumentsOf(NodeId call) const {
    std::vector<NodeId> arguments = graph_.arguments(call);
    for (NodeId& argument : arguments) argument = inlined(argument);
    return arguments;
  }

  NodeId result(NodeId id) {
    const NodeId call = graph_.operand(id, 0);
    const Function& function = graph_.function(call);
    const int number = graph_.resultNumber(id);
    const int order = MultiIndices::orderOf(function.variables, number / function.values);
    Body& body = library_.withoutCalls(function.name, order);
    Copy& copy = copyOf(call);
    copy.nodes.resize(body.graph.size(), noNode);
    if (noNode == copy.nodes[index(body.arguments[0].id)]) {
      const std::vector<NodeId> arguments = argumentsOf(call);
      for (std::size_t i = 0; i < arguments.size(); ++i)
        copy.nodes[index(body.arguments[i].id)] = arguments[i];
    }
    const NodeId root = body.withoutCalls[number];
    const auto isCopied = [&](NodeId node) { return copy.nodes[index(node)] != noNode; };
    for (const NodeId node : reachable(body.graph, {&root, 1}, isCopied))
      copy.nodes[index(node)] = copied(body.graph, node, copy.nodes);
    const NodeId found = copy.nodes[index(root)];
    const Definition& definition = body.definition;
    if (order == 0) return limited(found, definition.low, definition.high);
    return order == 1 ? limited(found, -definition.steepest, definition.steepest) : found;
  }

  NodeId copied(const Graph& from, NodeId node, const std::vector<NodeId>& nodes) {
    if (from.isConstant(node)) return graph_.constant(from.value(node));
    Operands<NodeId> operands{};
    for (int i = 0; i < from.arity(node); ++i) operands[i] = nodes[index(from.operand(node, i))];
    return graph_.apply(from.node(node).op, operands);
  }

  // No value leaves these limits anyway; but interval arithmetic does not know that.
  NodeId limited(NodeId value, double low, double high) {
    if (high == std::numeric_limits<double>::infinity()) return value;
    return min(max(Expression{&graph_, value}, low), high).id;
  }

  Graph& graph_;
  Library& library_;
  std::vector<NodeId> inlined_;  // by node
  std::vector<Copy> copies_;
};

bool hasOurCalls(const Graph& graph) {
  for (std::uint32_t i = 0; i < graph.functionCount(); ++i) {
    if (graph.function(i).isOurs()) return true;
  }
  return false;
}

}  // namespace

std::vector<NodeId> inlineCalls(Graph& graph, Library& library, std::span<const NodeId> roots) {
  std::vector<NodeId> found(roots.begin(), roots.end());
  if (!hasOurCalls(graph)) return found;
  Inliner inliner(graph, library);
  for (const NodeId id : reachable(graph, roots)) inliner.visit(id);
  for (NodeId& root : found) root = inliner.inlined(root);
  return found;
}

}  // namespace warpjet
