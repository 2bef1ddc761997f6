// Interval arithmetic: every row of the table, at dense samples of random intervals; and cases
// computed by hand.
#include "ops/interval.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "ops/rows.hpp"

namespace warpjet {
namespace {

constexpr double infinity = Interval::infinity, pi = 3.14159265358979323846;

class Sampler {
 public:
  double between(double low, double high) {
    return std::uniform_real_distribution(low, high)(random_);
  }
  int below(int count) { return std::uniform_int_distribution(0, count - 1)(random_); }

  // Returns a small or large number, an integer or a fraction, of either sign.
  double number() {
    switch (below(6)) {
      case 0:
        return below(9) - 4;
      case 1:
        return (below(2) ? 1 : -1) * std::exp(between(-690, 690));
      case 2:
        return (below(2) ? 1 : -1) * std::exp(between(-20, 20));
      case 3:
        return below(41) * 0.25 * pi - 5 * pi;
      default:
        return between(-4, 4);
    }
  }

  Interval interval() {
    double low = number(), high = number();
    if (below(8) == 0) high = low;
    if (below(4) == 0) high = low + between(0, 1e-3) * std::abs(low);
    if (low > high) std::swap(low, high);
    return {low == 0 ? -0.0 : low, high == 0 ? 0.0 : high};
  }

  // Returns an interval of integers, small or large.
  Interval integers() {
    const double lowest = -2147483648.0, highest = 2147483647.0;
    const bool isSmall = below(2) != 0;
    const auto number = [&] {
      return isSmall ? below(81) - 40.0 : std::round(between(lowest, highest));
    };
    const double a = number(), b = below(4) == 0 ? a : number();
    return below(8) == 0 ? Interval(lowest, highest) : Interval(std::min(a, b), std::max(a, b));
  }

  double inside(const Interval& x) {
    switch (below(6)) {
      case 0:
        return x.low;
      case 1:
        return x.high;
      case 2:
        if (x.has(0)) return below(2) ? 0.0 : -0.0;
        return x.low;
      case 3: {
        const double whole = std::round(between(std::max(x.low, -1e6), std::max(x.low, -1e6) + 9));
        return x.has(whole) ? whole : x.high;
      }
      default:
        const double t = between(0, 1);
        return std::min(std::max(x.low * (1 - t) + x.high * t, x.low), x.high);
    }
  }

