// A front: a number at which a function of it is evaluated that changes within a short part of the
// number's range, and hardly elsewhere, such as the argument of a narrow exp or of a steep clamp.
#pragma once

#include <cstdint>

namespace warpjet {

enum class Profile : std::uint32_t {
  // Changes from `first` to `second` and is constant elsewhere. Both may be infinite: then the
  // profile changes up to the last value that occurs.
  Step,
  // exp(first * x).
  Exponential,
  // The power of x with the exponent `first`.
  Power,
  // atan(x), whose ends decay slowly.
  Arctangent,
};

struct Front {
  Profile profile;
  double first = 0, second = 0;

  bool operator==(const Front&) const = default;
};

}  // namespace warpjet
