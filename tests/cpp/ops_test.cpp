// Every row: its partial derivatives against finite differences of its value, and its value at
// points worked out by hand from the GLSL ES 3.00 specification.
#include "ops/ops.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace warpjet::ops {
namespace {

double valueOf(std::string_view name, double a, double b = 0, double c = 0) {
  for (std::size_t i = 0; i < count; ++i) {
    if (infos[i].name == name) return evaluate(Op(i), {a, b, c});
  }
  ADD_FAILURE() << "no row " << name;
  return NAN;
}

TEST(Ops, ValuesAreThoseOfGlsl) {
  EXPECT_EQ(valueOf("add", 2, 3), 5);
  EXPECT_EQ(valueOf("sub", 2, 3), -1);
  EXPECT_EQ(valueOf("div", 3, 4), 0.75);
  EXPECT_EQ(valueOf("mod", -1, 3), 2);
  EXPECT_EQ(valueOf("fract", -0.25), 0.75);
  EXPECT_EQ(valueOf("floor", -0.25), -1);
  EXPECT_EQ(valueOf("sign", -7), -1);
  EXPECT_EQ(valueOf("sign", 0), 0);
  EXPECT_EQ(valueOf("step", 2, 2), 1);
  EXPECT_EQ(valueOf("step", 2, 1.9), 0);
  EXPECT_EQ(valueOf("mix", 10, 20, 0.25), 12.5);
  EXPECT_EQ(valueOf("clamp", 5, 0, 1), 1);
  EXPECT_EQ(valueOf("clamp", -5, 0, 1), 0);
  EXPECT_EQ(valueOf("inversesqrt", 4), 0.5);
  EXPECT_DOUBLE_EQ(valueOf("atan2", 1, -1), 3 * M_PI / 4);
  EXPECT_EQ(valueOf("ifElse", 1, 2, 3), 2);
  EXPECT_EQ(valueOf("lt", 1, 1), 0);
  EXPECT_EQ(valueOf("le", 1, 1), 1);
  EXPECT_EQ(valueOf("not", 1), 0);
}

// Central differences with Richardson extrapolation: error of order h^4.
template <class Function>
double slope(Function f, double x, double h) {
  const auto central = [&](double step) { return (f(x + step) - f(x - step)) / (2 * step); };
  return (4 * central(h / 2) - central(h)) / 3;
}

class Sampler {
 public:
  double operator()(Interval interval) {
    return std::uniform_real_distribution(interval.low, interval.high)(random_);
  }

 private:
  std::mt19937 random_{1};
};

// Checks the partial derivative by operand `Operand` of row `Row` at random points of its domain.
template <std::size_t Row, std::size_t Operand>
void checkPartial() {
  constexpr auto& row = std::get<Row>(table);
  Sampler sample;
  constexpr int points = 400;
  int kinks = 0;
  for (int point = 0; point < points; ++point) {
    std::array<double, maxArity> x{};
    for (int i = 0; i < row.arity; ++i) x[i] = sample(row.domain[i]);
    const auto along = [&](double t) {
      auto moved = x;
      moved[Operand] = t;
      return evaluate(Op(Row), moved);
    };
    const double coarse = slope(along, x[Operand], 1e-3), fine = slope(along, x[Operand], 5e-4);
    if (std::abs(coarse - fine) > 1e-6 * std::max(1.0, std::abs(fine))) {
      ++kinks;
      continue;
    }
    const double value = evaluate(Op(Row), x);
    double partial = 0;
    if constexpr (Operand < std::tuple_size_v<decltype(row.partials)>)
      partial = spread<infos[Row].arity>(std::get<Operand>(row.partials), x.data(), value);
    EXPECT_NEAR(partial, fine, 1e-7 * std::max(1.0, std::abs(fine)))
        << row.name << " by operand " << Operand << " at " << x[0] << ", " << x[1] << ", " << x[2];
  }
  EXPECT_LT(kinks, points / 20) << row.name;
}

template <std::size_t Row>
void checkRow() {
  if constexpr (infos[Row].signature.result == Type::Float &&
                infos[Row].signature.operands[0] == Type::Float) {
    [&]<std::size_t... I>(std::index_sequence<I...>) { (checkPartial<Row, I>(), ...); }
    (std::make_index_sequence<infos[Row].arity>{});
  }
}

TEST(Ops, PartialDerivativesMatchFiniteDifferences) {
  [&]<std::size_t... Row>(std::index_sequence<Row...>) { (checkRow<Row>(), ...); }
  (std::make_index_sequence<count>{});
}

TEST(Ops, KinksFollowTheConvention) {
  constexpr Op sqrtOp = find("sqrt"), absOp = find("abs");
  const auto& sqrtRow = std::get<static_cast<std::size_t>(sqrtOp)>(table);
  const auto& absRow = std::get<static_cast<std::size_t>(absOp)>(table);
  EXPECT_EQ(std::get<0>(sqrtRow.partials)(0.0, 0.0), 0);
  EXPECT_EQ(std::get<0>(absRow.partials)(0.0, 0.0), 0);
  const auto& minRow = std::get<static_cast<std::size_t>(find("min"))>(table);
  EXPECT_EQ(std::get<0>(minRow.partials)(2.0, 2.0, 2.0), 1) << "equal operands: the first one";
  EXPECT_EQ(std::get<1>(minRow.partials)(2.0, 2.0, 2.0), 0);
}

TEST(Ops, NamesAreDistinct) {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(infos[i].name, infos[j].name);
  }
}

}  // namespace
}  // namespace warpjet::ops
