#include <algorithm>
#include <limits>

#include "functions/library.hpp"
#include "graph/flags.hpp"
#include "graph/folds.hpp"
#include "graph/multi_index.hpp"
#include "graph/reachable.hpp"

namespace warpjet {

namespace {

// The CPU evaluates that many operations in about 1 ms per vertex. Nested uncounted loops would
// otherwise multiply their steps.
constexpr std::size_t maxUncountedNodes = std::size_t{1} << 18;

class Inliner {
 public:
  // Without a library, loops are unrolled, but calls remain.
  Inliner(Graph& graph, Library* library)
      : graph_(graph), library_(library), inlined_(graph.size(), noNode) {}

  void run(std::span<const NodeId> nodes) {
    if (!graph_.has(foldOp)) return visitAll(nodes);
    const Loops loops(graph_, nodes);
    bodies_.resize(graph_.loopCount());
    std::vector<NodeId> outsideNodes;
    Flags isKnown(graph_.loopCount());
    for (const NodeId id : loops.order()) {
      if (graph_.isFold(id)) {
        if (isKnown[graph_.loopOf(id)]) continue;
        isKnown[graph_.loopOf(id)] = true;
      }
      const std::uint32_t loop = loops.loopOf(id);
      (loop == Loops::outside ? outsideNodes : bodies_[loop]).push_back(id);
    }
    loops_ = &loops;
    visitAll(outsideNodes);
  }

  NodeId inlined(NodeId id) const { return inlined_[index(id)]; }

 private:
  // A call whose body is being copied: the copy of each node of the body.
  struct Copy {
    NodeId call;
    std::vector<NodeId> nodes = {};
  };

  // Operands are visited before their users.
  void visitAll(std::span<const NodeId> nodes) {
    for (const NodeId id : nodes) visit(id);
  }

  void visit(NodeId id) {
    if (graph_.isFold(id)) return unroll(graph_.loopOf(id));
    if (graph_.isList(id) || graph_.isLocal(id) || (library_ && graph_.isLibraryCall(id))) return;
    inlined_[index(id)] = replacement(id);
  }

  // Replaces a loop variable by its value in each step while the body is visited, and by its final
  // value after the loop.
  void unroll(std::uint32_t loop) {
    const std::vector<State>& states = loops_->statesOf(loop);
    std::vector<NodeId> values;
    for (const State& state : states) values.push_back(inlined(state.start));
    const auto assign = [&] {
      for (std::size_t i = 0; i < states.size(); ++i) inlined_[index(states[i].local)] = values[i];
    };
    assign();
    const bool isCounted = graph_.loop(loop).isCounted();
    if (!isCounted && openUncounted_++ == 0) start_ = graph_.size();
    const NodeId stepNode = graph_.stepOf(loop);
    inlined_.resize(std::max(inlined_.size(), std::size_t{index(stepNode)} + 1), noNode);
    for (std::uint32_t step = 0; !isOver(loop, step); ++step) {
      inlined_[index(stepNode)] = graph_.constant(step);
      const std::size_t before = copies_.size();
      visitAll(bodies_[loop]);
      copies_.resize(before, Copy{noNode});
      for (std::size_t i = 0; i < states.size(); ++i) values[i] = inlined(states[i].next);
      assign();
    }
    if (isCounted) return;
    if (--openUncounted_ == 0) uncountedNodes_ += graph_.size() - start_;
    replaceUnended(states, values);
    assign();
  }

  // An uncounted loop that ends after `assumedSteps` needs one more step to find that out, unless
  // its condition comes last.
  bool isOver(std::uint32_t loop, std::uint32_t step) const {
    if (graph_.isFull()) return true;
    if (graph_.loop(loop).isCounted()) return step == graph_.loop(loop).steps;
    return step > Loop::assumedSteps ||
           uncountedNodes_ + graph_.size() - start_ > maxUncountedNodes;
  }

  // Replaces the values after an uncounted loop by NaN where the loop has not ended.
  void replaceUnended(const std::vector<State>& states, std::vector<NodeId>& values) {
    const auto end = std::find_if(states.begin(), states.end(),
                                  [&](const State& state) { return graph_.endsLoop(state.local); });
    if (end == states.end()) return;
    const NodeId unknown = graph_.constant(std::numeric_limits<double>::quiet_NaN());
    const NodeId flag = values[static_cast<std::size_t>(end - states.begin())];
    const NodeId hasEnded = graph_.apply(ops::find("gt"), {flag, graph_.constant(0.5)});
    for (NodeId& value : values)
      value = graph_.apply(ops::find("ifElse"), {hasEnded, value, unknown});
  }

