// Four floats in one SIMD register, as a scalar type in which the rows of the table can be
// evaluated: the vector extension of GCC and Clang, which is SSE on a PC and SIMD128 in
// WebAssembly.
#pragma once

#include <cstddef>

#include "eval/simd.hpp"

namespace warpjet {

// Four booleans: all bits of a lane are set if it is true.
struct Mask {
  using Bits = simd::FloatBits;

  Bits bits;
};

struct Lanes {
  using Floats = simd::Floats;
  using Mask = warpjet::Mask;
  static constexpr std::size_t count = 4;

  Floats floats;

  Lanes() = default;
  Lanes(Floats all) : floats(all) {}
  Lanes(float x) : floats{x, x, x, x} {}
  // Constants in the rows of the table are doubles.
  Lanes(double x) : Lanes(static_cast<float>(x)) {}

  float operator[](std::size_t i) const { return floats[i]; }
  void set(std::size_t i, float x) { floats[i] = x; }
};

// Lanes, or their counterpart in staged.hpp: generic code runs in both.
template <class X>
concept FourLanes = requires {
  typename X::Mask;
};

inline constexpr double infinity = __builtin_inf(), notANumber = __builtin_nan("");

// Reinterprets the bits.
inline Mask asMask(Lanes x) { return {simd::bitsOf(x.floats)}; }
inline Lanes asLanes(Mask x) { return simd::floatsOf(x.bits); }

inline Lanes operator+(Lanes x, Lanes y) { return x.floats + y.floats; }
inline Lanes operator-(Lanes x, Lanes y) { return x.floats - y.floats; }
inline Lanes operator*(Lanes x, Lanes y) { return x.floats * y.floats; }
inline Lanes operator/(Lanes x, Lanes y) { return x.floats / y.floats; }
inline Lanes operator-(Lanes x) { return -x.floats; }
// The compound operators are for vectors of glm.
inline Lanes& operator+=(Lanes& x, Lanes y) { return x = x + y; }
inline Lanes& operator-=(Lanes& x, Lanes y) { return x = x - y; }
inline Lanes& operator*=(Lanes& x, Lanes y) { return x = x * y; }
inline Lanes& operator/=(Lanes& x, Lanes y) { return x = x / y; }

inline Mask lt(Lanes x, Lanes y) { return {x.floats < y.floats}; }
inline Mask le(Lanes x, Lanes y) { return {x.floats <= y.floats}; }
inline Mask gt(Lanes x, Lanes y) { return {x.floats > y.floats}; }
inline Mask ge(Lanes x, Lanes y) { return {x.floats >= y.floats}; }
inline Mask eq(Lanes x, Lanes y) { return {x.floats == y.floats}; }
inline Mask ne(Lanes x, Lanes y) { return {x.floats != y.floats}; }

inline Mask logicalAnd(Mask x, Mask y) { return {x.bits & y.bits}; }
inline Mask logicalOr(Mask x, Mask y) { return {x.bits | y.bits}; }
inline Mask logicalNot(Mask x) { return {~x.bits}; }

inline bool any(Mask x) { return simd::any(x.bits); }

inline Lanes ifElse(Mask condition, Lanes yes, Lanes no) {
  return simd::select(condition.bits, yes.floats, no.floats);
}

// Returns the sign bits; all other bits are zero.
inline Mask signOf(Lanes x) { return {asMask(x).bits & simd::signBit}; }
// Flips the sign where the bit is set.
inline Lanes flipSign(Lanes x, Mask signs) { return asLanes({asMask(x).bits ^ signs.bits}); }

// Returns c[0] + c[1] t + c[2] t² …
template <class Scalar, std::size_t Size>
Scalar polynomial(Scalar t, const double (&c)[Size]) {
  Scalar sum = c[Size - 1];
  for (std::size_t i = Size - 1; i-- > 0;) sum = sum * t + c[i];
  return sum;
}

}  // namespace warpjet
