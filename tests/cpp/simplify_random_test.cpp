// Random graphs, built with and without simplification, have the same values at every point, except
// for the differences that graph/simplify.hpp lists.
#include <gtest/gtest.h>

#include "graph/simplify.hpp"
#include "simplify_support.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

constexpr Op Neg = ops::find("neg"), Add = ops::find("add"), Sub = ops::find("sub"),
             Mult = ops::find("mult"), Div = ops::find("div"), Pow = ops::find("pow"),
             Mix = ops::find("mix"), Clamp = ops::find("clamp"), IfElse = ops::find("ifElse");

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
    Operands<NodeId> foldedNodes{}, unfoldedNodes{};
    for (int i = 0; i < ops::declaration(op).arity; ++i) {
      const Step& operand = steps[operands[i]];
      foldedNodes[i] = operand.folded;
      unfoldedNodes[i] = operand.unfolded;
      step.depth = std::max(step.depth, operand.depth + 1);
    }
    step.folded = folded.apply(op, foldedNodes);
    step.unfolded = unfolded.apply(op, unfoldedNodes);
    steps.push_back(step);
  }
  Operands<NodeId> foldedOperands(const Step& step) const {
    Operands<NodeId> operands{};
    for (int i = 0; i < step.arity(); ++i) operands[i] = steps[step.operands[i]].folded;
    return operands;
  }
};

// Finds the permitted difference that explains why an operation and its simplification, on the same
// operands, have different values at a point.
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
  // Returns true if the value follows from constants that were rounded to float32, which matters
  // for steps, and for numbers that are used as conditions.
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

  // Checks for two constants in a sum, in either order of its operands.
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

  // Returns true for zero, and for a choice between 1 and 0 that is 0 at this point.
  bool isZeroFactor(NodeId id) const {
    if (isKnown(id, 0)) return true;
    if (!graph_.is(id, IfElse) || at(id) != 0) return false;
    const NodeId yes = graph_.operand(id, 1), no = graph_.operand(id, 2);
    return (isKnown(yes, 1) && isKnown(no, 0)) || (isKnown(yes, 0) && isKnown(no, 1));
  }

  // Returns true for x / sqrt(x), which is NaN at zero and infinity, and otherwise rounded twice.
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
    const Difference ifNaN = std::isnan(expected) ? EndOfMix : Unexplained;
    if (isKnown(t, 0)) return same(found, at(x)) ? ifNaN : Unexplained;
    if (isKnown(t, 1)) return same(found, at(y)) ? ifNaN : Unexplained;
    if (!isKnown(x, 0) && !isKnown(y, 0)) return Unexplained;
    const Difference productDifference =
        isKnown(x, 0) ? judge(Mult, {y, t}, found)
                      : judge(Mult, {x, graph_.apply(Sub, {graph_.constant(1), t})}, found);
    return productDifference == Nothing ? ifNaN : productDifference;
  }

  Graph& graph_;
  const std::vector<double>& values_;
};

// Returns two graphs of random operations. With a probability of `percentRuled`, an operation is
// one that has rules; otherwise it may be any.
Pair randomPair(Chance& chance, std::size_t percentRuled) {
  constexpr int maxDepth = 6, operations = 14;
  constexpr std::array ruled{Neg, Add, Sub, Mult, Div, Pow, Mix, IfElse};
  Pair pair;
  for (const char* name : {"x", "y", "z"}) pair.input(name);
  for (const double value : {0.0, -0.0, 1.0, -1.0, 2.0, 0.5, -2.0, 3.0, 0.1, -5.0, 16.0})
    pair.constant(value);
  const std::size_t inputs = 3, leaves = pair.steps.size();

  // Picks an input, any leaf, or a computed node.
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

// Returns the values of all nodes, by index. The inputs are first.
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
  EXPECT_LT(exempted, compared / 20) << "too few values are compared";
  for (int i = SignOfZero; i < Unexplained; ++i) EXPECT_GT(counts[i], 0u) << "no case of " << i;
  for (int i = Nothing; i < Unexplained; ++i)
    RecordProperty("difference" + std::to_string(i), static_cast<int>(counts[i]));
  RecordProperty("exempted", static_cast<int>(exempted));
}

}  // namespace
}  // namespace warpjet