 private:
  std::mt19937 random_{1};
};

// Returns true if a number neither overflows nor underflows in float32.
bool isFloat32(double x) {
  using Limits = std::numeric_limits<float>;
  return x == 0 || (std::abs(x) >= Limits::min() && std::abs(x) <= Limits::max());
}

template <std::size_t Row>
void checkRow() {
  Sampler sample;
  for (int box = 0; box < 3000; ++box) {
    ops::Operands<Interval> x;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool isBool = ops::declarations[Row].signature.operands[i] == ops::Type::Bool;
      const int truth = sample.below(3);
      const bool isInt = ops::declarations[Row].signature.operands[i] == ops::Type::Int;
      x[i] = isBool  ? Interval(truth == 1, truth != 0)
             : isInt ? sample.integers()
                     : sample.interval();
    }
    const Interval range = ops::rangeOf(Op(Row), x);
    for (int point = 0; point < 40; ++point) {
      ops::Operands<double> at{};
      for (std::size_t i = 0; i < 3; ++i) at[i] = sample.inside(x[i]);
      for (std::size_t i = 0; i < 3; ++i) {
        if (ops::declarations[Row].signature.operands[i] == ops::Type::Bool) at[i] = at[i] >= 0.5;
        if (ops::declarations[Row].signature.operands[i] == ops::Type::Int)
          at[i] = std::round(at[i]);
        if (!x[i].has(at[i])) at[i] = x[i].low;
      }
      const double value = ops::valueOf(Op(Row), at);
      ASSERT_TRUE(std::isnan(value) ? range.canBeNaN : range.has(value))
          << ops::declarations[Row].name << " of " << at[0] << ", " << at[1] << ", " << at[2]
          << " is " << value << ", not from " << range.low << " to " << range.high << ", of "
          << x[0].low << ".." << x[0].high << ", " << x[1].low << ".." << x[1].high;
      // A value that overflows is infinite in float32; one that underflows may be zero.
      if (std::isnan(value) || !std::all_of(at.begin(), at.end(), isFloat32)) continue;
      const double inFloat32 = std::abs(value) > 1 ? value * Interval::infinity : 0;
      ASSERT_TRUE(isFloat32(value) || range.has(inFloat32))
          << ops::declarations[Row].name << " of " << at[0] << ", " << at[1] << " is " << inFloat32
          << " in float32, not from " << range.low << " to " << range.high;
    }
  }
}

TEST(Interval, ContainsTheValuesOfEveryRow) {
  ops::withIndices<ops::count>([](auto... row) { (checkRow<row>(), ...); });
}

// Checks that ranges are not much wider than the values at dense samples, in the domains of the
// table.
template <std::size_t Row>
void checkTightness() {
  constexpr auto& info = ops::declarations[Row];
  const std::string_view name = info.name;
  if (info.signature.operands[0] == ops::Type::Bool || info.signature.result == ops::Type::Bool)
    return;
  if (info.signature.hasInt()) return;  // wrapping around gives any integer
  if (name == "hash") return;  // pseudorandom: for more than one number it may have any value
  Sampler sample;
  for (int box = 0; box < 100; ++box) {
    ops::Operands<Interval> x;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::get<Row>(ops::table).domain[i];
      double a = sample.between(low, high), b = sample.between(low, high);
      x[i] = {std::min(a, b), std::max(a, b)};
    }
    // Fixes all but the first operand, so that dense samples show the true range.
    for (std::size_t i = 1; i < 3; ++i) x[i].high = x[i].low;
    const Interval range = ops::rangeOf(Op(Row), x);
    double low = infinity, high = -infinity, size = 0;
    const int n = 2000;
    for (int k = -1; k <= n; ++k) {
      const double t = static_cast<double>(k) / n;
      const double kink = x[0].has(0) ? 0 : x[0].low;
      const double at = k < 0 ? kink : x[0].low * (1 - t) + x[0].high * t;
      const double value = ops::valueOf(Op(Row), {at, x[1].low, x[2].low});
      low = std::min(low, value);
      high = std::max(high, value);
      size = std::max(size, std::abs(value));
    }
    // Between two samples, a value may exceed those at the samples by the square of their distance,
    // or by a jump.
    const bool jumps = name == "fract" || name == "mod" || name == "atan2";
    const double missed = jumps ? 0.01 * (high - low) + 0.01 : 2e-5;
    const double bound = 32 * rounding * (size + std::abs(x[1].low)) + missed;
    EXPECT_LE(range.high - high, bound) << name << " of " << x[0].low << ".." << x[0].high;
    EXPECT_LE(low - range.low, bound) << name << " of " << x[0].low << ".." << x[0].high;
  }
}

TEST(Interval, IsNotMuchWiderThanTheValues) {
  ops::withIndices<ops::count>([](auto... row) { (checkTightness<row>(), ...); });
}

void expectNear(Interval x, double low, double high) {
  EXPECT_LE(x.low, low);
  EXPECT_GE(x.high, high);
  const auto near = [](double a, double b) {
    return a == b || std::abs(a - b) <= 1e-5 * std::max(1.0, std::abs(b));
  };
  EXPECT_TRUE(near(x.low, low)) << x.low << " for " << low;
  EXPECT_TRUE(near(x.high, high)) << x.high << " for " << high;
}

TEST(Interval, ComputesArithmeticFromTheEndsOfTheIntervals) {
  expectNear(Interval(1, 2) + Interval(-5, 3), -4, 5);
  expectNear(Interval(1, 2) - Interval(-5, 3), -2, 7);
  expectNear(Interval(-2, 3) * Interval(-5, 4), -15, 12);
  expectNear(Interval(1, 6) / Interval(-2, -0.5), -12, -0.5);
  expectNear(square({-2, 1}), 0, 4);
}

TEST(Interval, DivisionByARangeContainingZeroIsUnbounded) {
  expectNear(Interval(1, 2) / Interval(-1, 1), -infinity, infinity);
  expectNear(Interval(1, 2) / Interval(0.0), -infinity, infinity);
  expectNear(Interval(1, 2) / Interval(-0.0, 1), -infinity, infinity);
}

