#include "graph/rotations.hpp"

#include <cmath>
#include <utility>

namespace warpjet {

namespace {

using patterns::Identity, patterns::Item, patterns::Kind, patterns::Pattern;

constexpr Op Neg = ops::find("neg"), Add = ops::find("add"), Sub = ops::find("sub"),
             Mult = ops::find("mult"), Sin = ops::find("sin"), Cos = ops::find("cos");

// A node, or its negation.
struct Term {
  NodeId node;
  bool isNegative;
};

// Stands for a missing factor, which is 1.
constexpr NodeId missing = noNode;

// Matches a sum of two products with the sum of an identity. Goals are solved in the order in which
// they arise, so that the likeliest to fail comes first: whether one factor of each product is the
// cosine or sine, and only then what the other factors are. If a goal has two solutions, the first
// is tried; if the match fails later, everything restarts with the last such choice reversed.
class RotationMatcher {
 public:
  RotationMatcher(Graph& graph, const Pattern& sum) : graph_(graph), sum_(sum.items.data()) {}

  bool matches(Term first, Term second) {
    do {
      if (solve(first, second)) return true;
    } while (chooseOtherwise());
    return false;
  }

  NodeId build(const Pattern& pattern) {
    const NodeId value = build(pattern.items.data());
    return isNegative_ ? graph_.apply(Neg, {value}) : value;
  }

 private:
  NodeId build(const Item* item) {
    if (item->kind != Kind::Operation) return toNode(bindings_[item->number]);
    const NodeId left = build(item + 1);
    return graph_.apply(item->op(), {left, build(item + 1 + item[1].size)});
  }

  struct Goal {
    const Item* item;
    Term term;
  };

  bool solve(Term first, Term second) {
    isBound_ = 0;
    choice_ = 0;
    goalCount_ = 0;
    if (choose()) std::swap(first, second);
    // A minus of the first term is factored out of the sum.
    isNegative_ = first.isNegative;
    addTerms(sum_, {first.node, false}, {second.node, second.isNegative != isNegative_});
    for (std::size_t i = 0; i < goalCount_; ++i) {
      if (!solve(goals_[i])) return false;
    }
    return true;
  }

  // Called for each goal with two solutions. Returns true if the second one is to be tried.
  bool choose() {
    if (choice_ == choiceCount_) isOtherwise_[choiceCount_++] = false;
    return isOtherwise_[choice_++];
  }

  // Reverses the last choice that can be reversed. Returns false if there is none.
  bool chooseOtherwise() {
    while (choiceCount_ > 0 && isOtherwise_[choiceCount_ - 1]) --choiceCount_;
    if (choiceCount_ == 0) return false;
    isOtherwise_[choiceCount_ - 1] = true;
    return true;
  }

  void add(const Item* item, Term term) {
    for (; graph_.is(term.node, Neg); term.node = graph_.operand(term.node, 0))
      term.isNegative = !term.isNegative;
    goals_[goalCount_++] = {item, term};
  }

  void addTerms(const Item* item, Term first, Term second) {
    second.isNegative = second.isNegative != item->is(Sub);
    add(item + 1, first);
    add(item + 1 + item[1].size, second);
  }

  bool solve(const Goal& goal) {
    const auto [item, term] = goal;
    if (item->kind != Kind::Operation) return bind(item, term);
    if (item->is(Mult))
      return item[1].kind == Kind::Factor ? solveFactor(item, term) : solveWave(item, term);
    const bool isDifference = graph_.is(term.node, Sub);
    if (!isDifference && !graph_.is(term.node, Add)) return false;
    Term first{graph_.operand(term.node, 0), term.isNegative};
    Term second{graph_.operand(term.node, 1), term.isNegative != isDifference};
    if (choose()) std::swap(first, second);
    addTerms(item, first, second);
    return true;
  }

