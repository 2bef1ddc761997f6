// Four floats in one SIMD register, as a scalar that the rows of the table can be computed in: by
// the vector extension of GCC and Clang, which is SSE on a PC and SIMD128 in WebAssembly.
#pragma once

#include <cstddef>

#include "eval/simd.hpp"

namespace warpjet {

// Four truths: all bits of a lane are set where it is true.
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
  // The rows of the table have their constants in double.
  Lanes(double x) : Lanes(static_cast<float>(x)) {}

  float operator[](std::size_t i) const { return floats[i]; }
  void set(std::size_t i, float x) { floats[i] = x; }
};

// These, and what staged.hpp has in their place: what is generic in it runs in both.
template <class X>
concept FourLanes = requires {
  typename X::Mask;
};

inline constexpr double infinity = __builtin_inf(), notANumber = __builtin_nan("");

// The bits of one as the other.
inline Mask asMask(Lanes x) { return {simd::bitsOf(x.floats)}; }
inline Lanes asLanes(Mask x) { return simd::floatsOf(x.bits); }

inline Lanes operator+(Lanes x, Lanes y) { return x.floats + y.floats; }
inline Lanes operator-(Lanes x, Lanes y) { return x.floats - y.floats; }
inline Lanes operator*(Lanes x, Lanes y) { return x.floats * y.floats; }
inline Lanes operator/(Lanes x, Lanes y) { return x.floats / y.floats; }
inline Lanes operator-(Lanes x) { return -x.floats; }

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

// The sign bits, all others zero.
inline Mask signOf(Lanes x) { return {asMask(x).bits & simd::signBit}; }
// With its sign turned where the bit is set.
inline Lanes turned(Lanes x, Mask signs) { return asLanes({asMask(x).bits ^ signs.bits}); }

// c[0] + c[1] t + c[2] t² …
template <class Scalar, std::size_t Size>
Scalar polynomial(Scalar t, const double (&c)[Size]) {
  Scalar sum = c[Size - 1];
  for (std::size_t i = Size - 1; i-- > 0;) sum = sum * t + c[i];
  return sum;
}

}  // namespace warpjet
