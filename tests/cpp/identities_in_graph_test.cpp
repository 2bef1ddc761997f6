// Identities in a graph: each one is applied, and no two of them undo each other forever.
#include <gtest/gtest.h>

#include <optional>

#include "graph/match.hpp"
#include "graph/pattern_text.hpp"
#include "graph/print.hpp"
#include "identity_support.hpp"

namespace warpjet::identities {
namespace {

// Builds an identity's two patterns in a graph, with a node for each variable. Its constants
// satisfy the condition.
class Instance {
 public:
  Instance(Graph& graph, Chance& chance) : graph_(graph), chance_(chance) {}

  // Builds the pattern that the identity replaces.
  NodeId operator()(const Identity& identity) { return build(identity, identity.from); }
  NodeId replacement(const Identity& identity) { return build(identity, identity.to); }

  // Binds a variable to a node instead of an input.
  void let(std::size_t letter, NodeId node) { nodes_[letter] = node; }

  void draw(const Identity& identity) {
    std::optional<At> at;
    while (!at) at = drawPoint(identity, chance_, {true});
    const Variables variables(identity.from);
    for (std::size_t i = 0; i < letters; ++i) {
      if (variables.kinds[i] == Kind::Constant) nodes_[i] = graph_.constant((*at)[i]);
      if (!variables.kinds[i] || nodes_[i]) continue;
      const Expression input = scalar(graph_, std::string(1, static_cast<char>('a' + i)));
      nodes_[i] = variables.types[i] == ops::Type::Bool  ? gt(input, 0.0).id
                  : variables.types[i] == ops::Type::Int ? graph_.apply(rowNamed("int"), {input.id})
                                                         : input.id;
    }
  }

 private:
  NodeId build(const Identity& identity, const Pattern& pattern) {
    if (!isDrawn_) draw(identity), isDrawn_ = true;
    return visit(pattern.items.data());
  }

  NodeId visit(const Item* item) {
    if (item->isVariable()) return *nodes_[item->number];
    if (item->kind == Kind::Literal && item->type == ops::Type::Bool)
      return graph_.apply(rowNamed("bool"), {graph_.constant(item->value)});
    if (item->isKnown) return graph_.constant(valueOf(item));
    Operands<NodeId> operands{};
    const Item* operand = item + 1;
    for (int i = 0; i < ops::declaration(item->op()).arity; ++i, operand += operand->size)
      operands[i] = visit(operand);
    return graph_.apply(item->op(), operands);
  }

  double valueOf(const Item* item) const {
    if (item->isVariable()) return graph_.value(*nodes_[item->number]);
    if (item->kind == Kind::Literal) return item->value;
    if (item->kind == Kind::Function) return item->function->valueOf(valueOf(item + 1));
    Operands<double> x{};
    const Item* operand = item + 1;
    for (int i = 0; i < ops::declaration(item->op()).arity; ++i, operand += operand->size)
      x[i] = valueOf(operand);
    return ops::valueOf(item->op(), x);
  }

  Graph& graph_;
  Chance& chance_;
  bool isDrawn_ = false;
  std::array<std::optional<NodeId>, letters> nodes_;
};

TEST(Identities, AreAppliedInAGraph) {
  Chance chance;
  for (const Identity& identity : patterns::identities) {
    for (int i = 0; i < 20; ++i) {
      Graph graph;
      Instance instance(graph, chance);
      const NodeId found = instance(identity), expected = instance.replacement(identity);
      EXPECT_EQ(nameOf(graph, found), nameOf(graph, expected))
          << text(identity) << '\n'
          << print(graph, std::array{found, expected});
    }
  }
}

// Applies only the rules, step by step. Unlike a graph, it stops when there are too many steps.
class Rewriter {
 public:
  static constexpr int maxSteps = 300;

  explicit Rewriter(Graph& unsimplified) : graph_(unsimplified) {}

  int steps = 0;

  NodeId apply(Op op, Operands<NodeId> operands) {
    if (const auto known = foldConstants(op, operands)) return *known;
    if (ops::has(op, ops::Trait::Commutative) && graph_.isConstant(operands[0]))
      std::swap(operands[0], operands[1]);
    patterns::Bindings bindings;
    const std::uint32_t candidates = patterns::findCandidates(graph_, op, operands);
    const patterns::Rule* rule =
        candidates == 0 ? nullptr : patterns::findRule(graph_, op, operands, candidates, bindings);
    if (!rule || steps == maxSteps) return graph_.apply(op, operands);
    ++steps;
    const auto again = [this](Op made, const Operands<NodeId>& x) { return apply(made, x); };
    return patterns::build(graph_, &patterns::rules.items[rule->to], bindings, again);
  }

