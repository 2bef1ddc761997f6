// A front: a number at which a function of it is evaluated that changes within a short part of the
// number's range, and hardly elsewhere, such as the argument of a narrow exp or of a steep clamp.
// Also a kink: a number at which the slope of a function jumps.
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
  // A function whose slope jumps at `first`, as that of abs does at 0. `second` is 1 if the number
  // depends on nothing but the vertex, so that the kink stays where it is on the mesh.
  Kink,
  // A function whose domain ends at `first` with an infinite slope, as that of sqrt does. `second`
  // is as for a kink.
  Cusp,
};

struct Front {
  Profile profile;
  double first = 0, second = 0;

  bool isKink() const { return profile == Profile::Kink || profile == Profile::Cusp; }
  bool isStill() const { return isKink() && second == 1; }
  bool operator==(const Front&) const = default;
};

}  // namespace warpjet
