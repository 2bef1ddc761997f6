// Four floats at a time: compares every row of the table with its value in double, which ops_test
// compares with numbers computed by hand. Errors are in units in the last place of a float: ulps.
#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "eval/lanes_math.hpp"
#include "graph/graph.hpp"
#include "ops/rows.hpp"

namespace warpjet {
namespace {

using ops::Operands;

template <std::size_t Row, std::size_t I>
auto operand(const Operands<Lanes>& operands) {
  if constexpr (ops::declarations[Row].signature.operands[I] == ops::Type::Bool) {
    return ne(operands[I], 0.0);
  } else {
    return operands[I];
  }
}

Lanes asNumber(Mask condition) {
  for (std::size_t i = 0; i < Lanes::count; ++i)
    EXPECT_TRUE(condition.bits[i] == 0 || condition.bits[i] == -1) << "all bits or none";
  return ifElse(condition, 1.0, 0.0);
}
Lanes asNumber(Lanes x) { return x; }

template <std::size_t Row>
Lanes evaluateRow(const Operands<Lanes>& operands) {
  // Integers are computed lane by lane; see blocks_test.cpp.
  if constexpr (ops::declarations[Row].signature.hasInt()) {
    return operands[0];
  } else {
    constexpr auto value = std::get<Row>(ops::table).value;
    return ops::withIndices<ops::declarations[Row].arity>(
        [&](auto... i) { return asNumber(value(operand<Row, i>(operands)...)); });
  }
}

constexpr auto evaluators =
    ops::withIndices<ops::count>([](auto... row) { return std::array{&evaluateRow<row>...}; });

std::size_t rowNamed(std::string_view name) {
  for (std::size_t row = 0; row < ops::count; ++row) {
    if (ops::declarations[row].name == name) return row;
  }
  ADD_FAILURE() << "no row " << name;
  return 0;
}

float fromBits(std::uint32_t bits) { return __builtin_bit_cast(float, bits); }
std::uint32_t bitsOf(float x) { return __builtin_bit_cast(std::uint32_t, x); }

// Returns the error of a float, in multiples of the distance to the next float. NaN is only correct
// if NaN is expected; infinity and signed zeros only for numbers that round to them.
double ulps(float actual, double expected) {
  constexpr double wrong = 1e30;
  const auto nearest = static_cast<float>(expected);
  if (std::isnan(expected) || std::isnan(actual))
    return std::isnan(expected) && std::isnan(actual) ? 0 : wrong;
  if (std::isinf(actual) || std::isinf(nearest)) {
    const double greatest = std::numeric_limits<float>::max();
    const bool isAtLimit = std::abs(std::abs(expected) / greatest - 1) < 1e-7;
    return actual == nearest || (isAtLimit && std::signbit(actual) == std::signbit(nearest))
               ? 0
               : wrong;
  }
  if (actual == 0 && nearest == 0) return std::signbit(actual) == std::signbit(nearest) ? 0 : wrong;
  int exponent = 0;
  std::frexp(expected, &exponent);
  return std::abs(actual - expected) / std::ldexp(1.0, std::max(exponent - 24, -149));
}

bool isFloatFunction(const ops::Declaration& row, int arity) {
  return row.arity == arity && row.signature.result == ops::Type::Float &&
         row.signature.operands[0] == ops::Type::Float;
}

// Bounds measured by sweeps over all floats; the default is 2.
const std::map<std::string_view, double> tighterBounds{
    {"neg", 0},    {"abs", 0},      {"sign", 0},     {"floor", 0},    {"ceil", 0},   {"round", 0},
    {"trunc", 0},  {"sqrt", 0.501}, {"fract", 0.5},  {"tan", 0.6},    {"log", 0.52}, {"log2", 0.52},
    {"hash", 0},   {"asinh", 0.52}, {"acosh", 0.52}, {"atanh", 0.52}, {"exp", 1},    {"exp2", 1},
    {"acos", 1.2}, {"atan", 1.5},   {"cosh", 1.5},   {"tanh", 1.5},   {"sinh", 1.6},
};

double boundOf(std::string_view name) {
  const auto found = tighterBounds.find(name);
  return found == tighterBounds.end() ? 2 : found->second;
}

// Finds the largest of many errors, so that a failure is one line.
class LargestError {
 public:
  LargestError(std::size_t row, double bound) : row_(row), bound_(bound) {}
  ~LargestError() {
    EXPECT_LE(ulps_, bound_) << ops::declarations[row_].name << " of " << x_[0] << ", " << x_[1]
                             << ": " << actual_ << " instead of "
                             << ops::valueOf(Op(row_), {x_[0], x_[1], 0});
  }

  void check(const Operands<Lanes>& operands) {
    const Lanes results = evaluators[row_](operands);
    for (std::size_t i = 0; i < Lanes::count; ++i) {
      const double a = operands[0][i], b = operands[1][i];
      // The hash takes another hash, and a cell of float32; for other numbers it is undefined.
      if (ops::declarations[row_].name == "hash" && !(a >= 0 && a < 4091 && std::abs(b) <= 0x1p24))
        continue;
      const double distance = ulps(results[i], ops::valueOf(Op(row_), {a, b, 0}));
      if (distance > ulps_) {
        ulps_ = distance;
        x_ = {a, b};
        actual_ = results[i];
      }
    }
  }

