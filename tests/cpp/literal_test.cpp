#include "emit/literal.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <random>

namespace warpjet {
namespace {

TEST(Literal, HasAPointOrAnExponent) {
  EXPECT_EQ(literal(2), "2.0");
  EXPECT_EQ(literal(0.15), "0.15");
  EXPECT_EQ(literal(-0.00049), "-0.00049");
  EXPECT_EQ(literal(1e-5), "1e-5");
  EXPECT_EQ(literal(1e21), "1e21");
  EXPECT_EQ(literal(1e-30), "1e-30");
  EXPECT_EQ(literal(1234567), "1234567.0");
  EXPECT_EQ(literal(M_PI), "3.1415927");
  EXPECT_EQ(literal(0), "0.0");
  EXPECT_EQ(literal(-0.0), "-0.0");
}

TEST(Literal, TheLargestFloatDoesNotOverflow) {
  EXPECT_EQ(std::strtof(literal(3.4028234663852886e38).c_str(), nullptr), 3.4028234663852886e38f);
}

std::size_t digitsOf(const std::string& text) {
  std::string digits;
  for (const char c : text.substr(0, text.find('e'))) {
    if (c >= '0' && c <= '9' && !(digits.empty() && c == '0')) digits += c;
  }
  while (!digits.empty() && digits.back() == '0') digits.pop_back();
  return digits.size();
}

// Compares with the shortest digits, from the standard library. At ties, one more digit is allowed.
TEST(Literal, WritesTheFewestDigitsThatReadBackAsTheSameFloat) {
  std::mt19937 random(1);
  int longer = 0, count = 0;
  for (int i = 0; i < 60'000; ++i) {
    const auto bits = static_cast<std::uint32_t>(random());
    float value;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    ++count;
    const std::string text = literal(value);
    ASSERT_EQ(std::strtof(text.c_str(), nullptr), value) << text;
    char buffer[64];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    if (digitsOf(text) > digitsOf(std::string(buffer, end))) ++longer;
  }
  EXPECT_LT(longer, count / 200);
}

}  // namespace
}  // namespace warpjet
