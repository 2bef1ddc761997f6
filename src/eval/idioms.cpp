#include "eval/idioms.hpp"

namespace warpjet {

namespace {

constexpr Op add = ops::find("add"), sub = ops::find("sub"), mult = ops::find("mult");

bool isConstant(const Words& words, std::uint32_t i, double value) {
  return words.op(i) == constantOp && words.constant(i) == value;
}

bool isSquare(const Words& words, std::uint32_t i, std::uint32_t x) {
  return words.op(i) == mult && words.operands(i)[0] == x && words.operands(i)[1] == x;
}

// Returns true for x * x plus a nonnegative term. Sums are left-associative.
bool isSumWithSquare(const Words& words, std::span<const Interval> ranges, std::uint32_t sum,
                     std::uint32_t x) {
  while (words.op(sum) == add) {
    const auto parts = words.operands(sum);
    if (!(ranges[parts[0]].low >= 0 && ranges[parts[1]].low >= 0)) return false;
    if (isSquare(words, parts[1], x)) return true;
    sum = parts[0];
  }
  return isSquare(words, sum, x);
}

// Returns true for 1 / sqrt(x * x + ...), also if an ifElse replaces infinity by 0.
bool isInverseLength(const Words& words, std::span<const Interval> ranges, std::uint32_t i,
                     std::uint32_t x) {
  if (words.op(i) == ops::find("ifElse") && isConstant(words, words.operands(i)[2], 0))
    i = words.operands(i)[1];
  return words.op(i) == ops::find("inversesqrt") &&
         isSumWithSquare(words, ranges, words.operands(i)[0], x);
}

// Returns true for `factor` times x.
bool isMultiple(const Words& words, std::uint32_t i, double factor, std::uint32_t x) {
  if (words.op(i) != mult) return false;
  const auto parts = words.operands(i);
  return (parts[0] == x && isConstant(words, parts[1], factor)) ||
         (parts[1] == x && isConstant(words, parts[0], factor));
}

// Returns true for 3 - 2 x.
bool isFallingLine(const Words& words, std::uint32_t i, std::uint32_t x) {
  if (words.op(i) != add && words.op(i) != sub) return false;
  const auto parts = words.operands(i);
  if (words.op(i) == sub)
    return isConstant(words, parts[0], 3) && isMultiple(words, parts[1], 2, x);
  return (isConstant(words, parts[0], 3) && isMultiple(words, parts[1], -2, x)) ||
         (isConstant(words, parts[1], 3) && isMultiple(words, parts[0], -2, x));
}

double smooth(double x) { return x * x * (3 - 2 * x); }

}  // namespace

Idiom idiomOf(const Words& words, std::span<const Interval> ranges, std::uint32_t instruction) {
  const Op op = words.op(instruction);
  const auto x = words.operands(instruction);
  if (op == ops::find("div") && words.op(x[1]) == ops::find("sqrt") &&
      isSumWithSquare(words, ranges, words.operands(x[1])[0], x[0]))
    return {Idiom::Kind::PartOfUnitVector, x[0]};
  if (op != mult) return {};
  for (const int k : {0, 1}) {
    if (isInverseLength(words, ranges, x[1 - k], x[k]))
      return {Idiom::Kind::PartOfUnitVector, x[k]};
    if (words.op(x[k]) != mult) continue;
    const std::uint32_t t = words.operands(x[k])[0];
    if (isSquare(words, x[k], t) && isFallingLine(words, x[1 - k], t))
      return {Idiom::Kind::Smoothstep, t};
  }
  return {};
}

Interval rangeOf(Idiom::Kind kind, const Interval& x, const Interval& plain) {
  const double slack = 16 * rounding;
  if (kind == Idiom::Kind::PartOfUnitVector) return clipTo(plain, -1 - slack, 1 + slack);
  const bool rises = x.low >= 0 && x.high <= 1;
  if (kind == Idiom::Kind::Smoothstep && rises)
    return clipTo(plain, smooth(x.low) * (1 - slack), smooth(x.high) * (1 + slack));
  return plain;
}

}  // namespace warpjet
