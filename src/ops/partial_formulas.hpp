// Formulas that several partial derivatives of the table share.
#pragma once

#include "ops/scalar.hpp"

namespace warpjet::ops {

inline constexpr auto one = [](auto...) { return 1.0; };
inline constexpr auto minusOne = [](auto...) { return -1.0; };
inline constexpr auto zero = [](auto...) { return 0.0; };

// Replaces inversesqrt in derivatives that are infinite at the boundary of an operation's domain.
inline constexpr auto inversesqrtOrZero = [](auto x) {
  return ifElse(gt(x, 0.0), inversesqrt(x), 0.0);
};

// A product with a factor below `minFactor`, or a quotient by more than `maxDivisor`, is negligible
// compared to the ones of I + J. It counts as 0, since the other operand may be infinite. The range
// of float32 extends far enough beyond both limits that values within them stay finite.
inline constexpr double minFactor = 1e-25, maxDivisor = 1e30;

// Computes x d / (x² + y²), or 0 at zero. Scales x and y, since in float32 x² may overflow or
// underflow where the quotient doesn't.
inline constexpr auto angleSlope = [](auto x, auto y, auto d) {
  const auto size = max(abs(x), abs(y)), a = x / size, b = y / size;
  const auto term = ifElse(gt(size, 0.0), a / (a * a + b * b) * (d / size), 0.0);
  return maskTerm(lt(size, maxDivisor), size, maskTerm(lt(size, maxDivisor), d, term));
};

}  // namespace warpjet::ops
