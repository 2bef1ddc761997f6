#include "graph/multi_index.hpp"

namespace warpjet {

MultiIndices::MultiIndices(int variables, int order) : variables_(variables) {
  all_.push_back({0, 0, 0});
  extend(order);
}

void MultiIndices::extend(int order) {
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const auto [origin, last, ownOrder, firstChild] = all_[i];
    if (ownOrder >= order || firstChild != 0) continue;
    all_[i].firstChild = count();
    for (int variable = last; variable < variables_; ++variable)
      all_.push_back({static_cast<int>(i), variable, ownOrder + 1});
  }
}

int MultiIndices::derivative(int number, int variable) {
  extend(all_[number].order + 1);
  const auto child = [&](int parent, int added) {
    return all_[parent].firstChild + added - all_[parent].last;
  };
  const int last = lastVariable(number);
  if (last <= variable) return child(number, variable);
  return child(derivative(origin(number), variable), last);
}

int MultiIndices::countUpTo(int variables, int order) {
  int count = 1;  // binomial coefficient of (variables + order) over order
  for (int i = 1; i <= order; ++i) count = count * (variables + i) / i;
  return count;
}

int MultiIndices::orderOf(int variables, int number) {
  int order = 0;
  while (countUpTo(variables, order) <= number) ++order;
  return order;
}

}  // namespace warpjet
