#include "emit/lower.hpp"

#include <algorithm>
#include <type_traits>

#include "graph/expression.hpp"
#include "graph/reachable.hpp"
#include "ops/rows.hpp"

namespace warpjet {

namespace {

using Formula = NodeId (*)(Graph&, const Operands<NodeId>&);

template <std::size_t Row>
NodeId applyFormula(Graph& graph, const Operands<NodeId>& operands) {
  Operands<Expression> x{};
  for (int i = 0; i < ops::declarations[Row].arity; ++i) x[i] = {&graph, operands[i]};
  constexpr auto formula = std::get<Row>(ops::table).lowered;
  return ops::applyTo<ops::declarations[Row].arity>(formula, x.data()).id;
}

template <std::size_t Row>
constexpr bool hasFormula =
    !std::is_same_v<decltype(std::get<Row>(ops::table).lowered), ops::NoFormula>;

template <std::size_t Row>
constexpr Formula formulaOf() {
  constexpr auto spellings = std::get<Row>(ops::table).spellings.byLanguage;
  constexpr bool isMissing = std::any_of(spellings.begin(), spellings.end(),
                                         [](const auto& spelling) { return spelling.isMissing(); });
  static_assert(hasFormula<Row> || !isMissing || ops::declarations[Row].signature.hasInt(),
                "a row that a language lacks must say what it is lowered to");
  if constexpr (hasFormula<Row>) {
    return &applyFormula<Row>;
  } else {
    return nullptr;
  }
}

// Null if every language has the operation, or if languages without it reject it.
constexpr auto formulas =
    ops::withIndices<ops::count>([](auto... row) { return std::array{formulaOf<row>()...}; });

bool lacks(ops::Language language, Op op) { return ops::spelling(op, language).isMissing(); }

class Lowering {
 public:
  Lowering(Graph& graph, ops::Language language, Comments& comments)
      : graph_(graph), language_(language), comments_(comments), lowered_(graph.size()) {}

  // Operands are visited before their users.
  void visit(NodeId id) {
    if (graph_.isLeaf(id) || graph_.isList(id) || graph_.isStateOrList(id)) return;
    const NodeId first = end();
    lowered_[index(id)] = replacement(id);
    const Comments::Range* comment = comments_.find(id);
    if (comment && first != end()) comments_.ranges.push_back({first, end(), comment->text});
  }

  NodeId lowered(NodeId id) const { return graph_.isLeaf(id) ? id : lowered_[index(id)]; }

 private:
  NodeId replacement(NodeId id) {
    if (graph_.isCall(id)) return visitCall(id);
    if (graph_.isResult(id))
      return graph_.result(lowered(graph_.operand(id, 0)), graph_.resultNumber(id));
    if (graph_.isFold(id)) return visitFold(id);
    if (graph_.isOutcome(id))
      return graph_.outcome(lowered(graph_.operand(id, 0)), graph_.operand(id, 1));
    return visitOperation(id);
  }

  NodeId visitFold(NodeId id) {
    std::vector<State> states = graph_.states(id);
    for (auto& [local, start, next] : states) {
      start = lowered(start);
      next = lowered(next);
    }
    return graph_.fold(graph_.loopOf(id), states);
  }

  NodeId visitOperation(NodeId id) {
    Operands<NodeId> operands{};
    bool changed = false;
    for (int i = 0; i < graph_.arity(id); ++i) {
      operands[i] = lowered(graph_.operand(id, i));
      changed |= operands[i] != graph_.operand(id, i);
    }
    const Op op = graph_.node(id).op;
    if (lacks(language_, op) && formulas[index(op)]) return formulas[index(op)](graph_, operands);
    return changed ? graph_.apply(op, operands) : id;
  }

  NodeId visitCall(NodeId id) {
    std::vector<NodeId> arguments = graph_.arguments(id);
    for (NodeId& argument : arguments) argument = lowered(argument);
    return graph_.call(graph_.node(id).operands[1], arguments);
  }

  NodeId end() const { return NodeId{static_cast<std::uint32_t>(graph_.size())}; }

  Graph& graph_;
  ops::Language language_;
  Comments& comments_;
  std::vector<NodeId> lowered_;  // by node
};

}  // namespace

std::string_view findUnsupported(const Graph& graph, std::span<const NodeId> roots,
                                 ops::Language language) {
  if (!lacksAny(graph, language)) return {};
  for (const NodeId id : reachable(graph, roots)) {
    if (!graph.isOperation(id)) continue;
    const Op op = graph.node(id).op;
    if (lacks(language, op) && !formulas[index(op)]) return ops::declaration(op).name;
  }
  return {};
}

bool lacksAny(const Graph& graph, ops::Language language) {
  for (std::size_t row = 0; row < ops::count; ++row) {
    if (graph.has(Op(row)) && lacks(language, Op(row))) return true;
  }
  return false;
}

std::vector<NodeId> lower(Graph& graph, std::span<const NodeId> roots, ops::Language language,
                          Comments& comments) {
  if (!lacksAny(graph, language)) return {roots.begin(), roots.end()};
  Lowering lowering(graph, language, comments);
  for (const NodeId id : reachable(graph, roots)) lowering.visit(id);
  std::vector<NodeId> found(roots.size());
  std::transform(roots.begin(), roots.end(), found.begin(),
                 [&](NodeId root) { return lowering.lowered(root); });
  return found;
}

}  // namespace warpjet
