// The table of identities, row by row: each row keeps what it claims, each is applied in a graph,
// and no two replace each other forever. Values are computed from the patterns themselves, without
// a graph.
#include "graph/identities.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <random>

#include "graph/match.hpp"
#include "graph/pattern_text.hpp"
#include "graph/print.hpp"
#include "graph/rotations.hpp"
#include "support.hpp"

namespace warpjet {

namespace patterns {
namespace {

constexpr std::array wrongIdentities{
    Identity{x - -y, x - y, bits},            // wrong operation
    Identity{x - y, y - x, rounding},         // wrong order
    Identity{x + 0, x, bits},                 // -0 + 0 is 0
    Identity{x * 0, 0, value},                // infinity * 0 is NaN
    Identity{x * (1 / y), x / y, value},      // rounded differently
    Identity{x + a, x - a, rounding, a < 0},  // without its minus
    Identity{clamp(x, a, b), b, value},       // without its condition
    Identity{ifElse(!c, x, y), ifElse(c, x, y), bits},
    Identity{intIfElse(c, x, y), x, bits},
    Identity{pow(x, n), pow(x, n / 2), rounding, isPowerOfTwo(n)},
    Identity{x / sqrt(x), sqrt(x), rounding},  // 0 / 0 is NaN
};

constexpr Identity wrongTurn{k * (x * cos(u)) * cos(u) + k * (x * sin(u)) * cos(u), x* k, rounding};

}  // namespace
}  // namespace patterns

namespace {

using patterns::Identity, patterns::Item, patterns::Kind, patterns::Pattern, patterns::Precision;

constexpr std::size_t letters = 26;

using At = std::array<double, letters>;  // the value of each variable

// The variables of a pattern, by letter.
struct Variables {
  std::array<std::optional<Kind>, letters> kinds;
  std::array<ops::Type, letters> types{};

  explicit Variables(const Pattern& pattern) { visit(pattern.items.data(), ops::Type::Float); }

 private:
  void visit(const Item* item, ops::Type type) {
    if (item->isVariable()) {
      kinds[item->number] = item->kind;
      types[item->number] = type;
    }
    if (item->kind != Kind::Operation) return;
    const ops::Declaration& declaration = ops::declaration(item->op());
    const Item* operand = item + 1;
    for (int i = 0; i < declaration.arity; ++i, operand += operand->size)
      visit(operand, declaration.signature.operands[i]);
  }
};

// Rounds a number to float or to double.
struct Arithmetic {
  bool isFloat32;

  double operator()(double x) const { return isFloat32 ? double{static_cast<float>(x)} : x; }
  double epsilon() const { return isFloat32 ? 0x1p-23 : 0x1p-52; }
  double smallest() const {
    return isFloat32 ? double{std::numeric_limits<float>::min()}
                     : std::numeric_limits<double>::min();
  }
};

// Evaluates a pattern, rounding every operation.
class Evaluation {
 public:
  Evaluation(const Pattern& pattern, const At& at, Arithmetic round) : at_(at), round_(round) {
    value = visit(pattern.items.data());
  }

  double value;
  double largest = 0;        // the largest intermediate value
  bool leavesRange = false;  // true if an intermediate value overflows, or loses digits near zero

 private:
  double visit(const Item* item) {
    if (item->isVariable()) return at_[item->number];
    if (item->kind == Kind::Literal) return item->value;
    if (item->kind == Kind::Function) return item->function->of(visit(item + 1));
    Operands<double> x{};
    const ops::Declaration& declaration = ops::declaration(item->op());
    bool isFinite = true, hasZero = false;
    const Item* operand = item + 1;
    for (int i = 0; i < declaration.arity; ++i, operand += operand->size) {
      x[i] = visit(operand);
      isFinite = isFinite && std::isfinite(x[i]);
      hasZero = hasZero || x[i] == 0;
    }
    const double exact = ops::valueOf(item->op(), x);
    if (declaration.signature.result != ops::Type::Float) return exact;
    const double rounded = round_(exact), size = std::abs(rounded);
    if (std::isfinite(size)) largest = std::max(largest, size);
    const bool isTiny = size < round_.smallest() && (size != 0 || exact != 0 || !hasZero);
    const bool isDifference = declaration.name == "add" || declaration.name == "sub";
    if (isFinite && (!std::isfinite(size) || (isTiny && !(isDifference && size == 0))))
      leavesRange = true;
    return rounded;
  }