  Copy& copyOf(NodeId call) {
    for (Copy& copy : copies_) {
      if (copy.call == call) return copy;
    }
    return copies_.emplace_back(Copy{call});
  }

  NodeId replacement(NodeId id) {
    if (graph_.isLeaf(id)) return id;
    if (graph_.isResult(id)) return library_ ? result(id) : keepResult(id);
    if (graph_.isOutcome(id)) return inlined(graph_.operand(id, 1));
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

  NodeId keepResult(NodeId id) {
    return graph_.result(inlined(graph_.operand(id, 0)), graph_.resultNumber(id));
  }

  NodeId result(NodeId id) {
    const NodeId call = graph_.operand(id, 0);
    const Function& function = graph_.function(call);
    const int number = graph_.resultNumber(id);
    const int order = MultiIndices::orderOf(function.variables, number / function.values);
    Body& body = library_->withoutCalls(function.name, order);
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
      copy.nodes[index(node)] = copyNode(body.graph, node, copy.nodes);
    const NodeId value = copy.nodes[index(root)];
    const Definition& definition = body.definition;
    if (order == 0) return clipTo(value, definition.low, definition.high);
    return order == 1 ? clipTo(value, -definition.maxSlope, definition.maxSlope) : value;
  }

  NodeId copyNode(const Graph& from, NodeId node, const std::vector<NodeId>& nodes) {
    if (from.isConstant(node)) return graph_.constant(from.value(node));
    if (from.isKnownInt(node)) return graph_.intConstant(*from.known(node));
    Operands<NodeId> operands{};
    for (int i = 0; i < from.arity(node); ++i) operands[i] = nodes[index(from.operand(node, i))];
    return graph_.apply(from.node(node).op, operands);
  }

  // Clips the value to limits that it never exceeds, but that interval arithmetic can't derive.
  NodeId clipTo(NodeId value, double low, double high) {
    if (high == std::numeric_limits<double>::infinity()) return value;
    return min(max(Expression{&graph_, value}, low), high).id;
  }

  Graph& graph_;
  Library* library_;
  // The number of uncounted loops that are unrolled now, one in another; the size of the graph
  // before them; and the number of nodes that finished ones have added.
  std::size_t openUncounted_ = 0, start_ = 0, uncountedNodes_ = 0;
  std::vector<NodeId> inlined_;  // by node
  std::vector<Copy> copies_;
  const Loops* loops_ = nullptr;
  std::vector<std::vector<NodeId>> bodies_;  // by loop, without the bodies of nested loops
};

bool hasOurCalls(const Graph& graph) {
  for (std::uint32_t i = 0; i < graph.functionCount(); ++i) {
    if (graph.function(i).isFromLibrary()) return true;
  }
  return false;
}

}  // namespace

static std::vector<NodeId> inlineAll(Graph& graph, Library* library,
                                     std::span<const NodeId> roots) {
  Inliner inliner(graph, library);
  inliner.run(reachable(graph, roots));
  std::vector<NodeId> inlined;
  for (const NodeId root : roots) inlined.push_back(inliner.inlined(root));
  return inlined;
}

std::vector<NodeId> inlineCalls(Graph& graph, Library& library, std::span<const NodeId> roots) {
  if (!hasOurCalls(graph) && !graph.has(foldOp)) return {roots.begin(), roots.end()};
  return inlineAll(graph, &library, roots);
}

bool canUnroll(const Graph& graph) {
  if (!graph.has(foldOp)) return false;
  std::uint64_t unrolledSize = graph.size();
  for (std::uint32_t i = 0; i < graph.loopCount() && unrolledSize <= maxUnrolledNodes; ++i) {
    if (!graph.loop(i).isCounted()) return false;
    unrolledSize *= graph.loop(i).steps;
  }
  return unrolledSize <= maxUnrolledNodes;
}

std::vector<NodeId> unrollFolds(Graph& graph, std::span<const NodeId> roots) {
  return inlineAll(graph, nullptr, roots);
}

}  // namespace warpjet
