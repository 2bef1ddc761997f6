#include "emit/literal.hpp"

#include <array>
#include <cmath>

namespace warpjet {

namespace {

// A decimal: digits * 10^exponent.
struct Decimal {
  long long digits;
  int exponent;
};

// Nine digits distinguish all float32 values, but the largest one rounded to nine digits would be
// out of range.
constexpr int maxDigits = 10;

// 10^0 to 10^63; the smallest float32, 1e-45, with ten digits needs 10^54.
constexpr auto powersOfTen = [] {
  std::array<double, 64> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = powers[i - 1] * 10;
  return powers;
}();

double scaleByPowerOfTen(double x, int exponent) {
  return exponent < 0 ? x / powersOfTen[-exponent] : x * powersOfTen[exponent];
}

// Returns the shortest decimal that a compiler reads back as the positive `value`: its error must
// be less than half the gap between `value` and the neighboring float32 on the side of the error.
// We require 1e-5 (`margin`) less than that, because these computations in double have errors, too:
// 1e-14 of the value, while half a gap is at least 1e-8 of it. If only the margin excludes a
// decimal, one more digit is written.
Decimal findShortest(float value) {
  constexpr double margin = 1e-5;
  const double exact = value;
  const double below = (exact - double{std::nextafter(value, 0.0f)}) / 2 * (1 - margin);
  const double next = std::nextafter(value, HUGE_VALF);
  const double above = std::isinf(next) ? 0 : (next - exact) / 2 * (1 - margin);
  const int magnitude = static_cast<int>(std::floor(std::log10(value)));

  Decimal decimal{};
  // Shorter decimals are found at six digits, too: `literal` drops trailing zeros.
  for (int digits = 6; digits <= maxDigits; ++digits) {
    decimal.exponent = magnitude - digits + 1;
    decimal.digits = std::llround(scaleByPowerOfTen(exact, -decimal.exponent));
    const double read = scaleByPowerOfTen(static_cast<double>(decimal.digits), decimal.exponent);
    if (read > exact - below && read < exact + above) break;
  }
  return decimal;
}

}  // namespace

std::string literal(double value) {
  const auto rounded = static_cast<float>(value);
  const std::string sign = std::signbit(rounded) ? "-" : "";
  if (rounded == 0) return sign + "0.0";

  const Decimal decimal = findShortest(std::abs(rounded));
  std::string digits = std::to_string(decimal.digits);
  const int magnitude = static_cast<int>(digits.size()) - 1 + decimal.exponent;
  while (digits.size() > 1 && digits.back() == '0') digits.pop_back();

  if (magnitude < -4 || magnitude > 6) {
    if (digits.size() > 1) digits.insert(1, ".");
    return sign + digits + 'e' + std::to_string(magnitude);
  }
  if (magnitude < 0) return sign + "0." + std::string(-magnitude - 1, '0') + digits;
  const std::size_t point = magnitude + 1;
  if (digits.size() <= point) digits.append(point + 1 - digits.size(), '0');
  return sign + digits.insert(point, ".");
}

}  // namespace warpjet
