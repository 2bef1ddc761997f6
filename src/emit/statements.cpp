#include "emit/statements.hpp"

#include <algorithm>

namespace warpjet {

void Statements::include(Set& set, std::uint32_t statement) {
  const auto begin = work.reads.begin() + set.first;
  if (std::find(begin, work.reads.end(), statement) != work.reads.end()) return;
  work.reads.push_back(statement);
  ++set.count;
}

std::uint32_t Statements::add(const Statement& statement, Set reads) {
  all.push_back(statement);
  work.tasks.push_back({reads.first, reads.count, statement.output != nullptr});
  return static_cast<std::uint32_t>(all.size() - 1);
}

namespace {

class Maker {
 public:
  Maker(const Graph& graph, std::span<const std::uint32_t> uses, const Loops* loops,
        std::span<const Output> outputs, std::span<const std::optional<Sum>> sums,
        const Flags& uncut, const EmitOptions& options)
      : graph_(graph),
        uses_(uses),
        loops_(loops),
        outputs_(outputs),
        sums_(sums),
        uncut_(uncut),
        options_(options),
        infos_(graph.size()),
        all_(loops ? graph.loopCount() + 1 : 1) {}

  std::vector<Statements> run(std::span<const NodeId> nodes) {
    findScalarOutputs();
    for (const NodeId id : nodes) {
      if (graph_.isOperation(id) && ops::isChoice(graph_.node(id).op)) nameBranches(id);
    }
    if (loops_) findCaptured();
    for (const NodeId id : loops_ ? std::span(loops_->order()) : nodes) {
      if (!graph_.isLeaf(id)) visit(id);
    }
    made_ = &all_[0];
    for (std::size_t i = 0; i < outputs_.size(); ++i) assign(outputs_[i], sums_[i]);
    return std::move(all_);
  }

 private:
  using Set = Statements::Set;

  struct NodeInfo {
    std::uint32_t statement = none;
    int depth = 0;  // of the operations in its expression
    Set reads;      // of its expression
    const Output* output = nullptr;
    bool isForced = false;
    bool isChosen = false;  // true for a branch of a conditional
  };

  NodeInfo& info(NodeId id) { return infos_[index(id)]; }

  // Assigns each scalar result where it is computed, so that it needs no temporary.
  void findScalarOutputs() {
    for (const Output& output : outputs_) {
      const NodeId id = output.components[0];
      if (output.shape.isNumber() && !graph_.isLeaf(id) && !info(id).output)
        info(id).output = &output;
    }
  }

  // Gives both sides of a choice names. ANGLE, which translates GLSL in browsers, compiles `c ? a :
  // b` to a branch unless a and b are names or literals. A few branches do no harm; but SwiftShader
  // takes 3 s to compile 4D noise with 48 of them, and 0.08 s without. GPUs compute both sides
  // anyway, as does WGSL's select.
  void nameBranches(NodeId choice) {
    for (const int i : {1, 2}) {
      const NodeId id = graph_.operand(choice, i);
      info(id).isChosen = !isWrittenAsName(id);
    }
  }

  std::uint32_t loopOf(NodeId id) const { return loops_ ? loops_->loopOf(id) : Loops::outside; }

  // Values from outside that a body reads become temporaries before it; the new values of states
  // become temporaries in it.
  [[gnu::noinline, gnu::cold]] void findCaptured() {
    captured_.resize(graph_.loopCount());
    for (const NodeId id : loops_->order()) {
      if (graph_.isFold(id)) {
        const std::uint32_t loop = graph_.loopOf(id);
        for (const auto& [local, start, next] : loops_->statesOf(loop)) {
          info(next).isForced = true;
          read(start, loops_->loopOf(id));
          read(next, loop);
        }
      } else if (!graph_.isOutcome(id)) {
        for (int i = 0; i < graph_.arity(id); ++i) read(graph_.operand(id, i), loopOf(id));
      }
    }
  }

  // Records that the body of `loop`, or the code outside of all loops, reads the node.
  void read(NodeId id, std::uint32_t loop) {
    if (loopOf(id) == loop) return;
    if (graph_.isList(id)) {
      for (int i = 0; i < graph_.arity(id); ++i) read(graph_.operand(id, i), loop);
      return;
    }
    info(id).isForced = true;
    for (; loop != loopOf(id); loop = loops_->parentOf(loop)) captured_[loop].push_back(id);
  }

  [[gnu::noinline, gnu::cold]] void visitFold(NodeId id) {
    const std::uint32_t loop = graph_.loopOf(id);
    if (loopStatements_.empty()) loopStatements_.resize(graph_.loopCount(), none);
    std::uint32_t& statement = loopStatements_[loop];
    if (statement == none) {
      Set set = made_->emptySet();
      for (const auto& [local, start, next] : loops_->statesOf(loop)) include(set, start);
      for (const NodeId read : captured_[loop]) include(set, read);
      statement = made_->add({id}, set);
    }
    info(id).statement = statement;
  }

