// Signs, rounding and choices for four floats at a time. They agree with ops/scalar.hpp, including
// signed zeros and NaN.
#pragma once

#include "eval/lanes.hpp"
#include "ops/scalar.hpp"

namespace warpjet {

inline Lanes abs(Lanes x) { return flipSign(x, signOf(x)); }
inline Lanes floor(Lanes x) { return simd::floor(x.floats); }
inline Lanes ceil(Lanes x) { return simd::ceil(x.floats); }
// Rounds half to even.
inline Lanes round(Lanes x) { return simd::nearest(x.floats); }
inline Lanes trunc(Lanes x) { return simd::trunc(x.floats); }
inline Lanes sqrt(Lanes x) { return simd::sqrt(x.floats); }

inline Lanes min(Lanes x, Lanes y) { return ifElse(lt(y, x), y, x); }
inline Lanes max(Lanes x, Lanes y) { return ifElse(lt(x, y), y, x); }

inline Lanes hash(Lanes h, Lanes i) { return ops::hashOf(h, i); }

template <FourLanes X>
X sign(X x) {
  return ifElse(gt(x, 0.0), X(1.0), X(0.0)) - ifElse(lt(x, 0.0), X(1.0), X(0.0));
}
template <FourLanes X>
X fract(X x) {
  return x - floor(x);
}
template <FourLanes X>
X mod(X x, X y) {
  return x - y * floor(x / y);
}
template <FourLanes X>
X step(X edge, X x) {
  return ifElse(lt(x, edge), X(0.0), X(1.0));
}
template <FourLanes X>
X mix(X x, X y, X t) {
  return x * (1.0 - t) + y * t;
}
template <FourLanes X>
X inversesqrt(X x) {
  return 1.0 / sqrt(x);
}

}  // namespace warpjet
