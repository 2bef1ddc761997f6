#include "emit/lower.hpp"

#include <algorithm>
#include <type_traits>

#include "emit/rewriter.hpp"
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

// The formula that replaces each operation. Null if every language has the operation, or if
// languages without it reject it (see findUnsupported): these are operations on ints.
constexpr auto formulas =
    ops::withIndices<ops::count>([](auto... row) { return std::array{formulaOf<row>()...}; });

bool isMissing(Op op, ops::Language language) { return ops::spelling(op, language).isMissing(); }

class Lowering : public Rewriter {
 public:
  Lowering(Graph& graph, ops::Language language, Comments& comments)
      : Rewriter(graph, comments), language_(language) {}

 private:
  NodeId replaceOperation(NodeId id) override {
    const Op op = graph_.node(id).op;
    return isMissing(op, language_) && formulas[index(op)]
               ? formulas[index(op)](graph_, newOperands(id))
               : Rewriter::replaceOperation(id);
  }

  ops::Language language_;
};

}  // namespace

std::optional<Op> findUnsupported(const Graph& graph, std::span<const NodeId> roots,
                                  ops::Language language) {
  if (!usesMissing(graph, language)) return std::nullopt;
  for (const NodeId id : reachable(graph, roots)) {
    if (!graph.isOperation(id)) continue;
    const Op op = graph.node(id).op;
    if (isMissing(op, language) && !formulas[index(op)]) return op;
  }
  return std::nullopt;
}

bool usesMissing(const Graph& graph, ops::Language language) {
  for (std::size_t row = 0; row < ops::count; ++row) {
    if (graph.has(Op(row)) && isMissing(Op(row), language)) return true;
  }
  return false;
}

std::vector<NodeId> lower(Graph& graph, std::span<const NodeId> roots, ops::Language language,
                          Comments& comments) {
  if (!usesMissing(graph, language)) return {roots.begin(), roots.end()};
  return Lowering(graph, language, comments).rewrite(roots);
}

}  // namespace warpjet