  // Decides whether the node becomes a statement. Operands must be visited before their users.
  void visit(NodeId id) {
    loop_ = loopOf(id);
    made_ = &all_[loop_ == Loops::outside ? 0 : loop_ + 1];
    if (graph_.isFold(id)) return visitFold(id);
    NodeInfo& node = info(id);
    node.reads = readsOfOperands(id);
    const bool canBeCut = !graph_.isList(id) && !uncut_[index(id)];
    if (canBeCut && node.reads.count > options_.maxReads) node.reads = readFewer(id);

    for (int i = 0; i < graph_.arity(id); ++i) {
      const NodeInfo& operand = info(graph_.operand(id, i));
      if (operand.statement == none) node.depth = std::max(node.depth, operand.depth);
    }
    if (graph_.isList(id)) return;
    if (graph_.isLibraryCall(id)) return makeStatement(id);
    ++node.depth;
    const bool isShared = (uses_[index(id)] > 1 || node.isForced) && !isCheap(id);
    if (isShared || node.isChosen || node.output || (canBeCut && node.depth >= options_.maxDepth))
      makeStatement(id);
  }

  bool isWrittenAsName(NodeId id) const {
    return graph_.isResult(id) || graph_.isOutcome(id) || graph_.isKnownInt(id);
  }

  // Returns true if a temporary would gain nothing: the node is written as a name, or is the
  // negative of a variable.
  bool isCheap(NodeId id) const {
    if (isWrittenAsName(id)) return true;
    return graph_.is(id, ops::find("neg")) && graph_.isLeaf(graph_.operand(id, 0));
  }

  void makeStatement(NodeId id) {
    NodeInfo& node = info(id);
    node.statement = made_->add({id, node.output}, node.reads);
  }

  Set readsOfOperands(NodeId id) {
    // Most operations have the same reads as one of their operands, and share its set.
    const bool isUnary = graph_.arity(id) == 1 && loopOf(graph_.operand(id, 0)) == loop_;
    if (isUnary && info(graph_.operand(id, 0)).statement == none)
      return info(graph_.operand(id, 0)).reads;
    Set set = made_->emptySet();
    for (int i = 0; i < graph_.arity(id); ++i) include(set, graph_.operand(id, i));
    return set;
  }

  // Turns operands with many reads into statements, those with the most first, until few enough
  // reads remain.
  Set readFewer(NodeId id) {
    Set set = info(id).reads;
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

  // Returns the number of statements that the expression of a node reads, if it is written inline.
  std::uint32_t readsWhereWritten(NodeId id) {
    return info(id).statement == none ? info(id).reads.count : 0;
  }

  // Adds the reads of an operand's expression to `set`, which must be the last set of `made_`.
  void include(Set& set, NodeId id) {
    if (loopOf(id) != loop_) return;  // computed before the body begins
    const NodeInfo& node = info(id);
    if (node.statement != none) return made_->include(set, node.statement);
    for (std::uint32_t i = 0; i < node.reads.count; ++i)
      made_->include(set, made_->work.reads[node.reads.first + i]);
  }

  void assign(const Output& output, const std::optional<Sum>& sum) {
    const NodeId first = output.components[0];
    Set set = made_->emptySet();
    if (sum) {
      made_->include(set, assigned_[sum->output]);
    } else if (info(first).output == &output) {
      return assigned_.push_back(info(first).statement);
    } else {
      for (const NodeId component : output.components) include(set, component);
    }
    assigned_.push_back(made_->add({noNode, &output}, set));
  }

  const Graph& graph_;
  std::span<const std::uint32_t> uses_;  // by node
  const Loops* loops_;
  std::span<const Output> outputs_;
  std::span<const std::optional<Sum>> sums_;
  const Flags& uncut_;  // by node: may exceed maxReads and maxDepth
  const EmitOptions& options_;
  std::vector<NodeInfo> infos_;          // by node
  std::vector<std::uint32_t> assigned_;  // by output: its statement
  std::vector<std::vector<NodeId>>
      captured_;  // by loop: the nodes from outside that its body reads
  std::vector<std::uint32_t> loopStatements_;  // by loop
  std::vector<Statements> all_;                // outside of all loops, then by loop
  std::uint32_t loop_ = Loops::outside;        // the loop whose statements are being made
  Statements* made_ = nullptr;                 // the statements of that loop
};

}  // namespace

std::vector<Statements> makeStatements(const Graph& graph, std::span<const NodeId> nodes,
                                       std::span<const std::uint32_t> uses, const Loops* loops,
                                       std::span<const Output> outputs,
                                       std::span<const std::optional<Sum>> sums,
                                       const MatrixProducts& products, const EmitOptions& options) {
  return Maker(graph, uses, loops, outputs, sums, products.terms, options).run(nodes);
}

}  // namespace warpjet
