// The scale on which a front is measured.
#pragma once

#include "detail/quadratic_range.hpp"
#include "eval/front.hpp"

namespace warpjet {

// Maps the number of a front monotonically to a scale, on which it may change by 1 within a
// triangle: such a part of the profile shows at the samples. Where the profile hardly changes, the
// scale doesn't either.
class FrontScale {
 public:
  // The range of the number on the mesh, as estimated, and at its samples only. A peak or the end
  // of a step is relative to the largest value on the mesh.
  FrontScale(const Front& front, const ValueRange& estimated, const ValueRange& sampled);

  double changeWithin(const ValueRange& range) const {
    return std::abs(at(range.high) - at(range.low));
  }

 private:
  double at(double number) const;

  Profile profile_;
  double first_;
  double second_ = 0;
  double closeness_ = 0;  // numbers that differ by less are equal
  bool isUsed_ = true;
};

}  // namespace warpjet
