#include "eval/interval_program.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace warpjet {

namespace {

// Returns the range from a number to its float32 value.
Interval withFloat(double x) {
  const double rounded = static_cast<float>(x);
  return withFloat32({std::fmin(x, rounded), std::fmax(x, rounded), x != x});
}

// The only constant that is NaN is the value of a loop that is too long for the CPU, which may be
// anything.
Interval rangeOfConstant(double x) {
  return std::isnan(x) ? Interval::anything(true) : withFloat(x);
}

}  // namespace

IntervalProgram::IntervalProgram(const Words& words, std::span<const Interval> inputs,
                                 std::size_t result)
    : words_(words), idioms_(words.count()), ranges_(words.count()), values_(words.count()) {
  findTerms(words.result(result));
  schedule(inputs);
}

// Propagates the factor of each sum and multiple to its operands, from the result down.
void IntervalProgram::findTerms(std::uint32_t root) {
  struct Factor {
    double signedSum = 0, size = 0;
  };
  std::vector<Factor> factors(root + 1);
  const auto add = [&](std::uint32_t i, const Factor& factor, double times) {
    factors[i].signedSum += factor.signedSum * times;
    factors[i].size += factor.size * std::abs(times);
  };
  factors[root] = {1, 1};
  for (std::uint32_t i = root + 1; i-- > 0;) {
    const Factor factor = factors[i];
    if (factor.size == 0) continue;
    const Op op = words_.op(i);
    const auto x = words_.operands(i);
    const auto isConstant = [&](int k) { return words_.op(x[k]) == constantOp; };
    roundings_ += 1;
    if (op == ops::find("add") || op == ops::find("sub")) {
      add(x[0], factor, 1);
      add(x[1], factor, op == ops::find("add") ? 1 : -1);
    } else if (op == ops::find("neg")) {
      add(x[0], factor, -1);
    } else if (op == ops::find("mult") && (isConstant(0) || isConstant(1))) {
      const int k = isConstant(0) ? 0 : 1;
      add(x[1 - k], factor, words_.constant(x[k]));
    } else {
      roundings_ -= 1;
      terms_.push_back({i, factor.signedSum, factor.size});
    }
  }
}

// Finds the needed instructions, computes them on the whole box, and lists those that vary.
void IntervalProgram::schedule(std::span<const Interval> inputs) {
  std::vector<bool> isNeeded(words_.count()), varies(words_.count());
  for (const Term& term : terms_) isNeeded[term.instruction] = true;
  for (std::uint32_t i = words_.count(); i-- > 0;) {
    if (!isNeeded[i]) continue;
    for (const std::uint32_t operand : words_.operands(i)) isNeeded[operand] = true;
  }
  for (std::uint32_t i = 0; i < words_.count(); ++i) {
    if (!isNeeded[i]) continue;
    if (words_.op(i) == constantOp) {
      values_[i] = words_.constant(i);
      ranges_[i] = rangeOfConstant(values_[i]);
    } else if (words_.op(i) == inputOp) {
      const Interval& input = inputs[words_.input(i)];
      values_[i] = input.low;
      ranges_[i] = input.isPoint() ? withFloat(input.low) : input;
      varies[i] = !input.isPoint() && !input.canBeInfinite();
      if (varies[i]) {
        variables_.push_back(words_.input(i));
        variableInstructions_.push_back(i);
      }
    } else {
      for (const std::uint32_t operand : words_.operands(i))
        varies[i] = varies[i] || varies[operand];
      idioms_[i] = idiomOf(words_, ranges_, i);
      ranges_[i] = rangeOf(i);
      values_[i] = valueOf(i);
      if (varies[i]) varying_.push_back(i);
    }
  }
}

Interval IntervalProgram::rangeOf(std::uint32_t i) const {
  const Op op = words_.op(i);
  const auto operands = words_.operands(i);
  if (operands.size() == 2 && operands[0] == operands[1]) {
    const Interval& x = ranges_[operands[0]];
    if (op == ops::find("mult")) return square(x);
    if (op == ops::find("sub") && !x.isEmpty()) return {0, 0, x.canBeNaN || x.canBeInfinite()};
  }
  Operands<Interval> x;
  for (std::size_t k = 0; k < operands.size(); ++k) x[k] = ranges_[operands[k]];
  const Interval range = ops::rangeOf(op, x);
  const Idiom idiom = idioms_[i];
  if (idiom.kind == Idiom::Kind::None) return range;
  return warpjet::rangeOf(idiom.kind, ranges_[idiom.operand], range);
}

Interval IntervalProgram::range(std::span<const Interval> box) {
  for (std::size_t i = 0; i < box.size(); ++i) ranges_[variableInstructions_[i]] = box[i];
  for (const std::uint32_t i : varying_) ranges_[i] = rangeOf(i);
  return total();
}

Interval IntervalProgram::total() const {
  Interval sum = 0;
  double size = 0;
  for (const Term& term : terms_) {
    const Interval& x = ranges_[term.instruction];
    if (x.isEmpty() || x.canBeInfinite()) {
      // Infinite terms don't cancel.
      sum = sum + x * term.size;
      if (term.factor != term.size) sum = sum - x * term.size;
    } else {
      sum = sum + x * term.factor;
      size += std::max(-x.low, x.high) * term.size;
    }
  }
  if (sum.isEmpty()) return sum;
  // An intermediate sum may overflow.
  if (size > std::numeric_limits<float>::max()) return Interval::anything(true);
  const double error = roundings_ * rounding * size;
  return withFloat32({sum.low - error, sum.high + error, sum.canBeNaN});
}

double IntervalProgram::valueOf(std::uint32_t i) const {
  Operands<double> operands{};
  const auto from = words_.operands(i);
  for (std::size_t k = 0; k < from.size(); ++k) operands[k] = values_[from[k]];
  return ops::valueOf(words_.op(i), operands);
}

double IntervalProgram::value(std::span<const double> point) {
  for (std::size_t i = 0; i < point.size(); ++i) values_[variableInstructions_[i]] = point[i];
  for (const std::uint32_t i : varying_) values_[i] = valueOf(i);
  double sum = 0;
  for (const Term& term : terms_) sum += term.factor * values_[term.instruction];
  return sum;
}

}  // namespace warpjet
