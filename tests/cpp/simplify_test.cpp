// The ways in which simplification may change a value, one by one, and cases that random graphs
// rarely contain.
#include "graph/simplify.hpp"

#include <gtest/gtest.h>

#include "graph/reachable.hpp"
#include "simplify_support.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

constexpr Op Mix = ops::find("mix"), Clamp = ops::find("clamp");

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

// Without this exception, x + 0 and 0 - x could not be simplified; and shaders don't guarantee the
// sign of zero.
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

// Without this exception, every structural zero of a Jacobian would remain.
TEST(SimplifyExceptions, InfinityTimesZeroIsZero) {
  expectValues(
      0, NAN, [](auto x, auto) { return x * 0.0; }, infinity);
  expectValues(
      0, NAN, [](auto x, auto) { return x * 0.0; }, NAN);
  const auto ifPositive = [](auto x, auto) { return 1.0 / x * ifElse(gt(x, 0.0), 1.0, 0.0); };
  expectValues(0, NAN, ifPositive, 0);
  const auto ifNotPositive = [](auto x, auto) { return ifElse(gt(x, 0.0), 0.0, 1.0) * x; };
  expectValues(0, NAN, ifNotPositive, infinity);
}

// Without this exception, the derivative of moved - position could not be simplified.
TEST(SimplifyExceptions, InfinityMinusItselfIsZero) {
  expectValues(
      0, NAN, [](auto x, auto) { return x - x; }, infinity);
  expectValues(
      0, NAN, [](auto x, auto) { return x + -x; }, -infinity);
  expectValues(
      0, NAN, [](auto x, auto) { return x - x; }, NAN);
}

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

// Without this exception, the derivative of a quotient with a constant numerator could not be
// simplified.
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

// Several constant factors, as the chain rule produces them, become one factor.
TEST(SimplifyExceptions, ConstantFactorsAreMultipliedFirst) {
  int different = 0;
  for (int i = 1; i <= 20; ++i) {
    const Both values = both([](auto a, auto) { return a * 0.1 * 0.3; }, i);
    EXPECT_LE(distance(values.folded, values.unfolded), 2u) << i;
    different += values.folded != values.unfolded;
  }
  EXPECT_GT(different, 0);
}

// (x - 500) + 500 becomes x, without rounding.
TEST(SimplifyExceptions, ConstantTermsAreAddedFirst) {
  const auto subtractFirst = [](auto x, auto) { return x - 500.0 + 500.0; };
  const auto addFirst = [](auto x, auto) { return x + 500.0 - 500.0; };
  for (const double x : {0.1, -0.3, 1e-5, 499.9}) {
    EXPECT_EQ(both(subtractFirst, x).folded, x);
    EXPECT_EQ(both(addFirst, x).folded, x);
    EXPECT_NEAR(both(subtractFirst, x).unfolded, x, 2e-13);
  }
  EXPECT_NE(both(subtractFirst, 0.1).unfolded, 0.1);
  const Both sum = both([](auto x, auto) { return x + 0.1 + 0.2 - 0.7; }, 3.3);
  EXPECT_NEAR(sum.folded, 2.9, 1e-15);
  EXPECT_NEAR(sum.unfolded, 2.9, 2e-15);
}

// The quotient is one operation instead of two, and closer to the exact value.
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

// WGSL rejects a clamp whose constant bounds are crossed, so none may remain.
TEST(SimplifyExceptions, NaNClampedToCrossedBoundsIsTheUpperBound) {
  const auto clamped = [](auto x, auto) {
    Graph& graph = *x.graph;
    return Expression{&graph, graph.apply(Clamp, {x.id, graph.constant(3), graph.constant(2)})};
  };
  expectValues(2, 2, clamped, 5);
  expectValues(2, NAN, clamped, NAN);
}

// The values are computed in double, whose range is larger than that of float32.
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

// Returns x where y > 0 and zero elsewhere, or the reverse.
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

// Rotates a point and then back, or computes something similar: factors and terms in any order, the
// second product with either sign. No angle remains where algebra cancels it:
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
    const bool isRotatedBack = !isOther && minus != minus2 && isMinus == swaps;
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
    EXPECT_EQ(hasNoAngle, isRotatedBack) << "formula " << i;
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace warpjet
