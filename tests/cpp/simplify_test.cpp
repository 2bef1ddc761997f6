// Folded and unfolded graphs: random graphs, built with and without simplification, have the same
// values at every point, with the exceptions that graph/simplify.hpp lists. Each exception has a
// separate test.
#include "graph/simplify.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>

#include "graph/reachable.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

constexpr Op Neg = ops::find("neg"), Add = ops::find("add"), Sub = ops::find("sub"),
             Mult = ops::find("mult"), Div = ops::find("div"), Pow = ops::find("pow"),
             Mix = ops::find("mix"), Clamp = ops::find("clamp"), IfElse = ops::find("ifElse");

constexpr double infinity = std::numeric_limits<double>::infinity();

// All NaN are equal; zeros of different sign are not.
bool same(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return a == b && std::signbit(a) == std::signbit(b);
}

// The number of doubles from one number to the other.
std::uint64_t distance(double a, double b) {
  const auto place = [](double x) {
    std::int64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
  };
  if (std::isnan(a) || std::isnan(b)) return ~std::uint64_t{0};
  const std::int64_t low = std::min(place(a), place(b)), high = std::max(place(a), place(b));
  return static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
}

// --- the exceptions, one by one

// The value of a formula of x and y in a graph that simplifies, and in one that doesn't.
struct Both {
  double folded, unfolded;
};

template <class Formula>
Both both(Formula formula, double x, double y = 0) {
  const auto value = [&](Graph::Simplification simplification) {
    Graph graph(Graph::maxNodes, simplification);
    const Expression a = scalar(graph, "x"), b = scalar(graph, "y");
    return evaluateNode(graph, formula(a, b).id, {{a.id, x}, {b.id, y}});
  };
  return {value(Graph::Simplification::On), value(Graph::Simplification::Off)};
}

template <class Formula>
void expectValues(double folded, double unfolded, Formula formula, double x, double y = 0) {
  const Both values = both(formula, x, y);
  EXPECT_TRUE(same(values.folded, folded)) << "folded: " << values.folded;
  EXPECT_TRUE(same(values.unfolded, unfolded)) << "unfolded: " << values.unfolded;
}

// Otherwise x + 0, x - y and 0 - x would have to remain, and shaders don't guarantee that sign.
TEST(SimplifyExceptions, TheSignOfZeroMayChange) {
  expectValues(
      -0.0, 0.0, [](auto x, auto) { return x + 0.0; }, -0.0);
  expectValues(
      -0.0, 0.0, [](auto x, auto) { return 0.0 - x; }, 0.0);
  expectValues(
      0.0, -0.0, [](auto x, auto) { return x * 0.0; }, -2);
  expectValues(
      0.0, -0.0, [](auto x, auto) { return 0.0 / x; }, -2);
  expectValues(
      0.0, -0.0, [](auto x, auto) { return x * ifElse(gt(x, 0.0), 1.0, 0.0); }, -2);
}

// Otherwise every structural zero of a Jacobian would remain.
TEST(SimplifyExceptions, InfinityTimesZeroIsZero) {
  expectValues(
      0, NAN, [](auto x, auto) { return x * 0.0; }, infinity);
  expectValues(
      0, NAN, [](auto x, auto) { return x * 0.0; }, NAN);
  const auto choose = [](auto x, auto) { return 1.0 / x * ifElse(gt(x, 0.0), 1.0, 0.0); };
  expectValues(0, NAN, choose, 0);
  const auto chosenNot = [](auto x, auto) { return ifElse(gt(x, 0.0), 0.0, 1.0) * x; };
  expectValues(0, NAN, chosenNot, infinity);
}

// The same applies to a derivative of moved - position.
TEST(SimplifyExceptions, InfinityMinusItselfIsZero) {
  expectValues(
      0, NAN, [](auto x, auto) { return x - x; }, infinity);
  expectValues(
      0, NAN, [](auto x, auto) { return x + -x; }, -infinity);
  expectValues(
      0, NAN, [](auto x, auto) { return x - x; }, NAN);
}

