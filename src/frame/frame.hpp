// Moves frame constants, such as sin(millis / 900), out of a module's results: the host computes
// them in double precision once per frame and passes them to the shader as inputs.
#pragma once

#include <cstdint>
#include <span>

#include "module/module.hpp"

namespace warpjet {

// The frame inputs are vec4s with this name and a number.
inline constexpr const char* frameLabel = "warpjetFrame";

// Further frame constants are computed in the shader: a shader has space for 256 vec4s of uniforms,
// including those of the host.
inline constexpr std::size_t maxFrameValues = 128;

// Modifies the module: its results read frame inputs in place of expressions that depend only on
// the inputs `known` (by number), and an additional last result has the values of the frame inputs.
// Frame constants inside of periodic functions are reduced by whole periods, so that float32 keeps
// its precision however long a sketch runs. To make that possible, loops whose steps add different
// constants are unrolled, if they are small. Returns the number of vec4s.
std::uint32_t separateFrame(Module& module, std::span<const std::uint32_t> known);

}  // namespace warpjet