  // Checks four numbers at a time.
  void check(const std::vector<float>& xs) {
    for (std::size_t i = 0; i < xs.size(); i += Lanes::count) {
      Lanes x = 1.0;
      for (std::size_t k = 0; k < Lanes::count && i + k < xs.size(); ++k) x.set(k, xs[i + k]);
      check(Operands<Lanes>{x, 0.0, 0.0});
    }
  }

 private:
  std::size_t row_;
  double bound_, ulps_ = 0;
  std::array<double, 2> x_{};
  float actual_ = 0;
};

TEST(Lanes, EveryRowAgreesWithItsValueInDouble) {
  std::mt19937 random(1);
  for (std::size_t row = 0; row < ops::count; ++row) {
    const ops::Declaration& info = ops::declarations[row];
    if (info.signature.hasInt()) continue;
    const ops::Domain domain = std::apply(
        [&](const auto&... each) { return std::array{each.domain...}[row]; }, ops::table);
    for (int point = 0; point < 500; ++point) {
      Operands<Lanes> operands{};
      for (int k = 0; k < info.arity; ++k) {
        std::uniform_real_distribution within(domain[k].low, domain[k].high);
        const bool isCondition = info.signature.operands[k] == ops::Type::Bool;
        for (std::size_t i = 0; i < Lanes::count; ++i) {
          const double x = within(random);
          operands[k].set(i, static_cast<float>(isCondition ? x > 0 : x));
        }
      }
      const Lanes results = evaluators[row](operands);
      for (std::size_t i = 0; i < Lanes::count; ++i) {
        Operands<double> x{};
        double largest = 1;
        for (int k = 0; k < info.arity; ++k) {
          x[k] = operands[k][i];
          largest = std::max(largest, std::abs(x[k]));
        }
        const double expected = ops::valueOf(Op(row), x);
        // Terms may be larger than their sum: in mix, these are products of operands.
        const double summed = std::max(std::abs(expected), std::pow(largest, info.arity - 1));
        EXPECT_NEAR(results[i], expected, 4 * 0x1p-24 * summed)
            << info.name << " of " << x[0] << ", " << x[1] << ", " << x[2];
      }
    }
  }
}

TEST(Lanes, UnaryFunctionsMeetTheirErrorBoundsForAllFloats) {
  for (std::size_t row = 0; row < ops::count; ++row) {
    if (!isFloatFunction(ops::declarations[row], 1)) continue;
    LargestError error(row, boundOf(ops::declarations[row].name));
    std::vector<float> xs;
    for (std::uint64_t bits = row; bits <= 0xffffffff; bits += 16381)
      xs.push_back(fromBits(static_cast<std::uint32_t>(bits)));
    // More samples where functions curve.
    for (std::uint32_t bits = bitsOf(0x1p-6f); bits < bitsOf(0x1p14f); bits += 2039) {
      xs.push_back(fromBits(bits));
      xs.push_back(-fromBits(bits));
    }
    error.check(xs);
  }
}

// The hash is ((1597 (h + i) + 823) mod 4091)^3 mod 4091.
TEST(Lanes, HashesAreThoseOfIntegers) {
  const auto modulo = [](std::int64_t x) { return (x % 4091 + 4091) % 4091; };
  const std::size_t row = index(ops::find("hash"));
  int wrong = 0;
  for (const int h : {0, 1, 2045, 2046, 4090}) {
    for (std::int64_t first = -(1 << 24); first <= 1 << 24; first += first < 1 << 23 ? 4 : 4091) {
      Operands<Lanes> operands{Lanes(double(h)), Lanes(0.0), Lanes(0.0)};
      for (int k = 0; k < 4; ++k) operands[1].set(k, static_cast<float>(first + k));
      const Lanes results = evaluators[row](operands);
      for (int k = 0; k < 4; ++k) {
        const std::int64_t i = static_cast<std::int64_t>(operands[1][k]);
        const std::int64_t n = modulo(1597 * (h + modulo(i)) + 823);
        wrong += results[k] != static_cast<float>(modulo(modulo(n * n) * n));
      }
    }
  }
  EXPECT_EQ(wrong, 0);
}

std::vector<float> specialFloats() {
  std::vector<float> floats{std::numeric_limits<float>::quiet_NaN()};
  for (const float x : {0.0f,          1e-45f,
                        1e-40f,        1.17549435e-38f,
                        1e-30f,        0x1p-24f,
                        0x1p-12f,      0.5f,
                        0.75f,         1.5f,
                        2.0f,          2.5f,
                        3.0f,          4.0f,
                        10.0f,         11.0f,
                        88.5f,         89.5f,
                        104.0f,        127.5f,
                        128.0f,        150.0f,
                        8388607.5f,    8388608.0f,
                        16777215.0f,   2147483648.0f,
                        1e10f,         1e30f,
                        3.4028235e38f, static_cast<float>(infinity)}) {
    floats.push_back(x);
    floats.push_back(-x);
  }
  for (const float x : {1.0f, 0.5f}) {
    for (const float near : {x, std::nextafter(x, 0.0f), std::nextafter(x, 2.0f)}) {
      floats.push_back(near);
      floats.push_back(-near);
    }
  }
  return floats;
}

TEST(Lanes, UnaryFunctionsAreCorrectAtSpecialValues) {
  for (std::size_t row = 0; row < ops::count; ++row) {
    if (isFloatFunction(ops::declarations[row], 1))
      LargestError(row, boundOf(ops::declarations[row].name)).check(specialFloats());
  }
}

TEST(Lanes, BinaryFunctionsAreCorrectAtSpecialValues) {
  for (std::size_t row = 0; row < ops::count; ++row) {
    const ops::Declaration& info = ops::declarations[row];
    // mod rounds x / y, as in all languages: for large x its value has a large error.
    if (info.arity != 2 || info.signature.operands[0] != ops::Type::Float || info.name == "mod")
      continue;
    LargestError error(row, boundOf(info.name));
    for (const float x : specialFloats()) {
      for (const float y : specialFloats()) error.check(Operands<Lanes>{x, y, 0.0});
    }
  }
}

TEST(Lanes, ModMatchesFloatArithmetic) {
  const Lanes x = Lanes::Floats{-1, 1, 5.5, -0.25}, y = Lanes::Floats{3, -3, 2, 1};
  const Lanes rest = mod(x, y);
  for (const auto& [i, expected] :
       std::map<std::size_t, float>{{0, 2}, {1, -2}, {2, 1.5}, {3, 0.75}})
    EXPECT_EQ(rest[i], expected);
  EXPECT_TRUE(std::isnan(mod(Lanes(1.0f), Lanes(0.0f))[0]));
}

TEST(Lanes, PowAndAtanMeetTheirErrorBounds) {
  std::mt19937 random(1);
  for (const std::string_view name : {"pow", "atan2"}) {
    LargestError error(rowNamed(name), 1.6);
    std::uniform_real_distribution<float> exponents(-40, 40), powers(-4, 4), around(-4, 4);
    for (int i = 0; i < 60'000; ++i) {
      Operands<Lanes> bits, moderate, wide;
      for (std::size_t k = 0; k < Lanes::count; ++k) {
        bits[0].set(k, fromBits(static_cast<std::uint32_t>(random())));
        bits[1].set(k, fromBits(static_cast<std::uint32_t>(random())));
        moderate[0].set(k, around(random));
        moderate[1].set(k, random() % 2 == 0 ? around(random) : std::rint(around(random)));
        wide[0].set(k, std::exp2(exponents(random)));
        wide[1].set(k, powers(random));
      }
      error.check(bits);
      error.check(moderate);
      error.check(wide);
    }
  }
}

// Near multiples of π/2, the sine, the cosine or the cotangent is close to 0: most digits cancel in
// the difference between x and the multiple.
TEST(Lanes, AnglesNearMultiplesOfRightAnglesAreAccurate) {
  std::vector<float> xs;
  for (int k = 1; k < 20'000; ++k) {
    const auto multiple = static_cast<float>(k * 1.5707963267948966);
    for (int step = -2; step <= 2; ++step) {
      xs.push_back(fromBits(bitsOf(multiple) + static_cast<std::uint32_t>(step)));
      xs.push_back(-xs.back());
    }
  }
  for (const std::string_view name : {"sin", "cos", "tan"})
    LargestError(rowNamed(name), boundOf(name)).check(xs);
}

// Includes W. Kahan's hard case for the reduction of angles, 0x1.f1b04p76.
TEST(Lanes, HugeAnglesAreReducedExactly) {
  for (const std::string_view name : {"sin", "cos", "tan"})
    LargestError(rowNamed(name), boundOf(name))
        .check({12799.99f, 12800.0f, 12800.001f, 1e5f, 0x1p20f, 1048577.0f, 0x1.f1b04p76f,
                3.4028235e38f, -1e22f, -3e8f});
}

TEST(Lanes, NoLaneAffectsAnother) {
  std::mt19937 random(2);
  const std::vector<float> specials = specialFloats();
  for (std::size_t row = 0; row < ops::count; ++row) {
    for (const float special : specials) {
      Operands<Lanes> ordinary, disturbed;
      const std::size_t lane = random() % Lanes::count;
      for (std::size_t k = 0; k < ops::maxArity; ++k) {
        for (std::size_t i = 0; i < Lanes::count; ++i)
          ordinary[k].set(i, std::uniform_real_distribution(0.1f, 0.9f)(random));
        disturbed[k] = ordinary[k];
        disturbed[k].set(lane, special);
      }
      const Lanes before = evaluators[row](ordinary), after = evaluators[row](disturbed);
      for (std::size_t i = 0; i < Lanes::count; ++i) {
        if (i == lane) continue;
        EXPECT_EQ(bitsOf(before[i]), bitsOf(after[i]))
            << ops::declarations[row].name << ", " << special;
      }
    }
  }
}

}  // namespace
}  // namespace warpjet