// The same applies to the derivative of a quotient with a constant numerator.
TEST(SimplifyExceptions, ANumberDividedByItsRootIsItsRoot) {
  const auto formula = [](auto x, auto) { return x / sqrt(x); };
  expectValues(0, std::nan(""), formula, 0);
  expectValues(infinity, std::nan(""), formula, infinity);
  expectValues(3, 3, formula, 9);
}

TEST(SimplifyExceptions, SquaresOfSineAndCosineAddUpToOne) {
  const auto formula = [](auto x, auto) { return sin(x) * sin(x) + cos(x) * cos(x); };
  expectValues(1, 1, formula, 0);
  expectValues(1, std::nan(""), formula, infinity);
}

TEST(SimplifyExceptions, ZeroDividedByAnythingIsZero) {
  expectValues(
      0, NAN, [](auto x, auto) { return 0.0 / x; }, 0);
  expectValues(
      0, NAN, [](auto x, auto) { return 0.0 / x; }, NAN);
}

// mix(x, y, t) is x * (1 - t) + y * t; a term with the factor zero is dropped.
TEST(SimplifyExceptions, InfinityAtTheUnusedEndOfAMixIsIgnored) {
  const auto mix = [](auto x, auto y, auto t) {
    Graph& graph = *x.graph;
    return Expression{&graph, graph.apply(Mix, {x.id, toNode(graph, y), toNode(graph, t)})};
  };
  expectValues(
      3, NAN, [&](auto x, auto y) { return mix(x, y, 0.0); }, 3, infinity);
  expectValues(
      3, NAN, [&](auto x, auto y) { return mix(y, x, 1.0); }, 3, infinity);
  expectValues(
      -infinity, NAN, [&](auto x, auto y) { return mix(y, 0.0, x); }, infinity, 1);
  expectValues(
      infinity, NAN,
      [&](auto x, auto y) {
        const Expression zero{x.graph, x.graph->constant(0)};
        return mix(zero, y, x);
      },
      infinity, 1);
}

// A chain of constant factors, as produced by the chain rule, becomes one.
TEST(SimplifyExceptions, ConstantFactorsAreMultipliedFirst) {
  int different = 0;
  for (int i = 1; i <= 20; ++i) {
    const Both values = both([](auto a, auto) { return a * 0.1 * 0.3; }, i);
    EXPECT_LE(distance(values.folded, values.unfolded), 2u) << i;
    different += values.folded != values.unfolded;
  }
  EXPECT_GT(different, 0);
}

// (x - 500) + 500 is x, with all its digits.
TEST(SimplifyExceptions, ConstantTermsAreAddedFirst) {
  const auto there = [](auto x, auto) { return x - 500.0 + 500.0; };
  const auto back = [](auto x, auto) { return x + 500.0 - 500.0; };
  for (const double x : {0.1, -0.3, 1e-5, 499.9}) {
    EXPECT_EQ(both(there, x).folded, x);
    EXPECT_EQ(both(back, x).folded, x);
    EXPECT_NEAR(both(there, x).unfolded, x, 2e-13);
  }
  EXPECT_NE(both(there, 0.1).unfolded, 0.1);
  const Both sum = both([](auto x, auto) { return x + 0.1 + 0.2 - 0.7; }, 3.3);
  EXPECT_NEAR(sum.folded, 2.9, 1e-15);
  EXPECT_NEAR(sum.unfolded, 2.9, 2e-15);
}

// One operation instead of two, and closer to the exact value.
TEST(SimplifyExceptions, AProductWithAReciprocalIsAQuotient) {
  for (const double y : {3.0, 49.0, -0.7, 1e10, 1e-10}) {
    const Both values = both([](auto a, auto b) { return a * (1.0 / b); }, 5, y);
    EXPECT_EQ(values.folded, 5 / y);
    EXPECT_LE(distance(values.folded, values.unfolded), 2u) << y;
  }
  EXPECT_NE(both([](auto a, auto b) { return a * (1.0 / b); }, 5, 49).unfolded, 5.0 / 49);
}

// GLSL's pow is undefined for a negative base. Each product is rounded.
TEST(SimplifyExceptions, IntegerPowersAreRoundedAfterEachProduct) {
  for (int n = -16; n <= 16; ++n) {
    for (const double x : {0.3, -0.7, 1.1, -2.3, 1000.1}) {
      const Both values = both([n](auto a, auto) { return pow(a, double(n)); }, x);
      EXPECT_LE(distance(values.folded, values.unfolded), static_cast<std::uint64_t>(std::abs(n)))
          << x << " to the power of " << n;
    }
  }
}

