// Numbers the partial derivatives of a function. Partial derivatives commute, so each is identified
// by its variables in ascending order; those of an order precede those of the next: f, fx, fy, fxx,
// fxy, fyy, fxxx …
#pragma once

#include <vector>

namespace warpjet {

class MultiIndices {
 public:
  // Numbers the derivatives up to an order of a function of `variables` variables. Those of higher
  // orders are added on demand.
  MultiIndices(int variables, int order);

  int count() const { return static_cast<int>(all_.size()); }
  // Returns the number of the derivative of derivative `number` with respect to one more variable.
  int derivative(int number, int variable);
  // Returns the number of the derivative that this one was derived from, with respect to
  // `lastVariable`.
  int origin(int number) const { return all_[number].origin; }
  int lastVariable(int number) const { return all_[number].last; }

  static int countUpTo(int variables, int order);
  static int orderOf(int variables, int number);

 private:
  struct MultiIndex {
    int origin, last, order;
    int firstChild = 0;
  };

  void extend(int order);

  int variables_;
  std::vector<MultiIndex> all_;
};

}  // namespace warpjet
