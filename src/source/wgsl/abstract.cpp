#include "source/wgsl/abstract.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "source/fold.hpp"

namespace warpjet::source::wgsl {

namespace {

std::int64_t whole(double x) { return static_cast<std::int64_t>(x); }
double number(std::int64_t x) { return static_cast<double>(x); }

double powerOfTwo(double exponent) {
  return static_cast<double>(std::uint64_t{1} << static_cast<int>(exponent));
}

std::optional<double> foldOne(Operator op, double x, double y, bool isWhole) {
  using enum Operator;
  switch (op) {
    case Add:
      return x + y;
    case Subtract:
      return x - y;
    case Multiply:
      return x * y;
    case Divide:
      if (y == 0) return std::nullopt;
      return isWhole ? std::trunc(x / y) : x / y;
    case Remainder:
      if (y == 0) return std::nullopt;
      return std::fmod(x, y);
    case BitAnd:
      return number(whole(x) & whole(y));
    case BitOr:
      return number(whole(x) | whole(y));
    case BitXor:
      return number(whole(x) ^ whole(y));
    case ShiftLeft:
      return y < 0 || y > 63 ? std::nullopt : std::optional(x * powerOfTwo(y));
    case ShiftRight:
      return y < 0 || y > 63 ? std::nullopt : std::optional(std::floor(x / powerOfTwo(y)));
    case Less:
      return x < y;
    case Greater:
      return x > y;
    case AtMost:
      return x <= y;
    case AtLeast:
      return x >= y;
    case Equal:
      return x == y;
    case Unequal:
      return x != y;
    default:
      return std::nullopt;
  }
}

std::optional<double> foldInteger(Way way, const std::array<double, 3>& x) {
  using enum Way;
  switch (way) {
    case AbsInt:
      return std::abs(x[0]);
    case SignInt:
      return x[0] > 0 ? 1 : x[0] < 0 ? -1 : 0;
    case MinInt:
      return std::min(x[0], x[1]);
    case MaxInt:
      return std::max(x[0], x[1]);
    case ClampInt:
      return std::min(std::max(x[0], x[1]), x[2]);
    default:
      return std::nullopt;
  }
}

double componentOf(const std::vector<double>& numbers, std::size_t i) {
  return numbers[numbers.size() == 1 ? 0 : i];
}

}  // namespace

std::optional<std::vector<double>> foldAbstract(Operator op, const Operand& left,
                                                const Operand& right, Type type) {
  // Computes component by component. Products of matrices don't get here: they are computed with
  // numbers of a concrete type.
  std::vector<double> numbers;
  for (int i = 0; i < type.components(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const auto made = foldOne(op, componentOf(left.known, k), componentOf(right.known, k),
                              left.type.base == Base::Int);
    if (!made) return std::nullopt;
    numbers.push_back(*made);
  }
  return numbers;
}

std::optional<std::vector<double>> foldAbstract(const BuiltIn& row,
                                                const std::vector<Operand>& operands, Type type) {
  std::vector<double> numbers;
  for (int i = 0; i < type.components(); ++i) {
    std::array<double, 3> x{};
    if (operands.size() > x.size()) return std::nullopt;
    for (std::size_t k = 0; k < operands.size(); ++k)
      x[k] = componentOf(operands[k].known, static_cast<std::size_t>(i));
    const auto made = row.way == Way::Each ? foldFunction(row.code, {x.data(), operands.size()})
                                           : foldInteger(row.way, x);
    if (!made) return std::nullopt;
    numbers.push_back(*made);
  }
  return numbers;
}

}  // namespace warpjet::source::wgsl
