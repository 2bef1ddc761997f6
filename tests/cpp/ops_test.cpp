// Every row: compares its value with numbers computed by hand from the GLSL ES 3.00 specification,
// its partial derivatives with finite differences of its value, and its lowered formula with its
// value.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "ops/rows.hpp"

namespace warpjet::ops {
namespace {

double valueOfRowNamed(std::string_view name, double a, double b = 0, double c = 0) {
  for (std::size_t i = 0; i < count; ++i) {
    if (declarations[i].name == name) return valueOf(Op(i), {a, b, c});
  }
  ADD_FAILURE() << "no row " << name;
  return NAN;
}

struct Case {
  std::string_view row;
  Operands<double> operands;
  double value;
};

// Expects a value that is equal up to rounding; zeros, infinities and NaN must match exactly.
void expectValue(const Case& expected) {
  const auto [a, b, c] = expected.operands;
  const double value = valueOfRowNamed(expected.row, a, b, c);
  const std::string operation = std::string(expected.row) + " of " + std::to_string(a) + ", " +
                                std::to_string(b) + ", " + std::to_string(c);
  if (std::isnan(expected.value)) {
    EXPECT_TRUE(std::isnan(value)) << operation;
  } else {
    EXPECT_DOUBLE_EQ(value, expected.value) << operation;
  }
}

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Ops, ValuesMatchGlsl) {
  const double e = 2.718281828459045, pi = 3.141592653589793, root2 = 1.4142135623730951;
  const std::vector<Case> cases{
      {"neg", {2}, -2},
      {"add", {2, 3}, 5},
      {"sub", {2, 3}, -1},
      {"mult", {-2, 3}, -6},
      {"div", {3, 4}, 0.75},
      {"pow", {2, 10}, 1024},
      {"pow", {2, 0.5}, root2},
      {"pow", {4, -1.5}, 0.125},
      {"sqrt", {2}, root2},
      {"inversesqrt", {4}, 0.5},
      {"exp", {1}, e},
      {"exp", {0}, 1},
      {"exp2", {-3}, 0.125},
      {"exp2", {0.5}, root2},
      {"log", {e}, 1},
      {"log", {1}, 0},
      {"log2", {8}, 3},
      {"log2", {0.25}, -2},
      {"sin", {pi / 6}, 0.5},
      {"cos", {pi / 3}, 0.5},
      {"tan", {pi / 4}, 1},
      {"asin", {0.5}, pi / 6},
      {"acos", {-0.5}, 2 * pi / 3},
      {"atan", {1}, pi / 4},
      {"atan2", {1, -1}, 3 * pi / 4},
      {"atan2", {-1, 0}, -pi / 2},
      // With e^x = 2: sinh = (2 - 1/2) / 2, cosh = (2 + 1/2) / 2.
      {"sinh", {0.6931471805599453}, 0.75},
      {"cosh", {0.6931471805599453}, 1.25},
      {"tanh", {0.6931471805599453}, 0.6},
      {"asinh", {-0.75}, -0.6931471805599453},
      {"acosh", {1.25}, 0.6931471805599453},
      {"acosh", {1}, 0},
      {"atanh", {0.6}, 0.6931471805599453},
      {"tanh", {400}, 1},
      {"tanh", {-400}, -1},
      {"abs", {-3}, 3},
      {"sign", {-7}, -1},
      {"sign", {0}, 0},
      {"sign", {0.1}, 1},
      {"floor", {-0.25}, -1},
      {"floor", {2}, 2},
      {"ceil", {-0.25}, 0},
      {"ceil", {0.25}, 1},
      {"ceil", {2}, 2},
      {"round", {-2.5}, -2},
      {"round", {-1.5}, -2},
      {"round", {-0.5}, 0},
      {"round", {0.5}, 0},
      {"round", {1.5}, 2},
      {"round", {2.5}, 2},
      {"round", {0.49999999999999994}, 0},
      {"round", {2.4}, 2},
      {"round", {-2.6}, -3},
      {"trunc", {-2.75}, -2},
      {"trunc", {-0.75}, 0},
      {"trunc", {2.75}, 2},
      {"fract", {-0.25}, 0.75},
      {"fract", {2.25}, 0.25},
      {"mod", {-1, 3}, 2},
      {"mod", {1, -3}, -2},
      {"mod", {5.5, 2}, 1.5},
      {"min", {2, -3}, -3},
      {"max", {2, -3}, 2},
      {"clamp", {5, 0, 1}, 1},
      {"clamp", {-5, 0, 1}, 0},
      {"clamp", {0.5, 0, 1}, 0.5},
      {"clamp", {5, 2, 1}, 1},
      {"clamp", {0, 2, 1}, 1},
      {"mix", {10, 20, 0.25}, 12.5},
      {"mix", {10, 20, 2}, 30},
      {"step", {2, 2}, 1},
      {"step", {2, 1.9}, 0},
      {"lt", {1, 1}, 0},
      {"lt", {1, 2}, 1},
      {"le", {1, 1}, 1},
      {"le", {2, 1}, 0},
      {"gt", {1, 1}, 0},
      {"gt", {2, 1}, 1},
      {"ge", {1, 1}, 1},
      {"ge", {1, 2}, 0},
      {"eq", {1, 1}, 1},
      {"eq", {1, 2}, 0},
      {"ne", {1, 1}, 0},
      {"ne", {1, 2}, 1},
      {"and", {1, 1}, 1},
      {"and", {1, 0}, 0},
      {"or", {0, 1}, 1},
      {"or", {0, 0}, 0},
      {"not", {1}, 0},
      {"not", {0}, 1},
      {"ifElse", {1, 2, 3}, 2},
      {"ifElse", {0, 2, 3}, 3},
      {"hash", {0, 0}, 2107},   // 823³ modulo 4091
      {"hash", {3, -1}, 3876},  // 1597 (3 - 1) + 823 is -74, and -74³ is 3876
      {"float", {1}, 1},
      {"float", {0}, 0},
      {"bool", {-0.5}, 1},
      {"bool", {0}, 0},
      // Integers of 32 bits, from -2^31: -1 has all bits set and is the largest unsigned number.
      {"int", {-2.75}, -2},
      {"int", {3e9}, 2147483647},
      {"int", {NAN}, 0},
      {"bitsOf", {3e9}, 3e9 - 4294967296},
      {"bitsOf", {-5}, 0},
      {"intToFloat", {16777217}, 16777216},
      {"intToFloat", {-3}, -3},
      {"bitsToFloat", {-1}, 4294967296},
      {"bitsToFloat", {7}, 7},
      {"floatBitsToInt", {1}, 0x3f800000},
      {"floatBitsToInt", {-2}, -1073741824},
      {"intBitsToFloat", {0x40490fdb}, 3.1415927410125732},
      {"intAdd", {2147483647, 1}, -2147483648.0},
      {"intSub", {-2147483648.0, 1}, 2147483647},
      {"intMult", {65536, 65537}, 65536},
      {"intMult", {-3, 5}, -15},
      {"intDiv", {-7, 2}, -3},
      {"intDiv", {5, 0}, 5},
      {"intDiv", {-2147483648.0, -1}, -2147483648.0},
      {"intMod", {-7, 3}, -1},
      {"intMod", {7, -3}, 1},
      {"intMod", {-2147483648.0, -1}, 0},
      {"intMod", {5, 0}, 0},
      {"bitsDiv", {-1, 2}, 2147483647},
      {"bitsMod", {-1, 10}, 5},
      {"bitAnd", {-1, 0xf0}, 0xf0},
      {"bitOr", {0x50, 0x0f}, 0x5f},
      {"bitXor", {-1, 1}, -2},
      {"bitNot", {0}, -1},
      {"shiftLeft", {3, 30}, -1073741824},
      {"shiftLeft", {1, 33}, 2},
      {"shiftRight", {-8, 1}, -4},
      {"bitsShiftRight", {-1, 28}, 15},
      {"intLt", {-1, 1}, 1},
      {"intLt", {1, 1}, 0},
      {"bitsLt", {-1, 1}, 0},
      {"bitsLt", {1, 2}, 1},
      {"intEq", {-1, -1}, 1},
      {"intEq", {1, 2}, 0},
      {"intIfElse", {1, 2, 3}, 2},
      {"intIfElse", {0, 2, 3}, 3},
  };
  std::set<std::string_view> checked;
  for (const Case& expected : cases) {
    expectValue(expected);
    checked.insert(expected.row);
  }
  for (const Declaration& row : declarations) EXPECT_TRUE(checked.contains(row.name)) << row.name;
}

TEST(Ops, ValuesAtInfinityMatchIeee754) {
  for (const Case& expected : std::vector<Case>{{"div", {1, 0}, infinity},
                                                {"div", {0, 0}, NAN},
                                                {"log", {0}, -infinity},
                                                {"log2", {0}, -infinity},
                                                {"exp2", {-infinity}, 0},
                                                {"inversesqrt", {0}, infinity},
                                                {"sqrt", {-1}, NAN},
                                                {"acosh", {0.5}, NAN},
                                                {"atanh", {1}, infinity},
                                                {"round", {-infinity}, -infinity},
                                                {"trunc", {infinity}, infinity},
                                                {"tanh", {-infinity}, -1}})
    expectValue(expected);
}

// Returns the derivative by central differences with Richardson extrapolation; the error is of
// order h^4.
template <class Function>
double slope(Function f, double x, double h) {
  const auto central = [&](double step) { return (f(x + step) - f(x - step)) / (2 * step); };
  return (4 * central(h / 2) - central(h)) / 3;
}

class Sampler {
 public:
  double operator()(Extent extent) {
    return std::uniform_real_distribution(extent.low, extent.high)(random_);
  }

