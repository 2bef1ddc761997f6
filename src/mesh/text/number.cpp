#include "mesh/text/number.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace warpjet {

namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

char toLowerCase(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

double timesPowerOfTen(std::uint64_t digits, int exponent) {
  // Powers that a double represents exactly, so that there is only one rounding; enough for nearly
  // every number of a file.
  constexpr std::array<double, 23> powers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                          1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                          1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  const auto number = static_cast<double>(digits);
  if (exponent >= 0 && exponent <= 22) return number * powers[exponent];
  if (exponent < 0 && exponent >= -22) return number / powers[-exponent];
  // In two steps, since the smallest doubles would underflow in between.
  const int half = exponent / 2;
  return number * std::pow(10.0, half) * std::pow(10.0, exponent - half);
}

}  // namespace

std::optional<float> parseFloat(std::string_view text) {
  std::size_t i = 0;
  const bool isNegative = text.starts_with('-');
  if (isNegative || text.starts_with('+')) ++i;

  constexpr std::uint64_t maxDigits = std::uint64_t{1000000000000000000};
  std::uint64_t digits = 0;
  int exponent = 0;
  bool hasDigits = false, isFraction = false;
  for (; i < text.size() && (isDigit(text[i]) || (text[i] == '.' && !isFraction)); ++i) {
    if (text[i] == '.') {
      isFraction = true;
      continue;
    }
    hasDigits = true;
    const bool fits = digits < maxDigits;
    if (fits) digits = digits * 10 + static_cast<std::uint64_t>(text[i] - '0');
    exponent += (fits ? 0 : 1) - (isFraction ? 1 : 0);
  }
  if (!hasDigits) return std::nullopt;

  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    const char* first = text.data() + i + 1;
    const char* const last = text.data() + text.size();
    if (first != last && *first == '+') ++first;
    int written = 0;
    const auto [end, error] = std::from_chars(first, last, written);
    if (error != std::errc() || end != last) return std::nullopt;
    exponent += std::clamp(written, -100000, 100000);
  } else if (i != text.size()) {
    return std::nullopt;
  }
  if (digits == 0) return isNegative ? -0.0f : 0.0f;  // not 0 times infinity
  const double value = timesPowerOfTen(digits, exponent);
  return static_cast<float>(isNegative ? -value : value);
}

bool isPrintedNonNumber(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  // The spellings of Microsoft's C library: 1.#IND, 1.#QNAN, 1.#SNAN0, 1.#INF00.
  if (text.starts_with("1.#")) return true;
  for (const std::string_view name : {"nan", "inf", "infinity"}) {
    const std::string_view rest = text.substr(std::min(name.size(), text.size()));
    if (std::equal(name.begin(), name.end(), text.begin(),
                   text.end() - static_cast<std::ptrdiff_t>(rest.size()),
                   [](char a, char b) { return a == toLowerCase(b); }) &&
        (rest.empty() || rest.starts_with('(')))
      return true;
  }
  return false;
}

}  // namespace warpjet
