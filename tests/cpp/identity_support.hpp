// Variables, values and random points of patterns, computed from the patterns themselves, without a
// graph.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "graph/identities.hpp"
#include "support.hpp"

namespace warpjet::identities {

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
    if (item->kind == Kind::Function) return item->function->valueOf(visit(item + 1));
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

// Draws random numbers, which are the same on all machines, unlike those of the standard library's
// distributions.
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

// Returns random values that satisfy the condition; nullopt if those drawn don't.
inline std::optional<At> drawPoint(const Identity& identity, Chance& chance, Arithmetic round) {
  const Variables variables(identity.from);
  At at{};
  for (std::size_t i = 0; i < letters; ++i) {
    if (variables.kinds[i]) at[i] = chance.value(*variables.kinds[i], variables.types[i], round);
  }
  if (Evaluation(identity.when, at, {false}).value == 0) return std::nullopt;
  return at;
}

}  // namespace warpjet::identities