  // Copies a node of another graph, with everything that it is computed from.
  NodeId rewrite(const Graph& other, NodeId root) {
    std::map<NodeId, NodeId> made;
    for (const NodeId id : reachable(other, {&root, 1})) {
      if (other.isConstant(id)) {
        made[id] = graph_.constant(other.value(id));
      } else if (other.isInput(id)) {
        made[id] = scalar(graph_, other.input(other.node(id).operands[0]).label).id;
      } else {
        Operands<NodeId> operands{};
        for (int i = 0; i < other.arity(id); ++i) operands[i] = made[other.operand(id, i)];
        made[id] = apply(other.node(id).op, operands);
      }
    }
    return made[root];
  }

 private:
  std::optional<NodeId> foldConstants(Op op, const Operands<NodeId>& operands) {
    if (ops::declaration(op).signature.result != ops::Type::Float) return std::nullopt;
    Operands<double> x{};
    for (int i = 0; i < ops::declaration(op).arity; ++i) {
      if (!graph_.isConstant(operands[i])) return std::nullopt;
      x[i] = graph_.value(operands[i]);
    }
    const double value = ops::valueOf(op, x);
    return std::isfinite(value) ? std::optional(graph_.constant(value)) : std::nullopt;
  }

  Graph& graph_;
};

// Replaces each variable of every identity by every identity.
TEST(Identities, TerminateAndLeaveNothingToSimplify) {
  constexpr auto off = Graph::Simplification::Off;
  Chance chance;
  int pairs = 0;
  for (const Identity& outer : patterns::identities) {
    const Variables variables(outer.from);
    for (const Identity& inner : patterns::identities) {
      const ops::Type type = ops::declaration(inner.from.root().op()).signature.result;
      for (std::size_t letter = 0; letter < letters; ++letter) {
        const auto kind = variables.kinds[letter];
        if (!kind || kind == Kind::Constant || variables.types[letter] != type) continue;
        Graph source(Graph::maxNodes, off), graph(Graph::maxNodes, off);
        Instance operand(source, chance), composed(source, chance);
        composed.let(letter, operand(inner));
        const NodeId root = composed(outer);

        Rewriter first(graph);
        const NodeId simple = first.rewrite(source, root);
        EXPECT_LT(first.steps, Rewriter::maxSteps) << text(outer) << "; " << text(inner);
        Rewriter second(graph);
        EXPECT_EQ(second.rewrite(graph, simple), simple);
        EXPECT_EQ(second.steps, 0) << text(outer) << "; " << text(inner) << '\n'
                                   << print(graph, {&simple, 1});
        ++pairs;
        if (HasFailure()) return;
      }
    }
  }
  EXPECT_GT(pairs, 2000);
}

class Simplification : public testing::Test {
 protected:
  Graph graph;
  Expression x = scalar(graph, "x"), y = scalar(graph, "y"), u = scalar(graph, "u");
  Expression positive = gt(x, 0.0);

  std::string simplified(Expression root) const { return expression(root.id); }

