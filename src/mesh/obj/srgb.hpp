// Converts the colors of OBJ and MTL files, which are sRGB, to linear ones.
#pragma once

#include <cmath>

namespace warpjet {

// Converts one channel by the formula of IEC 61966-2-1.
inline float linearOf(float srgb) {
  return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

}  // namespace warpjet