  // Solves k * …. If k is a constant, it may have the opposite sign in the second product; the
  // minus then moves to the rest.
  bool solveFactor(const Item* item, Term term) {
    const Item *factor = item + 1, *rest = item + 2;
    if (!graph_.is(term.node, Mult) || !choose()) {
      add(rest, term);
      return bind(factor, {missing, false});
    }
    const int operand = choose();
    const Term found{graph_.operand(term.node, operand), false};
    const Term other{graph_.operand(term.node, 1 - operand), term.isNegative};
    const bool isOpposite = !bind(factor, found);
    add(rest, {other.node, other.isNegative != isOpposite});
    return !isOpposite || isSame(bindings_[factor->number], {found.node, true});
  }

  // Solves … * cos(u) or … * sin(u). A minus moves to the other factor.
  bool solveWave(const Item* item, Term term) {
    const Item *other = item + 1, *wave = other + other->size;
    if (isWave(wave, term.node)) {
      return bind(other, {missing, term.isNegative}) &&
             bind(wave + 1, {graph_.operand(term.node, 0), false});
    }
    if (!graph_.is(term.node, Mult)) return false;
    int operand = isWave(wave, graph_.operand(term.node, 0)) ? 0 : 1;
    const NodeId second = graph_.operand(term.node, 1);
    if (operand == 0 && isWave(wave, second) && choose()) operand = 1;
    const NodeId node = graph_.operand(term.node, operand);
    if (!isWave(wave, node)) return false;
    add(other, {graph_.operand(term.node, 1 - operand), term.isNegative});
    return bind(wave + 1, {graph_.operand(node, 0), false});
  }

  bool isWave(const Item* wave, NodeId id) const { return graph_.is(id, wave->op()); }

  // Returns false if the variable is bound to another term. A constant includes its minus.
  bool bind(const Item* variable, Term term) {
    if (!variable->isVariable()) return false;
    const std::uint32_t bit = std::uint32_t{1} << variable->number;
    Term& bound = bindings_[variable->number];
    if ((isBound_ & bit) != 0) return isSame(bound, term);
    isBound_ |= bit;
    bound = term;
    return true;
  }

  bool isSame(Term a, Term b) const {
    if (a.node == b.node) return a.isNegative == b.isNegative;
    if (a.node == missing || b.node == missing) return false;
    return graph_.isConstant(a.node) && graph_.isConstant(b.node) && valueOf(a) == valueOf(b);
  }

  double valueOf(Term constant) const {
    const double value = graph_.value(constant.node);
    return constant.isNegative ? -value : value;
  }

  NodeId toNode(Term term) {
    if (term.node == missing) return graph_.constant(term.isNegative ? -1 : 1);
    return term.isNegative ? graph_.apply(Neg, {term.node}) : term.node;
  }

  Graph& graph_;
  const Item* sum_;
  bool isNegative_ = false;
  std::uint32_t isBound_ = 0;
  std::array<Term, 26> bindings_;
  std::size_t choice_ = 0, choiceCount_ = 0, goalCount_ = 0;
  std::array<bool, 24> isOtherwise_;
  std::array<Goal, 24> goals_;
};

// Returns true if the products have a sine and a cosine of the same angle, one each.
bool haveSineAndCosine(const Graph& graph, NodeId first, NodeId second) {
  for (int i = 0; i < 4; ++i) {
    const NodeId x = graph.operand(first, i / 2), y = graph.operand(second, i % 2);
    const bool isPair =
        (graph.is(x, Cos) && graph.is(y, Sin)) || (graph.is(x, Sin) && graph.is(y, Cos));
    if (isPair && graph.operand(x, 0) == graph.operand(y, 0)) return true;
  }
  return false;
}

}  // namespace

// Cold and out of line: a warp has thousands of sums, and most of them are not rotations.
[[gnu::noinline, gnu::cold]] std::optional<NodeId> cancelRotation(Graph& graph, Op op, NodeId first,
                                                                  NodeId second) {
  const bool isNegative = graph.is(first, Neg);
  const NodeId product = isNegative ? graph.operand(first, 0) : first;
  if (!graph.is(product, Mult) || !graph.is(second, Mult)) return {};
  if (!haveSineAndCosine(graph, product, second)) return {};
  for (const Identity& identity : patterns::turns) {
    RotationMatcher matcher(graph, identity.from);
    if (matcher.matches({product, isNegative}, {second, op == Sub}))
      return matcher.build(identity.to);
  }
  return {};
}

}  // namespace warpjet
