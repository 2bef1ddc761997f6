// The index that means "none".
#pragma once

#include <cstdint>

namespace warpjet {

inline constexpr std::uint32_t none = ~std::uint32_t{0};

}  // namespace warpjet
