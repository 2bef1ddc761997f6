// An array of booleans, indexed by number.
#pragma once

#include <cstdint>
#include <vector>

namespace warpjet {

// One byte per flag: std::vector<bool> packs bits, which takes 3 KB of code in the wasm.
using Flags = std::vector<std::uint8_t>;

}  // namespace warpjet