 private:
  std::mt19937 random_{1};
};

// Checks the partial derivative of row `Row` with respect to operand `Operand`, at random points of
// its domain.
template <std::size_t Row, std::size_t Operand>
void checkPartial() {
  constexpr auto& row = std::get<Row>(table);
  Sampler sample;
  constexpr int points = 400;
  int kinks = 0;
  for (int point = 0; point < points; ++point) {
    Operands<double> x{};
    for (int i = 0; i < declarations[Row].arity; ++i) x[i] = sample(row.domain[i]);
    const auto valueAt = [&](double t) {
      auto moved = x;
      moved[Operand] = t;
      return valueOf(Op(Row), moved);
    };
    const double coarse = slope(valueAt, x[Operand], 1e-3), fine = slope(valueAt, x[Operand], 5e-4);
    if (std::abs(coarse - fine) > 1e-6 * std::max(1.0, std::abs(fine))) {
      ++kinks;
      continue;
    }
    const double value = valueOf(Op(Row), x);
    double partial = 0;
    if constexpr (Operand < std::tuple_size_v<decltype(row.partials)>)
      partial = term<Row, Operand>(x.data(), value, 1.0);
    EXPECT_NEAR(partial, fine, 1e-7 * std::max(1.0, std::abs(fine)))
        << row.name << " by operand " << Operand << " at " << x[0] << ", " << x[1] << ", " << x[2];
  }
  EXPECT_LT(kinks, points / 20) << row.name;
}

template <std::size_t Row>
void checkRow() {
  if constexpr (declarations[Row].signature.result == Type::Float &&
                declarations[Row].signature.operands[0] == Type::Float) {
    withIndices<declarations[Row].arity>([](auto... i) { (checkPartial<Row, i>(), ...); });
  }
}

TEST(Ops, PartialDerivativesMatchFiniteDifferences) {
  withIndices<count>([](auto... row) { (checkRow<row>(), ...); });
}

// Checks the formula of row `Row`, if it has one, at one point.
template <std::size_t Row>
void checkFormula(const Operands<double>& x) {
  using Lowered = decltype(std::get<Row>(table).lowered);
  if constexpr (!std::is_same_v<Lowered, NoFormula>) {
    constexpr auto formula = std::get<Row>(table).lowered;
    const double value = valueOf(Op(Row), x);
    const double lowered = applyTo<declarations[Row].arity>(formula, x.data());
    const auto operation = [&] {
      return std::string(declarations[Row].name) + " of " + std::to_string(x[0]) + ", " +
             std::to_string(x[1]);
    };
    if (std::isinf(value)) {
      EXPECT_EQ(lowered, value) << operation();
    } else {
      EXPECT_NEAR(lowered, value, 1e-14 * std::max(1.0, std::abs(value))) << operation();
    }
  }
}

template <std::size_t Row>
void checkFormulaOnDomain() {
  Sampler sample;
  for (int point = 0; point < 2000; ++point) {
    Operands<double> x{};
    for (int i = 0; i < declarations[Row].arity; ++i) x[i] = sample(std::get<Row>(table).domain[i]);
    checkFormula<Row>(x);
  }
}

TEST(Ops, LoweredFormulasHaveTheSameValues) {
  withIndices<count>([](auto... row) { (checkFormulaOnDomain<row>(), ...); });
}

TEST(Ops, LoweredFormulasHaveTheSameValuesAtEdges) {
  constexpr auto rowOf = [](std::string_view name) {
    std::size_t i = 0;
    while (declarations[i].name != name) ++i;
    return i;
  };
  const auto forBothSigns = [](std::vector<double> points, auto check) {
    for (const double x : points) {
      check(x);
      check(-x);
    }
  };
  const double almostHalf = 0.49999999999999994;
  forBothSigns({0, 0.5, 1.5, 2.5, 3.5, 1, 2, 3, almostHalf, 1e-12, 0.7, 2.7, 1e9 + 0.5, 1e15},
               [&](double x) {
                 checkFormula<rowOf("round")>({x});
                 checkFormula<rowOf("trunc")>({x});
                 for (const double divisor : {1.0, -1.0, 3.0, 0.25})
                   checkFormula<rowOf("mod")>({x, divisor});
               });
  forBothSigns({0, 1e-9, 1, 20, 50, 300, 700, 1e5, 1e300, infinity},
               [&](double x) { checkFormula<rowOf("tanh")>({x}); });
  forBothSigns({0, 1e-9, 20, 700, 1e5}, [&](double x) {
    checkFormula<rowOf("sinh")>({x});
    checkFormula<rowOf("cosh")>({x});
    checkFormula<rowOf("asinh")>({x});
  });
  checkFormula<rowOf("acosh")>({1});
  checkFormula<rowOf("acosh")>({1e9});
  for (const double x : {0.0, 1.0, -1.0, 0.999}) checkFormula<rowOf("atanh")>({x});
}

TEST(Ops, NamesAreDistinct) {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(declarations[i].name, declarations[j].name);
  }
}

}  // namespace
}  // namespace warpjet::ops