// WGSL rejects clamp with crossing constants, so none may remain.
TEST(SimplifyExceptions, NaNClampedToCrossedBoundsIsTheUpperBound) {
  const auto clamped = [](auto x, auto) {
    Graph& graph = *x.graph;
    return Expression{&graph, graph.apply(Clamp, {x.id, graph.constant(3), graph.constant(2)})};
  };
  expectValues(2, 2, clamped, 5);
  expectValues(2, NAN, clamped, NAN);
}

// In double; float32 has its own range.
TEST(SimplifyExceptions, IntermediatesThatOverflowOrUnderflowAreAvoided) {
  const auto scaled = [](auto x, auto) { return x * 2.0 * 0.5; };
  expectValues(1e308, infinity, scaled, 1e308);
  const auto divided = [](auto x, auto y) { return x * (1.0 / y); };
  expectValues(0x1p1000, infinity, divided, 0x1p-30, 0x1p-1030);
  expectValues(0, NAN, divided, 0, 0x1p-1030);
  const auto squared = [](auto x, auto) { return pow(x, -2.0); };
  expectValues(0, 0x1p-1040, squared, 0x1p520);
}

// A comparison of constants decides as in the shader, where 0.30000000000000004 and 0.3 are the
// same float.
TEST(SimplifyExceptions, ComparisonsOfConstantsUseFloat32) {
  const auto sum = [](auto x) { return Expression{x.graph, x.graph->constant(0.1)} + 0.2; };
  const auto third = [](auto x) { return Expression{x.graph, x.graph->constant(1.0)} / 3.0; };
  const auto choose = [](auto condition) { return ifElse(condition, 5.0, 7.0); };
  expectValues(
      5, 7, [&](auto x, auto) { return choose(eq(sum(x), 0.3)); }, 0);
  expectValues(
      7, 5, [&](auto x, auto) { return choose(gt(sum(x), 0.3)); }, 0);
  expectValues(
      7, 5, [&](auto x, auto) { return choose(ne(third(x), 0.33333333)); }, 0);
  expectValues(
      3, 2, [&](auto x, auto) { return floor(sum(x) * 10.0 - 1e-9); }, 0);
  expectValues(
      0, 1, [&](auto x, auto) { return sign(sum(x) * 1e-60); }, 0);
  expectValues(
      7, 5, [&](auto x, auto) { return choose(sum(x) * 1e-60); }, 0);
}

// --- cases that random graphs rarely contain

// x where y > 0 and zero elsewhere, or the reverse.
template <class X, class Y>
Expression choose(X x, Y y, bool ifPositive) {
  return ifPositive ? ifElse(gt(y, 0.0), x, 0.0) : ifElse(gt(y, 0.0), 0.0, x);
}

TEST(Simplify, MergesSumsOfChoicesWithOneCondition) {
  for (const bool first : {true, false}) {
    for (const bool second : {true, false}) {
      for (const double x : {2.0, -3.0, infinity}) {
        for (const double y : {1.0, -1.0, 0.0, infinity}) {
          const auto sum = [&](auto a, auto b) {
            return choose(a, b, first) + choose(a * a, b, second);
          };
          const Both values = both(sum, x, y);
          EXPECT_TRUE(same(values.folded, values.unfolded)) << x << ", " << y;
        }
      }
    }
  }
}

// --- rotations that cancel

// Deterministic on all machines, unlike the distributions of the standard library.
class Chance {
 public:
  std::size_t below(std::size_t end) { return random_() % end; }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
  }

 private:
  std::mt19937 random_{1};
};

