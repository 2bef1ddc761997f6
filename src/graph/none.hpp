// Where things are told by their numbers, what stands for none of them.
#pragma once

#include <cstdint>

namespace warpjet {

inline constexpr std::uint32_t none = ~std::uint32_t{0};

}  // namespace warpjet