  const At& at_;
  Arithmetic round_;
};

bool isSameNumber(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool isSame(double a, double b) {
  return isSameNumber(a, b) && (std::isnan(a) || std::signbit(a) == std::signbit(b));
}

enum class Verdict { Kept, Lost, Exempt };

// Checks whether an identity is as exact as it claims for these values of its variables.
Verdict judge(const Identity& identity, const At& at, Arithmetic round) {
  const Evaluation before(identity.from, at, round), after(identity.to, at, round);
  const auto [precision, onlyNumbers] = identity.keeps;
  if (onlyNumbers && std::isnan(before.value)) return Verdict::Exempt;
  if (isSame(before.value, after.value)) return Verdict::Kept;
  if (precision == Precision::Bits) return Verdict::Lost;
  if (isSameNumber(before.value, after.value)) return Verdict::Kept;
  if (precision == Precision::Value) return Verdict::Lost;
  if (before.leavesRange || after.leavesRange) return Verdict::Exempt;
  const double error = std::abs(before.value - after.value);
  const double bound = 4 * round.epsilon() * std::max(before.largest, after.largest);
  return error <= bound ? Verdict::Kept : Verdict::Lost;
}

// Deterministic on all machines, unlike the distributions of the standard library.
class Chance {
 public:
  std::uint32_t bits() { return static_cast<std::uint32_t>(random_()); }
  std::size_t below(std::size_t end) { return bits() % end; }
  double between(double low, double high) { return low + (high - low) * (bits() / 4294967296.0); }

  double number(Arithmetic round) {
    constexpr auto infinity = std::numeric_limits<double>::infinity();
    constexpr auto nan = std::numeric_limits<double>::quiet_NaN();
    const double smallestFloat = std::numeric_limits<float>::denorm_min(), tiny = round.smallest();
    const std::array special{0.0,  -0.0,  infinity, -infinity, nan, smallestFloat, -smallestFloat,
                             tiny, -tiny, 1.0,      -1.0,      2.0, 1e-40,         -1e-40,
                             3e38, -3e38};
    switch (below(3)) {
      case 0:
        return round(special[below(special.size())]);
      case 1:
        return round(between(-4, 4));
      default:  // any magnitude
        return round(std::ldexp(between(-2, 2), static_cast<int>(below(240)) - 120));
    }
  }

  double value(Kind kind, ops::Type type, Arithmetic round) {
    if (type == ops::Type::Bool) return static_cast<double>(below(2));
    if (type == ops::Type::Int) return static_cast<std::int32_t>(bits());
    if (kind != Kind::Constant) return number(round);
    if (below(2) == 0) return static_cast<double>(below(41)) - 20;  // an integer, for powers
    for (;;) {
      const double constant = number(round);
      if (std::isfinite(constant)) return constant;
    }
  }

 private:
  std::mt19937 random_{1};
};

std::string describe(const Identity& identity, const At& at) {
  std::string all = text(identity) + ", where";
  const Variables variables(identity.from);
  for (std::size_t i = 0; i < letters; ++i) {
    std::array<char, 32> number{};
    std::snprintf(number.data(), number.size(), "%.9g", at[i]);
    if (variables.kinds[i]) all += std::string(" ") + char('a' + i) + " = " + number.data();
  }
  return all;
}

// Values that satisfy the condition, or nullopt.
std::optional<At> drawPoint(const Identity& identity, Chance& chance, Arithmetic round) {
  const Variables variables(identity.from);
  At at{};
  for (std::size_t i = 0; i < letters; ++i) {
    if (variables.kinds[i]) at[i] = chance.value(*variables.kinds[i], variables.types[i], round);
  }
  if (Evaluation(identity.when, at, {false}).value == 0) return std::nullopt;
  return at;
}

// Judges each identity at many points; returns the first failure, or an empty string.
std::string firstLost(std::span<const Identity> table, int points) {
  Chance chance;
  for (const Identity& identity : table) {
    for (const bool isFloat32 : {false, true}) {
      int preserved = 0;
      for (int i = 0; i < points; ++i) {
        const auto at = drawPoint(identity, chance, {isFloat32});
        if (!at) continue;
        const Verdict verdict = judge(identity, *at, {isFloat32});
        if (verdict == Verdict::Lost) return describe(identity, *at);
        preserved += verdict == Verdict::Kept;
      }
      if (preserved < points / 40)
        return text(identity) + " has too few points at which it can be checked";
    }
  }
  return {};
}

TEST(Identities, PreserveWhatTheyClaim) { EXPECT_EQ(firstLost(patterns::identities, 4000), ""); }

// Wrong identities that would pass if the samples were badly chosen.
TEST(Identities, TheJudgeRejectsWrongIdentities) {
  for (const Identity& wrong : patterns::wrongIdentities)
    EXPECT_NE(firstLost({&wrong, 1}, 4000), "") << text(wrong);
}

// x cos² u + x sin² u and the like, to within a few roundings of the largest product.
TEST(Identities, RotationIdentitiesPreserveTheValue) {
  Chance chance;
  for (const Identity& identity : patterns::turns) {
    for (int i = 0; i < 4000; ++i) {
      At at{};
      for (double& each : at) each = chance.between(-100, 100);
      EXPECT_EQ(judge(identity, at, {false}), Verdict::Kept) << describe(identity, at);
      if (HasFailure()) return;
    }
  }
  At at{};
  at.fill(0.5);
  EXPECT_EQ(judge(patterns::wrongTurn, at, {false}), Verdict::Lost);
}

// --- in a graph

// A graph with a node per variable; constants satisfy the condition.
class Instance {
 public:
  Instance(Graph& graph, Chance& chance) : graph_(graph), chance_(chance) {}

  // Builds the pattern's operands, and its operation.
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
    if (item->kind == Kind::Function) return item->function->of(valueOf(item + 1));
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

// Applies the rules alone, step by step: unlike a graph, this stops when there are too many steps.
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

// Combines every identity with every other in the place of each of its variables.
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

// --- simplified expressions

class Simplification : public testing::Test {
 protected:
  Graph graph;
  Expression x = scalar(graph, "x"), y = scalar(graph, "y"), u = scalar(graph, "u");
  Expression positive = gt(x, 0.0);

  std::string of(Expression root) const {
    const auto nodes = reachable(graph, {&root.id, 1});
    return expression(root.id);
  }

 private:
  // Writes the expression as nested calls.
  std::string expression(NodeId id) const {
    if (graph.isLeaf(id)) return nameOf(graph, id);
    std::string all = std::string(ops::declaration(graph.node(id).op).name) + "(";
    for (int i = 0; i < graph.arity(id); ++i)
      all += (i == 0 ? "" : ", ") + expression(graph.operand(id, i));
    return all + ")";
  }
};

TEST_F(Simplification, FoldsConstantsAndSignsOfSums) {
  EXPECT_EQ(of(x + -y), "sub(x, y)");
  EXPECT_EQ(of(-x + y), "sub(y, x)");
  EXPECT_EQ(of(2.0 + x), "add(x, 2)");
  EXPECT_EQ(of(x + -2.0), "sub(x, 2)");
  EXPECT_EQ(of(x - 500.0 + 500.0), "x");
  EXPECT_EQ(of(x - 3.0 - 4.0), "sub(x, 7)");
  EXPECT_EQ(of(x + x), "mult(x, 2)");
  // These only look similar.
  EXPECT_EQ(of(x + y), "add(x, y)");
  EXPECT_EQ(of(x + y + 2.0), "add(add(x, y), 2)");
  EXPECT_EQ(of(x + 1e-39 + 1e-39), "add(add(x, 1e-39), 1e-39)");
  EXPECT_EQ(of(-x - y), "sub(neg(x), y)");
}

TEST_F(Simplification, FoldsFactorsOfProducts) {
  EXPECT_EQ(of(x * 0.0), "0");
  EXPECT_EQ(of(x * ifElse(positive, 1.0, 0.0)), "ifElse(gt(x, 0), x, 0)");
  EXPECT_EQ(of(ifElse(positive, 0.0, 1.0) * x), "ifElse(gt(x, 0), 0, x)");
  EXPECT_EQ(of(-x * -y), "mult(x, y)");
  EXPECT_EQ(of(-x * 3.0), "mult(x, -3)");
  EXPECT_EQ(of(x * 2.0 * 4.0), "mult(x, 8)");
  EXPECT_EQ(of(x * (1.0 / y)), "div(x, y)");
  EXPECT_EQ(of(x / sqrt(x)), "sqrt(x)");
  // These only look similar.
  EXPECT_EQ(of(x * ifElse(positive, 1.0, 2.0)), "mult(x, ifElse(gt(x, 0), 1, 2))");
  EXPECT_EQ(of(x * 1e-30 * 1e-30), "mult(mult(x, 1e-30), 1e-30)");
  EXPECT_EQ(of(x * (2.0 / y)), "mult(x, div(2, y))");
  EXPECT_EQ(of(y / sqrt(x)), "div(y, sqrt(x))");
}

TEST_F(Simplification, ExpandsSmallIntegerPowers) {
  EXPECT_EQ(of(pow(x, 0.0)), "1");
  EXPECT_EQ(of(pow(x, 2.0)), "mult(x, x)");
  EXPECT_EQ(of(pow(x, 3.0)), "mult(x, mult(x, x))");
  EXPECT_EQ(of(pow(x, -2.0)), "div(1, mult(x, x))");
  EXPECT_EQ(of(pow(x, 6.0)), "mult(mult(x, x), mult(mult(x, x), mult(x, x)))");
  EXPECT_EQ(of(pow(x, 0.5)), "pow(x, 0.5)");
  EXPECT_EQ(of(pow(x, 17.0)), "pow(x, 17)");
  EXPECT_EQ(of(pow(x, y)), "pow(x, y)");
}

TEST_F(Simplification, MergesSumsOfChoicesOnOneCondition) {
  EXPECT_EQ(of(ifElse(positive, x, 0.0) + ifElse(positive, 0.0, y)), "ifElse(gt(x, 0), x, y)");
  EXPECT_EQ(of(ifElse(positive, 0.0, x) + ifElse(positive, y, 0.0)), "ifElse(gt(x, 0), y, x)");
  EXPECT_EQ(of(ifElse(positive, x, 0.0) + ifElse(positive, y, 0.0)),
            "ifElse(gt(x, 0), add(x, y), 0)");
  EXPECT_EQ(of(ifElse(positive, x, x)), "x");
  // These only look similar.
  EXPECT_EQ(of(ifElse(positive, x, 0.0) + ifElse(gt(y, 0.0), 0.0, y)),
            "add(ifElse(gt(x, 0), x, 0), ifElse(gt(y, 0), 0, y))");
  EXPECT_EQ(of(ifElse(positive, x, 1.0) + ifElse(positive, 0.0, y)),
            "add(ifElse(gt(x, 0), x, 1), ifElse(gt(x, 0), 0, y))");
}

TEST_F(Simplification, CancelsRotations) {
  const Expression c = cos(u), s = sin(u);
  EXPECT_EQ(of(c * c + s * s), "1");
  EXPECT_EQ(of((x * c - y * s) * c + (x * s + y * c) * s), "x");
  EXPECT_EQ(of((x * s + y * c) * c - (x * c - y * s) * s), "y");
  EXPECT_EQ(of((-(x * s) - y * c) * s - (x * c - y * s) * c), "neg(x)");
  EXPECT_EQ(of((x * c * y) * c + s * (y * (s * x))), "mult(x, y)");
  // These only look similar.
  EXPECT_EQ(of(c * c - s * s), "sub(mult(cos(u), cos(u)), mult(sin(u), sin(u)))");
  EXPECT_EQ(of(c * c + sin(x) * sin(x)), "add(mult(cos(u), cos(u)), mult(sin(x), sin(x)))");
  EXPECT_EQ(of((x * c) * c + (y * s) * s),
            "add(mult(mult(x, cos(u)), cos(u)), mult(mult(y, sin(u)), sin(u)))");
}

}  // namespace
}  // namespace warpjet
