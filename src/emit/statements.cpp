#include "emit/statements.hpp"

#include <algorithm>

namespace warpjet {

namespace {

class Maker {
 public:
  Maker(const Graph& graph, std::span<const Output> outputs,
        std::span<const std::optional<Sum>> sums, const EmitOptions& options)
      : graph_(graph), outputs_(outputs), sums_(sums), options_(options), states_(graph.size()) {}

  Statements run(std::span<const NodeId> nodes) {
    countUses(nodes);
    findScalarOutputs();
    for (const NodeId id : nodes) {
      if (!graph_.isLeaf(id)) visit(id);
    }
    for (std::size_t i = 0; i < outputs_.size(); ++i) assign(outputs_[i], sums_[i]);
    return std::move(made_);
  }

 private:
  // A set of statements, as a part of `made_.work.reads`.
  struct Set {
    std::uint32_t first = 0, count = 0;
  };

  struct State {
    std::uint32_t uses = 0;
    std::uint32_t statement = none;
    int depth = 0;  // of the operations in its text
    Set reads;      // of its text
    const Output* output = nullptr;
  };

  State& state(NodeId id) { return states_[index(id)]; }

  void countUses(std::span<const NodeId> nodes) {
    for (const NodeId id : nodes) {
      for (int i = 0; i < graph_.arity(id); ++i) ++state(graph_.operand(id, i)).uses;
    }
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      if (sums_[i]) continue;
      for (const NodeId id : outputs_[i].components) ++state(id).uses;
    }
  }

  // A scalar result is its own temporary.
  void findScalarOutputs() {
    for (const Output& output : outputs_) {
      const NodeId id = output.components[0];
      if (output.shape.isNumber() && !graph_.isLeaf(id) && !state(id).output)
        state(id).output = &output;
    }
  }

  // Operands before users.
  void visit(NodeId id) {
    State& it = state(id);
    it.reads = readsOfOperands(id);
    if (!graph_.isList(id) && it.reads.count > options_.maxReads) it.reads = readFewer(id);

    for (int i = 0; i < graph_.arity(id); ++i) {
      const State& operand = state(graph_.operand(id, i));
      if (operand.statement == none) it.depth = std::max(it.depth, operand.depth);
    }
    if (graph_.isList(id)) return;
    if (graph_.isOurCall(id)) return makeStatement(id);
    ++it.depth;
    const bool isShared = it.uses > 1 && !isCheap(id);
    if (isShared || it.output || it.depth >= options_.maxDepth) makeStatement(id);
  }

  // Not worth a temporary: a known int, the negative of a variable, and one of several results.
  bool isCheap(NodeId id) const {
    if (graph_.isResult(id) || graph_.isKnownInt(id)) return true;
    return graph_.is(id, ops::find("neg")) && graph_.isLeaf(graph_.operand(id, 0));
  }

  void makeStatement(NodeId id) {
    State& it = state(id);
    it.statement = add({id, it.output}, it.reads);
  }

  std::uint32_t add(const Statement& statement, Set reads) {
    made_.all.push_back(statement);
    made_.work.tasks.push_back({reads.first, reads.count, statement.output != nullptr});
    return static_cast<std::uint32_t>(made_.all.size() - 1);
  }

  Set readsOfOperands(NodeId id) {
    // Most operations read what one of their operands does, and share its set.
    if (graph_.arity(id) == 1 && state(graph_.operand(id, 0)).statement == none)
      return state(graph_.operand(id, 0)).reads;
    Set set = emptySet();
    for (int i = 0; i < graph_.arity(id); ++i) include(set, graph_.operand(id, i));
    return set;
  }

  // Operands with many reads get statements, those with the most first, until few enough are left.
  Set readFewer(NodeId id) {
    Set set = state(id).reads;
    while (set.count > options_.maxReads) {
      const NodeId* widest = nullptr;
      Operands<NodeId> operands{};
      for (int i = 0; i < graph_.arity(id); ++i) {
        operands[i] = graph_.operand(id, i);
        if (graph_.isList(operands[i]) || readsWhereWritten(operands[i]) < 2) continue;
        if (!widest || readsWhereWritten(operands[i]) > readsWhereWritten(*widest))
          widest = &operands[i];
      }
      if (!widest) break;
      makeStatement(*widest);
      set = readsOfOperands(id);
    }
    return set;
  }

  // How many statements the text of a node reads, if it is written where it is used.
  std::uint32_t readsWhereWritten(NodeId id) {
    return state(id).statement == none ? state(id).reads.count : 0;
  }

  Set emptySet() const { return {static_cast<std::uint32_t>(made_.work.reads.size()), 0}; }

  // Adds what is read where the node is used. The set must be the last one.
  void include(Set& set, NodeId id) {
    const State& it = state(id);
    if (it.statement != none) return include(set, it.statement);
    for (std::uint32_t i = 0; i < it.reads.count; ++i)
      include(set, made_.work.reads[it.reads.first + i]);
  }

  void include(Set& set, std::uint32_t statement) {
    const auto begin = made_.work.reads.begin() + set.first;
    if (std::find(begin, made_.work.reads.end(), statement) != made_.work.reads.end()) return;
    made_.work.reads.push_back(statement);
    ++set.count;
  }

  void assign(const Output& output, const std::optional<Sum>& sum) {
    const NodeId first = output.components[0];
    Set set = emptySet();
    if (sum) {
      include(set, assigned_[sum->output]);
    } else if (state(first).output == &output) {
      return assigned_.push_back(state(first).statement);
    } else {
      for (const NodeId component : output.components) include(set, component);
    }
    assigned_.push_back(add({{}, &output}, set));
  }

  const Graph& graph_;
  std::span<const Output> outputs_;
  std::span<const std::optional<Sum>> sums_;
  const EmitOptions& options_;
  std::vector<State> states_;            // by node
  std::vector<std::uint32_t> assigned_;  // by output, its statement
  Statements made_;
};

}  // namespace

Statements makeStatements(const Graph& graph, std::span<const NodeId> nodes,
                          std::span<const Output> outputs, std::span<const std::optional<Sum>> sums,
                          const EmitOptions& options) {
  return Maker(graph, outputs, sums, options).run(nodes);
}

}  // namespace warpjet
