// Finds functions that call themselves, directly or indirectly.
#pragma once

#include <optional>
#include <vector>

#include "source/tree.hpp"

namespace warpjet::source {

struct FunctionCall {
  FunctionId from, to;
  Location location;
};

// Returns a call that is part of a circle; nullopt if there is none.
std::optional<FunctionCall> findRecursion(std::size_t functionCount,
                                          const std::vector<FunctionCall>& calls);

}  // namespace warpjet::source