// A length is never -0.0.
TEST(Interval, TheInverseOfALengthIsPositive) {
  const Interval length = sqrt(square({-1, 2}) + square({-2, 1}));
  expectNear(1.0 / length, std::sqrt(1.0 / 8), infinity);
  expectNear(exp(-1.0 / length), 0, std::exp(-std::sqrt(1.0 / 8)));
}

TEST(Interval, SineAndCosineReachTheirPeaks) {
  expectNear(sin(Interval(0, 3)), 0, 1);
  expectNear(sin(Interval(3, 5)), -1, std::sin(3));
  expectNear(sin(Interval(1, 1.5)), std::sin(1), std::sin(1.5));
  expectNear(sin(Interval(-100, 100)), -1, 1);
  expectNear(cos(Interval(-1, 2)), std::cos(2), 1);
  expectNear(cos(Interval(1e6, 1e6 + 0.25)), std::cos(1e6), std::cos(1e6 + 0.25));
  expectNear(tan(Interval(-1, 1.5)), std::tan(-1), std::tan(1.5));
  expectNear(tan(Interval(1, 2)), -infinity, infinity);
}

TEST(Interval, BoundsPowersForBasesOfEitherSign) {
  expectNear(pow(Interval(0, 2), Interval(3)), 0, 8);
  expectNear(pow(Interval(-3, 2), Interval(2)), 0, 9);
  expectNear(pow(Interval(-3, 2), Interval(3)), -27, 8);
  expectNear(pow(Interval(0.5, 2), Interval(-1, 3)), 0.125, 8);
  EXPECT_TRUE(pow(Interval(-3, -2), Interval(0.5)).isEmpty());
  EXPECT_TRUE(pow(Interval(-3, 2), Interval(0.5)).canBeNaN);
}

TEST(Interval, RemaindersAreExactWithinOnePeriod) {
  expectNear(mod(Interval(5, 5.5), Interval(2)), 1, 1.5);
  expectNear(mod(Interval(5, 6.5), Interval(2)), 0, 2);
  expectNear(mod(Interval(-1, -0.5), Interval(-3)), -1, -0.5);
  expectNear(fract(Interval(2.25, 2.5)), 0.25, 0.5);
  expectNear(fract(Interval(2.25, 3.5)), 0, 1);
}

TEST(Interval, TheAngleJumpsAtTheNegativeAxis) {
  expectNear(atan2(Interval(-1, 1), Interval(-2, -1)), -pi, pi);
  expectNear(atan2(Interval(-1, 1), Interval(1, 2)), -pi / 4, pi / 4);
  expectNear(atan2(Interval(1, 2), Interval(-1, 1)), pi / 4, 3 * pi / 4);
}

TEST(Interval, IgnoresNaN) {
  expectNear(sqrt(Interval(-1, 4)), 0, 2);
  EXPECT_TRUE(sqrt(Interval(-1, 4)).canBeNaN);
  EXPECT_TRUE(log(Interval(-2, -1)).isEmpty());
  EXPECT_TRUE((log(Interval(-2, -1)) + 1.0).isEmpty());
  EXPECT_TRUE(Interval(NAN).isEmpty());
  expectNear(acos(Interval(-3, 0.5)), std::acos(0.5), pi);
}

// Comparisons, min and max may return a number if an operand is NaN.
TEST(Interval, NaNCanStillDecideAComparison) {
  const Interval root = sqrt(Interval(-1, 4));
  EXPECT_TRUE(lt(root, 5.0).canBeFalse);
  expectNear(ifElse(lt(root, 5.0), 1.0, 2.0), 1, 2);
  expectNear(min(root, 7.0), 0, 7);
}

TEST(Interval, DecidesConditionsThatAreConstantOverTheInterval) {
  EXPECT_FALSE(lt(Interval(0, 1), Interval(2, 3)).canBeFalse);
  EXPECT_FALSE(lt(Interval(2, 3), Interval(0, 2)).canBeTrue);
  EXPECT_TRUE(le(Interval(2, 3), Interval(0, 2)).canBeTrue);
  EXPECT_FALSE(eq(Interval(2), Interval(2)).canBeFalse);
  EXPECT_FALSE(eq(Interval(2), Interval(3, 4)).canBeTrue);
  expectNear(ifElse(gt(Interval(2, 3), 0.0), 5.0, 6.0), 5, 5);
}

}  // namespace
}  // namespace warpjet
