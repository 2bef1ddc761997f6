// Finds results that are the sum of an input and an earlier result, which shortens the code:
// `position + offset` instead of three sums.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "module/module.hpp"

namespace warpjet {

struct Sum {
  std::uint32_t input;
  std::size_t output;
};

// Returns, for each output, the sum that it is, if any.
std::vector<std::optional<Sum>> findSums(const Graph& graph, std::span<const Output> outputs);

}  // namespace warpjet