// A rotated point, its perpendicular, rotated back, or something that only resembles it: factors
// and terms in any order, the second product with either sign. No angle remains where algebra
// cancels it:
//
//   c (a c ± b s) + s (a s ∓ b c) = a     c (a s ± b c) - s (a c ∓ b s) = ±b
TEST(Simplify, CancelsARotationAndItsInverse) {
  Chance chance;
  for (int i = 0; i < 20'000; ++i) {
    std::array<bool, 10> choices{};
    for (bool& choice : choices) choice = chance.below(2) == 0;
    const bool swaps = choices[2], minus = choices[3], minus2 = choices[4];
    const bool isScaled = choices[5], isOpposite = choices[6], isOther = choices[9];
    const bool isMinus = (minus == isOpposite) != (isScaled && isOpposite);
    const bool isTurnedBack = !isOther && minus != minus2 && isMinus == swaps;
    const auto formula = [&](Expression x, Expression y) {
      const bool order = choices[0], order2 = choices[1], isUnit = choices[7], reverse = choices[8];
      const Expression u = x * y + 1.0, a = isUnit ? x * 0.0 + 1.0 : x + 2.0, b = y - 3.0;
      const Expression c = cos(u), s = isOther ? sin(u + 1.0) : sin(u);
      const auto times = [](bool isFirst, Expression p, Expression q) {
        return isFirst ? p * q : q * p;
      };
      const auto sum = [](bool isDifference, Expression p, Expression q) {
        return isDifference ? p - q : p + q;
      };
      Expression f = sum(minus, times(order, a, c), times(order2, s, b));
      Expression g = sum(minus2, times(order2, a, s), times(order, c, b));
      if (swaps) std::swap(f, g);
      if (isScaled) {
        f = f * 0.5;
        g = times(order, g, {x.graph, x.graph->constant(isOpposite ? -0.5 : 0.5)});
      }
      const Expression first = times(order, c, f), second = times(order2, g, s);
      return reverse ? sum(minus == isOpposite, second, first)
                     : sum(minus == isOpposite, first, second);
    };
    const double x = chance.between(-4, 4), y = chance.between(-4, 4);
    const Both values = both(formula, x, y);
    EXPECT_NEAR(values.folded, values.unfolded, 1e-14) << "formula " << i;
    Graph graph;
    const NodeId root = formula(scalar(graph, "x"), scalar(graph, "y")).id;
    const auto nodes = reachable(graph, {&root, 1});
    const bool hasNoAngle = std::none_of(nodes.begin(), nodes.end(),
                                         [&](NodeId id) { return graph.is(id, ops::find("cos")); });
    EXPECT_EQ(hasNoAngle, isTurnedBack) << "formula " << i;
    if (HasFailure()) return;
  }
}

// --- random graphs

// The difference between the value of an operation and that of its simplification.
enum Difference {
  Nothing,
  SignOfZero,
  TimesZero,
  MinusItself,
  ZeroDividedBy,
  OverItsRoot,
  EndOfMix,
  ConstantFactors,
  ConstantTerms,
  Reciprocal,
  WholePower,
  CrossedBounds,
  StepInFloat32,
  BeyondRange,
  Unexplained,
};

// One operation, or leaf, in both graphs.
struct Step {
  Op op{};
  std::array<std::size_t, ops::maxArity> operands{};
  NodeId folded{}, unfolded{};
  int depth = 0;

  int arity() const { return depth == 0 ? 0 : ops::declaration(op).arity; }
};

class Pair {
 public:
  Graph folded, unfolded{Graph::maxNodes, Graph::Simplification::Off};
  std::vector<Step> steps;

  void input(const std::string& name) {
    steps.push_back({{}, {}, scalar(folded, name).id, scalar(unfolded, name).id});
  }
  void constant(double value) {
    steps.push_back({{}, {}, folded.constant(value), unfolded.constant(value)});
  }
  void apply(Op op, const std::array<std::size_t, ops::maxArity>& operands) {
    Step step{op, operands};
    Operands<NodeId> on{}, off{};
    for (int i = 0; i < ops::declaration(op).arity; ++i) {
      const Step& operand = steps[operands[i]];
      on[i] = operand.folded;
      off[i] = operand.unfolded;
      step.depth = std::max(step.depth, operand.depth + 1);
    }
    step.folded = folded.apply(op, on);
    step.unfolded = unfolded.apply(op, off);
    steps.push_back(step);
  }
  Operands<NodeId> foldedOperands(const Step& step) const {
    Operands<NodeId> operands{};
    for (int i = 0; i < step.arity(); ++i) operands[i] = steps[step.operands[i]].folded;
    return operands;
  }
};

