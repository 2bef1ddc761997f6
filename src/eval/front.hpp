// A front: the argument of a function that changes within a short part of the argument's range and
// hardly elsewhere, such as a narrow exp or a steep clamp. Also a crease: the argument of a
// function whose slope jumps (a kink) or is infinite (a cusp).
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

  bool isKink() const { return profile == Profile::Kink; }
  bool isCrease() const { return isKink() || profile == Profile::Cusp; }
  bool isStill() const { return isCrease() && second == 1; }
  bool operator==(const Front&) const = default;
};

}  // namespace warpjet
