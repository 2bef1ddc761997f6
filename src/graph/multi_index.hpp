// Partial derivatives by number. They commute, so each is named by its variables in ascending
// order, and all of one order come before those of the next: f, fx, fy, fxx, fxy, fyy, fxxx …
#pragma once

#include <vector>

namespace warpjet {

class MultiIndices {
 public:
  // Of a function of so many variables, up to an order, and those of the next if they are asked
  // for.
  MultiIndices(int variables, int order);

  int count() const { return static_cast<int>(all_.size()); }
  // The derivative by one variable more.
  int derived(int number, int variable);
  // The derivative that this one is a derivative of, by its last variable.
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