// Finds the exception that explains why an operation on simplified operands and its simplification
// differ at a point.
class Judge {
 public:
  Judge(Graph& graph, const std::vector<double>& values) : graph_(graph), values_(values) {}

  Difference judge(Op op, const Operands<NodeId>& operands, double found) const {
    Operands<double> x{};
    for (int i = 0; i < ops::declaration(op).arity; ++i) x[i] = at(operands[i]);
    const double expected = ops::valueOf(op, x);
    if (same(expected, found)) return Nothing;
    if (expected == 0 && found == 0) return SignOfZero;
    if (isStepOfConstants(op, operands, found)) return StepInFloat32;
    const bool becameZero = std::isnan(expected) && found == 0;
    switch (op) {
      case Mult:
        return judgeProduct(operands, expected, found);
      case Add:
      case Sub:
        if (becameZero && isDifferenceWithItself(op, operands)) return MinusItself;
        if (op == Add && operands[0] == operands[1])  // becomes a product
          return judge(Mult, {operands[0], graph_.constant(2)}, found);
        return judgeSum(operands, expected, found);
      case Div:
        if (becameZero && isKnown(operands[0], 0)) return ZeroDividedBy;
        return isOverItsRoot(operands, expected, found) ? OverItsRoot : Unexplained;
      case Pow:
        return judgePower(operands, expected, found);
      case Mix:
        return judgeMix(operands, expected, found);
      case Clamp:
        return std::isnan(x[0]) && x[1] > x[2] && found == x[2] ? CrossedBounds : Unexplained;
      default:
        return Unexplained;
    }
  }

 private:
  double at(NodeId id) const { return values_[index(id)]; }
  bool isKnown(NodeId id, double value) const { return graph_.known(id) == value; }
  // A number as a condition is also such a step.
  bool isStepOfConstants(Op op, const Operands<NodeId>& operands, double found) const {
    const ops::Declaration& info = ops::declaration(op);
    Operands<double> x{};
    for (int i = 0; i < info.arity; ++i) {
      const bool isKnown = graph_.known(operands[i]).has_value();
      if (ops::isStep(op) && !isKnown) return false;
      const bool jumps = ops::isStep(op) || info.signature.operands[i] == ops::Type::Bool;
      x[i] = isKnown && jumps ? static_cast<float>(at(operands[i])) : at(operands[i]);
    }
    return same(ops::valueOf(op, x), found);
  }
  NodeId withoutSign(NodeId id) const { return graph_.is(id, Neg) ? graph_.operand(id, 0) : id; }

  Difference judgeProduct(const Operands<NodeId>& operands, double expected, double found) const {
    const auto [a, b, unused] = operands;
    for (const auto& [x, y] : {std::pair{a, b}, std::pair{b, a}}) {
      if (isZeroFactor(y) && !std::isfinite(at(x)) && std::isnan(expected) && found == 0)
        return TimesZero;
      const NodeId inner = withoutSign(x);
      const bool isScaled = graph_.is(inner, Mult) && graph_.isConstant(graph_.operand(inner, 1));
      const bool isReciprocal = graph_.is(inner, Div) && isKnown(graph_.operand(inner, 0), 1);
      if (!(isScaled && graph_.known(y)) && !isReciprocal) continue;
      if (distance(expected, found) <= 2) return isScaled ? ConstantFactors : Reciprocal;
      if (!std::isnormal(at(inner))) return BeyondRange;
    }
    return Unexplained;
  }

  // The two constants of a sum, in either order of its operands.
  Difference judgeSum(const Operands<NodeId>& operands, double expected, double found) const {
    const auto [a, b, unused] = operands;
    for (const auto& [sum, y] : {std::pair{a, b}, std::pair{b, a}}) {
      const bool isSum = graph_.is(sum, Add) || graph_.is(sum, Sub);
      if (!isSum || !graph_.isConstant(graph_.operand(sum, 1)) || !graph_.known(y)) continue;
      const double largest = std::max({std::abs(at(graph_.operand(sum, 0))),
                                       std::abs(at(graph_.operand(sum, 1))), std::abs(at(y))});
      constexpr double ulp = std::numeric_limits<double>::epsilon();
      if (std::abs(expected - found) <= 2 * ulp * largest) return ConstantTerms;
    }
    return Unexplained;
  }

