// All identities, one per row: the pattern to replace, its replacement, how closely the
// replacement keeps the value, and a condition.
//
// x, y, z, t and c stand for any node; v for anything but a constant; a, b and n for constants.
// Parts computed from constants alone become constants, in replacements and in conditions. A sum or
// product matches in either order, unless both orders have a row; its constant comes last. If
// several rows match, the first one wins.
//
// Why some rows do not keep every bit of the value:
//   ifNumber: x * 0 is NaN for an infinite x, so every structural zero of a Jacobian would remain;
//   and so would x - x in the derivative of moved - position. value: shaders don't guarantee the
//   sign of a zero. rounding: the replacement has fewer operations and is closer to the exact
//   result, as for a chain of constant factors, or for an offset that rotates about a point, which
//   subtracts the point and adds it again. An intermediate result may overflow or underflow in only
//   one of the two.
//
// Identities are defined only here. tests/cpp/identities_test.cpp loops over the table and checks
// that each row keeps what it claims and that no two rows replace each other forever. `npm run
// reference` prints the table.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "graph/pattern.hpp"

namespace warpjet::patterns {

inline constexpr Pattern x{Kind::Anything, 'x'}, y{Kind::Anything, 'y'}, z{Kind::Anything, 'z'},
    t{Kind::Anything, 't'}, c{Kind::Anything, 'c'}, v{Kind::Computed, 'v'}, a{Kind::Constant, 'a'},
    b{Kind::Constant, 'b'}, n{Kind::Constant, 'n'};

namespace detail {

// Returns 1 for a float32 that is neither zero, subnormal nor infinite, otherwise 0.
inline double isNormal(double number) {
  using Limits = std::numeric_limits<float>;
  return std::abs(number) >= Limits::min() && std::abs(number) <= Limits::max();
}

inline double isNormalOrZero(double number) { return number == 0 || isNormal(number) != 0; }

// Returns 1 for the integer exponents that are expanded to products, since GLSL's pow is undefined
// for a negative base; otherwise 0.
inline double isExponent(double number) {
  return number == std::floor(number) && number >= 1 && number <= 16;
}

// Returns the greatest power of two that doesn't exceed the exponent.
inline double powerOfTwo(double exponent) {
  return exponent < 2 ? 1 : exponent < 4 ? 2 : exponent < 8 ? 4 : exponent < 16 ? 8 : 16;
}

inline double isPowerOfTwo(double number) {
  return number > 1 && isExponent(number) != 0 && powerOfTwo(number) == number;
}

}  // namespace detail

inline constexpr Function isNormal{"isNormal", detail::isNormal},
    isNormalOrZero{"isNormalOrZero", detail::isNormalOrZero},
    isExponent{"isExponent", detail::isExponent}, powerOfTwo{"powerOfTwo", detail::powerOfTwo},
    isPowerOfTwo{"isPowerOfTwo", detail::isPowerOfTwo};

// clang-format off
inline constexpr std::array identities{
    // negation
    Identity{-(-x), x, bits},
    Identity{!!c, c, bits},

    // sums
    Identity{x + 0, x, value},
    Identity{x + -y, x - y, bits},
    Identity{(x + a) + b, x + (a + b), rounding, isNormalOrZero(a + b)},
    Identity{(x - a) + b, x + (b - a), rounding, isNormalOrZero(b - a)},
    Identity{x + a, x - -a, bits, a < 0},
    Identity{x + x, x * 2, bits},

    // differences
    Identity{x - 0, x, value},
    Identity{0 - x, -x, value},
    Identity{x - x, 0, ifNumber(bits)},
    Identity{x - -y, x + y, bits},
    Identity{(x + a) - b, x + (a - b), rounding, isNormalOrZero(a - b)},
    Identity{(x - a) - b, x + (-a - b), rounding, isNormalOrZero(-a - b)},
    Identity{x - a, x + -a, bits, a < 0},

    // products; those with a conditional come first, so that no other row multiplies the infinity of the branch not taken by 0
    Identity{x * 0, 0, ifNumber(value)},
    Identity{x * 1, x, bits},
    Identity{x * -1, -x, bits},
    Identity{x * ifElse(c, 1, 0), ifElse(c, x, 0), ifNumber(value)},
    Identity{x * ifElse(c, 0, 1), ifElse(c, 0, x), ifNumber(value)},
    Identity{-x * a, x * -a, bits},
    Identity{-x * y, -(x * y), bits},
    Identity{x * -y, -(x * y), bits},
    Identity{(x * a) * b, x * (a * b), rounding, isNormal(a * b)},
    Identity{x * (1 / y), x / y, rounding},

    // quotients
    Identity{x / 1, x, bits},
    Identity{x / -1, -x, bits},
    Identity{0 / v, 0, ifNumber(value)},
    Identity{-x / y, -(x / y), bits},
    Identity{x / -y, -(x / y), bits},
    Identity{x / sqrt(x), sqrt(x), ifNumber(rounding)},

    // powers, by repeated squaring
    Identity{pow(x, 0), 1, bits},
    Identity{pow(x, 1), x, bits},
    Identity{pow(x, n), pow(x, n / 2) * pow(x, n / 2), rounding, isPowerOfTwo(n)},
    Identity{pow(x, n), pow(x, n - powerOfTwo(n)) * pow(x, powerOfTwo(n)), rounding, isExponent(n)},
    Identity{pow(x, n), 1 / pow(x, -n), rounding, isExponent(-n)},

    // conditionals
    Identity{ifElse(c, x, x), x, bits},
    Identity{ifElse(true, x, y), x, bits},
    Identity{ifElse(false, x, y), y, bits},
    Identity{ifElse(!c, x, y), ifElse(c, y, x), bits},
    Identity{ifElse(c, x, 0) + ifElse(c, 0, y), ifElse(c, x, y), value},
    Identity{ifElse(c, x, 0) + ifElse(c, y, 0), ifElse(c, x + y, 0), value},
    Identity{ifElse(c, 0, x) + ifElse(c, 0, y), ifElse(c, 0, x + y), value},
    Identity{intIfElse(c, x, x), x, bits},
    Identity{intIfElse(true, x, y), x, bits},
    Identity{intIfElse(false, x, y), y, bits},
    Identity{intIfElse(!c, x, y), intIfElse(c, y, x), bits},

    // bounds; languages leave clamp undefined if low > high, and WGSL rejects constants of that kind
    Identity{clamp(x, a, b), b, ifNumber(bits), a > b},
    Identity{clamp(x, v, y), min(max(x, v), y), bits},
    Identity{clamp(x, y, v), min(max(x, y), v), bits},

    // blends
    Identity{mix(x, y, 0), x, ifNumber(value)},
    Identity{mix(x, y, 1), y, ifNumber(value)},
    Identity{mix(0, y, t), y * t, ifNumber(value)},
    Identity{mix(x, 0, t), x * (1 - t), ifNumber(rounding)},
};
// clang-format on

}  // namespace warpjet::patterns
