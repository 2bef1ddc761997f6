// Signs, whole numbers and choices, for four floats at a time: as ops/scalar.hpp has them, with the
// same zeros and the same NaNs.
#pragma once

#include "eval/lanes.hpp"
#include "ops/scalar.hpp"

namespace warpjet {

inline Lanes abs(Lanes x) { return turned(x, signOf(x)); }
inline Lanes sign(Lanes x) { return ifElse(gt(x, 0.0), 1.0, 0.0) - ifElse(lt(x, 0.0), 1.0, 0.0); }
inline Lanes floor(Lanes x) { return simd::floor(x.floats); }
inline Lanes ceil(Lanes x) { return simd::ceil(x.floats); }
// A half goes to the even neighbour.
inline Lanes round(Lanes x) { return simd::nearest(x.floats); }
inline Lanes trunc(Lanes x) { return simd::trunc(x.floats); }
inline Lanes fract(Lanes x) { return x - floor(x); }
inline Lanes mod(Lanes x, Lanes y) { return x - y * floor(x / y); }

inline Lanes step(Lanes edge, Lanes x) { return ifElse(lt(x, edge), 0.0, 1.0); }
inline Lanes mix(Lanes x, Lanes y, Lanes t) { return x * (1.0 - t) + y * t; }
inline Lanes min(Lanes x, Lanes y) { return ifElse(lt(y, x), y, x); }
inline Lanes max(Lanes x, Lanes y) { return ifElse(lt(x, y), y, x); }

inline Lanes hash(Lanes h, Lanes i) { return ops::hashOf(h, i); }

inline Lanes sqrt(Lanes x) { return simd::sqrt(x.floats); }
inline Lanes inversesqrt(Lanes x) { return 1.0 / sqrt(x); }

}  // namespace warpjet