  // Zero, or the zero of a choice between 1 and 0 at this point.
  bool isZeroFactor(NodeId id) const {
    if (isKnown(id, 0)) return true;
    if (!graph_.is(id, IfElse) || at(id) != 0) return false;
    const NodeId yes = graph_.operand(id, 1), no = graph_.operand(id, 2);
    return (isKnown(yes, 1) && isKnown(no, 0)) || (isKnown(yes, 0) && isKnown(no, 1));
  }

  // x / sqrt(x), which is NaN at zero and infinity, and otherwise rounded twice.
  bool isOverItsRoot(const Operands<NodeId>& operands, double expected, double found) const {
    const auto [x, root, unused] = operands;
    if (!graph_.is(root, ops::find("sqrt")) || graph_.operand(root, 0) != x) return false;
    return std::isnan(expected) ? found == std::sqrt(at(x)) : distance(expected, found) <= 1;
  }

  bool isDifferenceWithItself(Op op, const Operands<NodeId>& operands) const {
    const auto [x, y, unused] = operands;
    if (op == Sub) return x == y;
    return (graph_.is(x, Neg) && graph_.operand(x, 0) == y) ||
           (graph_.is(y, Neg) && graph_.operand(y, 0) == x);
  }

  Difference judgePower(const Operands<NodeId>& operands, double expected, double found) const {
    const double n = graph_.known(operands[1]).value_or(0.5), products = std::abs(n);
    if (n != std::floor(n) || products > 16) return Unexplained;
    if (distance(expected, found) <= static_cast<std::uint64_t>(products)) return WholePower;
    return n < 0 && !std::isnormal(std::pow(at(operands[0]), products)) ? BeyondRange : Unexplained;
  }

  Difference judgeMix(const Operands<NodeId>& operands, double expected, double found) const {
    const auto [x, y, t] = operands;
    const Difference leftOut = std::isnan(expected) ? EndOfMix : Unexplained;
    if (isKnown(t, 0)) return same(found, at(x)) ? leftOut : Unexplained;
    if (isKnown(t, 1)) return same(found, at(y)) ? leftOut : Unexplained;
    if (!isKnown(x, 0) && !isKnown(y, 0)) return Unexplained;
    const Difference ofProduct =
        isKnown(x, 0) ? judge(Mult, {y, t}, found)
                      : judge(Mult, {x, graph_.apply(Sub, {graph_.constant(1), t})}, found);
    return ofProduct == Nothing ? leftOut : ofProduct;
  }

  Graph& graph_;
  const std::vector<double>& values_;
};

// Chooses rows that have rules with this probability, in percent; any row otherwise.
Pair randomPair(Chance& chance, std::size_t percentRuled) {
  constexpr int maxDepth = 6, operations = 14;
  constexpr std::array ruled{Neg, Add, Sub, Mult, Div, Pow, Mix, IfElse};
  Pair pair;
  for (const char* name : {"x", "y", "z"}) pair.input(name);
  for (const double value : {0.0, -0.0, 1.0, -1.0, 2.0, 0.5, -2.0, 3.0, 0.1, -5.0, 16.0})
    pair.constant(value);
  const std::size_t inputs = 3, leaves = pair.steps.size();

  // An input, any leaf, or a computed node.
  const auto pick = [&] {
    for (;;) {
      const std::size_t computed = pair.steps.size() - leaves;
      const std::size_t kind = chance.below(computed == 0 ? 2 : 5);
      const std::size_t i = kind == 0   ? chance.below(inputs)
                            : kind == 1 ? chance.below(leaves)
                                        : leaves + chance.below(computed);
      if (pair.steps[i].depth < maxDepth) return i;
    }
  };
  for (int i = 0; i < operations; ++i) {
    // Excludes integers: conversions that exist in only one of the graphs turn them into floats.
    const Op any{static_cast<std::uint8_t>(chance.below(index(ops::find("int"))))};
    const Op op = chance.below(100) < percentRuled ? ruled[chance.below(ruled.size())] : any;
    const std::size_t x = pick(), y = pick(), z = pick();
    pair.apply(op, {x, y, z});
  }
  return pair;
}

