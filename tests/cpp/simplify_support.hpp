// Shared by the tests of graph/simplify.hpp.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

namespace warpjet {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Returns true if two numbers are the same. All NaN are; zeros of different sign are not.
inline bool same(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return a == b && std::signbit(a) == std::signbit(b);
}

// Returns how many doubles apart two numbers are.
inline std::uint64_t distance(double a, double b) {
  const auto rank = [](double x) {
    std::int64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
  };
  if (std::isnan(a) || std::isnan(b)) return ~std::uint64_t{0};
  const std::int64_t low = std::min(rank(a), rank(b)), high = std::max(rank(a), rank(b));
  return static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
}

// Draws random numbers, which are the same on all machines, unlike those of the standard library's
// distributions.
class Chance {
 public:
  std::size_t below(std::size_t end) { return random_() % end; }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
  }

 private:
  std::mt19937 random_{1};
};

}  // namespace warpjet
