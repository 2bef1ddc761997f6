// The change of a number from a pixel to the next, which only a fragment shader can compute.
#pragma once

#include "functions/library.hpp"

namespace warpjet {

// Names of functions of the shader that return the change along x and along y of the screen. Each
// language has its own source.
inline constexpr const char* acrossName = "warpjetAcross";
inline constexpr const char* downName = "warpjetDown";

// Calls one of these functions.
inline Expression changeOnScreen(Library& library, const char* name, Expression x) {
  return library.call({.function = {name, 1, 1, 0}}, {x})[0];
}

}  // namespace warpjet
