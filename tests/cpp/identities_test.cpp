// The table of identities, row by row: each row is as exact as it claims to be.
#include "graph/identities.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "graph/pattern_text.hpp"
#include "graph/rotations.hpp"
#include "identity_support.hpp"

namespace warpjet::patterns {
namespace {

constexpr std::array wrongIdentities{
    Identity{x - -y, x - y, bits},            // wrong operation
    Identity{x - y, y - x, rounding},         // wrong order
    Identity{x + 0, x, bits},                 // -0 + 0 is 0
    Identity{x * 0, 0, value},                // infinity * 0 is NaN
    Identity{x * (1 / y), x / y, value},      // rounded differently
    Identity{x + a, x - a, rounding, a < 0},  // without the minus in x - -a
    Identity{clamp(x, a, b), b, value},       // without its condition
    Identity{ifElse(!c, x, y), ifElse(c, x, y), bits},
    Identity{intIfElse(c, x, y), x, bits},
    Identity{pow(x, n), pow(x, n / 2), rounding, isPowerOfTwo(n)},
    Identity{x / sqrt(x), sqrt(x), rounding},  // 0 / 0 is NaN
};

constexpr Identity wrongRotation{k * (x * cos(u)) * cos(u) + k * (x * sin(u)) * cos(u), x* k,
                                 rounding};

}  // namespace
}  // namespace warpjet::patterns

namespace warpjet::identities {
namespace {

bool isSameNumber(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool isSame(double a, double b) {
  return isSameNumber(a, b) && (std::isnan(a) || std::signbit(a) == std::signbit(b));
}

enum class Verdict { Preserved, Violated, Exempt };

// Checks whether an identity is as exact as it claims for these values of its variables.
Verdict judge(const Identity& identity, const At& at, Arithmetic round) {
  const Evaluation before(identity.from, at, round), after(identity.to, at, round);
  const auto [precision, onlyNumbers] = identity.keeps;
  if (onlyNumbers && std::isnan(before.value)) return Verdict::Exempt;
  if (isSame(before.value, after.value)) return Verdict::Preserved;
  if (precision == Precision::Bits) return Verdict::Violated;
  if (isSameNumber(before.value, after.value)) return Verdict::Preserved;
  if (precision == Precision::Value) return Verdict::Violated;
  if (before.leavesRange || after.leavesRange) return Verdict::Exempt;
  const double error = std::abs(before.value - after.value);
  const double bound = 4 * round.epsilon() * std::max(before.largest, after.largest);
  return error <= bound ? Verdict::Preserved : Verdict::Violated;
}

std::string describe(const Identity& identity, const At& at) {
  std::string all = text(identity) + ", where";
  const Variables variables(identity.from);
  for (std::size_t i = 0; i < letters; ++i) {
    std::array<char, 32> number{};
    std::snprintf(number.data(), number.size(), "%.9g", at[i]);
    if (variables.kinds[i]) all += std::string(" ") + char('a' + i) + " = " + number.data();
  }
  return all;
}

// Judges each identity at many points; returns the first failure, or an empty string.
std::string findViolation(std::span<const Identity> table, int points) {
  Chance chance;
  for (const Identity& identity : table) {
    for (const bool isFloat32 : {false, true}) {
      int preserved = 0;
      for (int i = 0; i < points; ++i) {
        const auto at = drawPoint(identity, chance, {isFloat32});
        if (!at) continue;
        const Verdict verdict = judge(identity, *at, {isFloat32});
        if (verdict == Verdict::Violated) return describe(identity, *at);
        preserved += verdict == Verdict::Preserved;
      }
      if (preserved < points / 40)
        return text(identity) + " has too few points at which it can be checked";
    }
  }
  return {};
}

TEST(Identities, PreserveWhatTheyClaim) {
  EXPECT_EQ(findViolation(patterns::identities, 4000), "");
}

// With badly chosen samples, some of the wrong identities would pass.
TEST(Identities, TheJudgeRejectsWrongIdentities) {
  for (const Identity& wrong : patterns::wrongIdentities)
    EXPECT_NE(findViolation({&wrong, 1}, 4000), "") << text(wrong);
}

// Checks x cos² u + x sin² u and the like, to within a few roundings of the largest product.
TEST(Identities, RotationIdentitiesPreserveTheValue) {
  Chance chance;
  for (const Identity& identity : patterns::turns) {
    for (int i = 0; i < 4000; ++i) {
      At at{};
      for (double& each : at) each = chance.between(-100, 100);
      EXPECT_EQ(judge(identity, at, {false}), Verdict::Preserved) << describe(identity, at);
      if (HasFailure()) return;
    }
  }
  At at{};
  at.fill(0.5);
  EXPECT_EQ(judge(patterns::wrongRotation, at, {false}), Verdict::Violated);
}

}  // namespace
}  // namespace warpjet::identities
