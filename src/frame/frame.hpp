// What is the same for a whole frame, such as sin(millis / 900), leaves a module's results: a host
// computes it in double once a frame, and hands it to the shader as inputs.
#pragma once

#include <cstdint>
#include <span>

#include "module/module.hpp"

namespace warpjet {

// The inputs that take it are vec4s of these names, with a number.
inline constexpr const char* frameLabel = "warpjetFrame";

// More stay in the text: a shader has room for 256 vec4s, and the host's own are among them.
inline constexpr std::size_t mostFrameValues = 128;

// Loops stay in the text that would be more nodes without.
inline constexpr std::size_t mostUnrolled = 20'000;

// In place: results read inputs of the frame where they read what depends on inputs `known` alone,
// which are told by number, and one more result in the end is what those inputs are to be. What is
// added inside of something periodic is less by whole periods there, so that float32 keeps its
// digits however long a sketch runs; so loops are written out whose steps add something else each.
// Gives how many vec4s there are.
std::uint32_t separateFrame(Module& module, std::span<const std::uint32_t> known);

}  // namespace warpjet