std::array<double, 3> randomPoint(Chance& chance) {
  constexpr std::array special{infinity, -infinity, 0.0,    -0.0,    1.0,   -1.0,  0.5,
                               1e300,    -1e300,    1e-300, -1e-300, 1e308, 5e-324};
  std::array<double, 3> point{};
  for (double& x : point)
    x = chance.below(2) == 0 ? special[chance.below(special.size())] : chance.between(-4, 4);
  return point;
}

// The values of all nodes, by index. The inputs are first.
std::vector<double> valuesOf(const Graph& graph, const std::array<double, 3>& point) {
  std::vector<double> values(graph.size());
  for (std::uint32_t i = 0; i < graph.size(); ++i) {
    const NodeId id{i};
    if (graph.isConstant(id)) {
      values[i] = graph.value(id);
    } else if (graph.isInput(id)) {
      values[i] = point[graph.node(id).operands[0]];
    } else {
      Operands<double> x{};
      for (int k = 0; k < graph.arity(id); ++k) x[k] = values[index(graph.operand(id, k))];
      values[i] = ops::valueOf(graph.node(id).op, x);
    }
  }
  return values;
}

class SimplifyRandom : public testing::Test {
 protected:
  std::array<std::size_t, Unexplained + 1> counts{};
  std::size_t compared = 0, exempted = 0;

  // Compares every operation with its simplification on the same operands; then the values of both
  // graphs, which can differ only above an operation that differed.
  void compare(Pair& pair, const std::array<double, 3>& point, int number) {
    const std::vector<double> folded = valuesOf(pair.folded, point),
                              unfolded = valuesOf(pair.unfolded, point);
    const Judge judge(pair.folded, folded);
    std::vector<bool> differs(pair.steps.size());
    for (std::size_t i = 0; i < pair.steps.size(); ++i) {
      const Step& step = pair.steps[i];
      if (step.depth == 0) continue;
      const double found = folded[index(step.folded)];
      const Difference difference = judge.judge(step.op, pair.foldedOperands(step), found);
      EXPECT_NE(difference, Unexplained) << describe(pair, step, folded, number);
      differs[i] = difference != Nothing;
      for (int k = 0; k < step.arity(); ++k)
        if (differs[step.operands[k]]) differs[i] = true;
      if (!differs[i]) {
        EXPECT_TRUE(same(found, unfolded[index(step.unfolded)]))
            << describe(pair, step, folded, number) << " and " << unfolded[index(step.unfolded)];
      }
      ++counts[difference];
      ++compared;
      exempted += differs[i];
    }
  }

  static std::string describe(const Pair& pair, const Step& step, const std::vector<double>& values,
                              int number) {
    std::ostringstream text;
    text << "graph " << number << ": " << ops::declaration(step.op).name;
    for (int k = 0; k < step.arity(); ++k)
      text << (k == 0 ? " of " : ", ") << values[index(pair.steps[step.operands[k]].folded)];
    text << " became " << values[index(step.folded)];
    return text.str();
  }
};

TEST_F(SimplifyRandom, SimplifiedGraphsHaveTheSameValues) {
  Chance chance;
  constexpr int graphs = 40'000, points = 6;
  for (int i = 0; i < graphs; ++i) {
    Pair pair = randomPair(chance, i % 2 == 0 ? 30 : 90);
    for (int k = 0; k < points; ++k) compare(pair, randomPoint(chance), i);
    if (HasFailure()) return;
  }
  EXPECT_EQ(compared, std::size_t{graphs} * points * 14);
  EXPECT_LT(exempted, compared / 20) << "the exceptions must not swallow the test";
  for (int i = SignOfZero; i < Unexplained; ++i) EXPECT_GT(counts[i], 0u) << "no case of " << i;
  for (int i = Nothing; i < Unexplained; ++i)
    RecordProperty("difference" + std::to_string(i), static_cast<int>(counts[i]));
  RecordProperty("exempted", static_cast<int>(exempted));
}

}  // namespace
}  // namespace warpjet
