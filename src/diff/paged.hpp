// Sparse values by node: pages that are allocated when one of their values is set.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

template <class Value>
class Paged {
 public:
  static constexpr std::size_t pageSize = 128;

  // Returns the value of the node for writing, and allocates its page if necessary.
  Value& set(NodeId id) {
    const std::size_t page = index(id) / pageSize;
    if (page >= pages_.size()) pages_.resize(page + 1);
    if (!pages_[page]) {
      pages_[page] = std::make_unique<Page>();
      ++count_;
    }
    return (*pages_[page])[index(id) % pageSize];
  }

  // Values that were never set are default-constructed.
  Value operator[](NodeId id) const {
    const std::size_t page = index(id) / pageSize;
    if (page >= pages_.size() || !pages_[page]) return {};
    return (*pages_[page])[index(id) % pageSize];
  }

  std::size_t bytes() const { return count_ * sizeof(Page) + pages_.size() * sizeof(pages_[0]); }

 private:
  using Page = std::array<Value, pageSize>;

  std::vector<std::unique_ptr<Page>> pages_;
  std::size_t count_ = 0;
};

}  // namespace warpjet
