// Images as functions of texture coordinates: x and y enter, from 0 to 1 across the image, and red,
// green, blue and alpha of the interpolant between its texels leave. To read a texel is the only
// step that is no node, and it is locally constant; so derivatives of every order are those of the
// interpolant itself, whatever filter the host has set.
#pragma once

#include <cstdint>

#include "functions/library.hpp"

namespace warpjet {

// Bilinear is continuous. Bicubic passes through the texels too and is continuously differentiable
// (Keys, "Cubic Convolution Interpolation for Digital Image Processing", 1981, with a = -1/2: the
// Catmull-Rom spline). Bspline is the uniform cubic B-spline with the texels as control points: it
// smooths them and is twice continuously differentiable (Sigg, Hadwiger, "Fast Third-Order Texture
// Filtering", GPU Gems 2, chapter 20, 2005).
enum class Filter : std::uint8_t { Bilinear, Bicubic, Bspline };

// What is beyond the edges: the texels there, the image again, or its mirror image.
enum class Wrap : std::uint8_t { Clamp, Repeat, Mirror };

struct Sampling {
  Filter filter;
  Wrap wrap;
};

// A function of x, y and an image, and of its width and height in texels for a language that cannot
// ask an image for them.
Definition definitionOf(const Sampling& sampling, bool takesSize);

}  // namespace warpjet