 private:
  // Returns the expression as nested calls.
  std::string expression(NodeId id) const {
    if (graph.isLeaf(id)) return nameOf(graph, id);
    std::string all = std::string(ops::declaration(graph.node(id).op).name) + "(";
    for (int i = 0; i < graph.arity(id); ++i)
      all += (i == 0 ? "" : ", ") + expression(graph.operand(id, i));
    return all + ")";
  }
};

TEST_F(Simplification, FoldsConstantsAndSignsOfSums) {
  EXPECT_EQ(simplified(x + -y), "sub(x, y)");
  EXPECT_EQ(simplified(-x + y), "sub(y, x)");
  EXPECT_EQ(simplified(2.0 + x), "add(x, 2)");
  EXPECT_EQ(simplified(x + -2.0), "sub(x, 2)");
  EXPECT_EQ(simplified(x - 500.0 + 500.0), "x");
  EXPECT_EQ(simplified(x - 3.0 - 4.0), "sub(x, 7)");
  EXPECT_EQ(simplified(x + x), "mult(x, 2)");
  // These look similar, but are not simplified in this way.
  EXPECT_EQ(simplified(x + y), "add(x, y)");
  EXPECT_EQ(simplified(x + y + 2.0), "add(add(x, y), 2)");
  EXPECT_EQ(simplified(x + 1e-39 + 1e-39), "add(add(x, 1e-39), 1e-39)");
  EXPECT_EQ(simplified(-x - y), "sub(neg(x), y)");
}

TEST_F(Simplification, FoldsFactorsOfProducts) {
  EXPECT_EQ(simplified(x * 0.0), "0");
  EXPECT_EQ(simplified(x * ifElse(positive, 1.0, 0.0)), "ifElse(gt(x, 0), x, 0)");
  EXPECT_EQ(simplified(ifElse(positive, 0.0, 1.0) * x), "ifElse(gt(x, 0), 0, x)");
  EXPECT_EQ(simplified(-x * -y), "mult(x, y)");
  EXPECT_EQ(simplified(-x * 3.0), "mult(x, -3)");
  EXPECT_EQ(simplified(x * 2.0 * 4.0), "mult(x, 8)");
  EXPECT_EQ(simplified(x * (1.0 / y)), "div(x, y)");
  EXPECT_EQ(simplified(x / sqrt(x)), "sqrt(x)");
  // These look similar, but are not simplified in this way.
  EXPECT_EQ(simplified(x * ifElse(positive, 1.0, 2.0)), "mult(x, ifElse(gt(x, 0), 1, 2))");
  EXPECT_EQ(simplified(x * 1e-30 * 1e-30), "mult(mult(x, 1e-30), 1e-30)");
  EXPECT_EQ(simplified(x * (2.0 / y)), "mult(x, div(2, y))");
  EXPECT_EQ(simplified(y / sqrt(x)), "div(y, sqrt(x))");
}

TEST_F(Simplification, ExpandsSmallIntegerPowers) {
  EXPECT_EQ(simplified(pow(x, 0.0)), "1");
  EXPECT_EQ(simplified(pow(x, 2.0)), "mult(x, x)");
  EXPECT_EQ(simplified(pow(x, 3.0)), "mult(x, mult(x, x))");
  EXPECT_EQ(simplified(pow(x, -2.0)), "div(1, mult(x, x))");
  EXPECT_EQ(simplified(pow(x, 6.0)), "mult(mult(x, x), mult(mult(x, x), mult(x, x)))");
  EXPECT_EQ(simplified(pow(x, 0.5)), "pow(x, 0.5)");
  EXPECT_EQ(simplified(pow(x, 17.0)), "pow(x, 17)");
  EXPECT_EQ(simplified(pow(x, y)), "pow(x, y)");
}

TEST_F(Simplification, MergesSumsOfChoicesOnOneCondition) {
  EXPECT_EQ(simplified(ifElse(positive, x, 0.0) + ifElse(positive, 0.0, y)),
            "ifElse(gt(x, 0), x, y)");
  EXPECT_EQ(simplified(ifElse(positive, 0.0, x) + ifElse(positive, y, 0.0)),
            "ifElse(gt(x, 0), y, x)");
  EXPECT_EQ(simplified(ifElse(positive, x, 0.0) + ifElse(positive, y, 0.0)),
            "ifElse(gt(x, 0), add(x, y), 0)");
  EXPECT_EQ(simplified(ifElse(positive, x, x)), "x");
  // These look similar, but are not simplified in this way.
  EXPECT_EQ(simplified(ifElse(positive, x, 0.0) + ifElse(gt(y, 0.0), 0.0, y)),
            "add(ifElse(gt(x, 0), x, 0), ifElse(gt(y, 0), 0, y))");
  EXPECT_EQ(simplified(ifElse(positive, x, 1.0) + ifElse(positive, 0.0, y)),
            "add(ifElse(gt(x, 0), x, 1), ifElse(gt(x, 0), 0, y))");
}

TEST_F(Simplification, CancelsRotations) {
  const Expression c = cos(u), s = sin(u);
  EXPECT_EQ(simplified(c * c + s * s), "1");
  EXPECT_EQ(simplified((x * c - y * s) * c + (x * s + y * c) * s), "x");
  EXPECT_EQ(simplified((x * s + y * c) * c - (x * c - y * s) * s), "y");
  EXPECT_EQ(simplified((-(x * s) - y * c) * s - (x * c - y * s) * c), "neg(x)");
  EXPECT_EQ(simplified((x * c * y) * c + s * (y * (s * x))), "mult(x, y)");
  // These look similar, but are not simplified in this way.
  EXPECT_EQ(simplified(c * c - s * s), "sub(mult(cos(u), cos(u)), mult(sin(u), sin(u)))");
  EXPECT_EQ(simplified(c * c + sin(x) * sin(x)), "add(mult(cos(u), cos(u)), mult(sin(x), sin(x)))");
  EXPECT_EQ(simplified((x * c) * c + (y * s) * s),
            "add(mult(mult(x, cos(u)), cos(u)), mult(mult(y, sin(u)), sin(u)))");
}

}  // namespace
}  // namespace warpjet::identities
