// The few operations on registers of four floats or two doubles that differ between instruction
// sets: WebAssembly's SIMD128, SSE2, and plain code for all others. lanes.hpp has arithmetic,
// comparisons and bitwise operations, which use the vector extension of GCC and Clang and are the
// same everywhere.
#pragma once

#include <cmath>
#include <cstdint>

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace warpjet::simd {

using Floats = float __attribute__((vector_size(16)));
using FloatBits = std::int32_t __attribute__((vector_size(16)));
using Doubles = double __attribute__((vector_size(16)));
using DoubleBits = std::int64_t __attribute__((vector_size(16)));

inline FloatBits bitsOf(Floats x) { return __builtin_bit_cast(FloatBits, x); }
inline Floats floatsOf(FloatBits x) { return __builtin_bit_cast(Floats, x); }
inline DoubleBits bitsOf(Doubles x) { return __builtin_bit_cast(DoubleBits, x); }
inline Doubles doublesOf(DoubleBits x) { return __builtin_bit_cast(Doubles, x); }

inline constexpr std::int32_t signBit = INT32_MIN;

#if defined(__wasm_simd128__)

inline Floats select(FloatBits where, Floats yes, Floats no) {
  return __builtin_bit_cast(
      Floats, wasm_v128_bitselect(__builtin_bit_cast(v128_t, yes), __builtin_bit_cast(v128_t, no),
                                  __builtin_bit_cast(v128_t, where)));
}
inline Doubles select(DoubleBits where, Doubles yes, Doubles no) {
  return __builtin_bit_cast(
      Doubles, wasm_v128_bitselect(__builtin_bit_cast(v128_t, yes), __builtin_bit_cast(v128_t, no),
                                   __builtin_bit_cast(v128_t, where)));
}
inline bool any(FloatBits x) { return wasm_v128_any_true(__builtin_bit_cast(v128_t, x)); }

inline Floats floor(Floats x) {
  return __builtin_bit_cast(Floats, wasm_f32x4_floor(__builtin_bit_cast(v128_t, x)));
}
inline Floats ceil(Floats x) {
  return __builtin_bit_cast(Floats, wasm_f32x4_ceil(__builtin_bit_cast(v128_t, x)));
}
inline Floats trunc(Floats x) {
  return __builtin_bit_cast(Floats, wasm_f32x4_trunc(__builtin_bit_cast(v128_t, x)));
}
inline Floats nearest(Floats x) {
  return __builtin_bit_cast(Floats, wasm_f32x4_nearest(__builtin_bit_cast(v128_t, x)));
}
inline Floats sqrt(Floats x) {
  return __builtin_bit_cast(Floats, wasm_f32x4_sqrt(__builtin_bit_cast(v128_t, x)));
}
inline Doubles sqrt(Doubles x) {
  return __builtin_bit_cast(Doubles, wasm_f64x2_sqrt(__builtin_bit_cast(v128_t, x)));
}

// Converts the first two or the last two of four floats to doubles, and back.
inline Doubles widenLow(Floats x) {
  return __builtin_bit_cast(Doubles, wasm_f64x2_promote_low_f32x4(__builtin_bit_cast(v128_t, x)));
}
inline Doubles widenHigh(Floats x) { return widenLow(__builtin_shufflevector(x, x, 2, 3, 2, 3)); }
inline Floats narrow(Doubles low, Doubles high) {
  const auto first = wasm_f32x4_demote_f64x2_zero(__builtin_bit_cast(v128_t, low));
  const auto last = wasm_f32x4_demote_f64x2_zero(__builtin_bit_cast(v128_t, high));
  return __builtin_bit_cast(Floats, wasm_i64x2_shuffle(first, last, 0, 2));
}

#else

inline Floats select(FloatBits where, Floats yes, Floats no) {
  return floatsOf((where & bitsOf(yes)) | (~where & bitsOf(no)));
}
inline Doubles select(DoubleBits where, Doubles yes, Doubles no) {
  return doublesOf((where & bitsOf(yes)) | (~where & bitsOf(no)));
}

// Rounds half to even. Every float from 2^23 up is an integer; adding 2^23 to a smaller one rounds
// its fraction away.
inline Floats nearest(Floats x) {
  const Floats big = {0x1p23f, 0x1p23f, 0x1p23f, 0x1p23f};
  const FloatBits sign = bitsOf(x) & signBit;
  const Floats magnitude = floatsOf(bitsOf(x) ^ sign);
  const Floats whole = floatsOf(bitsOf((magnitude + big) - big) | sign);
  return select(magnitude < big, whole, x);
}
inline Floats floor(Floats x) {
  const Floats one = {1, 1, 1, 1}, whole = nearest(x);
  return whole - floatsOf(bitsOf(one) & (whole > x));
}
inline Floats ceil(Floats x) { return -floor(-x); }
inline Floats trunc(Floats x) {
  const FloatBits sign = bitsOf(x) & signBit;
  return floatsOf(bitsOf(floor(floatsOf(bitsOf(x) ^ sign))) | sign);
}

#if defined(__SSE2__)

inline bool any(FloatBits x) { return _mm_movemask_ps(__builtin_bit_cast(__m128, x)) != 0; }

inline Floats sqrt(Floats x) {
  return __builtin_bit_cast(Floats, _mm_sqrt_ps(__builtin_bit_cast(__m128, x)));
}
inline Doubles sqrt(Doubles x) {
  return __builtin_bit_cast(Doubles, _mm_sqrt_pd(__builtin_bit_cast(__m128d, x)));
}

inline Doubles widenLow(Floats x) {
  return __builtin_bit_cast(Doubles, _mm_cvtps_pd(__builtin_bit_cast(__m128, x)));
}
inline Doubles widenHigh(Floats x) {
  const auto floats = __builtin_bit_cast(__m128, x);
  return __builtin_bit_cast(Doubles, _mm_cvtps_pd(_mm_movehl_ps(floats, floats)));
}
inline Floats narrow(Doubles low, Doubles high) {
  return __builtin_bit_cast(Floats, _mm_movelh_ps(_mm_cvtpd_ps(__builtin_bit_cast(__m128d, low)),
                                                  _mm_cvtpd_ps(__builtin_bit_cast(__m128d, high))));
}

#else

inline bool any(FloatBits x) { return (x[0] | x[1] | x[2] | x[3]) != 0; }

inline Floats sqrt(Floats x) {
  const Floats roots = {std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
  return roots;
}
inline Doubles sqrt(Doubles x) {
  const Doubles roots = {std::sqrt(x[0]), std::sqrt(x[1])};
  return roots;
}

inline Doubles widenLow(Floats x) {
  const Doubles first = {static_cast<double>(x[0]), static_cast<double>(x[1])};
  return first;
}
inline Doubles widenHigh(Floats x) {
  const Doubles last = {static_cast<double>(x[2]), static_cast<double>(x[3])};
  return last;
}
inline Floats narrow(Doubles low, Doubles high) {
  const Floats all = {static_cast<float>(low[0]), static_cast<float>(low[1]),
                      static_cast<float>(high[0]), static_cast<float>(high[1])};
  return all;
}

#endif
#endif

}  // namespace warpjet::simd
