// Images as functions of a place: x and y in texels enter, 0 at the centre of the first one, and
// red, green, blue and alpha of the interpolant between the texels leave. To read a texel is the
// only step that is no node, and it is locally constant; so derivatives of every order are those of
// the interpolant itself, whatever filter the host has set.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "functions/library.hpp"

namespace warpjet {

// Reads a texel; each language has a text for it.
inline constexpr const char* texelName = "warpjetTexel";
// Reads a texel that may lie beyond the edges: the host's sampler wraps it.
inline constexpr const char* sampledTexelName = "warpjetSampledTexel";

// Bilinear is continuous. Bicubic passes through the texels too and is continuously differentiable
// (Keys, "Cubic Convolution Interpolation for Digital Image Processing", 1981, with a = -1/2: the
// Catmull-Rom spline). Bspline is the uniform cubic B-spline with the texels as control points: it
// smooths them and is twice continuously differentiable (Sigg, Hadwiger, "Fast Third-Order Texture
// Filtering", GPU Gems 2, chapter 20, 2005). Nearest is the texel itself, for images that hold
// data. Host is Bilinear, or Nearest where the third number of the host's settings is 1.
enum class Filter : std::uint8_t { Bilinear, Bicubic, Bspline, Nearest, Host };

// What is beyond the edges: the texels there, the image again, or its mirror image. Host reads the
// way of each axis from the host's settings: 0 is Clamp, 1 Repeat and 2 Mirror. Sampler leaves it
// to the host's sampler, which WGSL lacks here; it clamps there.
enum class Wrap : std::uint8_t { Clamp, Repeat, Mirror, Host, Sampler };

// What sketches call them, by number.
inline constexpr std::array<std::string_view, 5> filterNames{"bilinear", "bicubic", "bspline",
                                                             "nearest", "host"};
inline constexpr std::array<std::string_view, 5> wrapNames{"clamp", "repeat", "mirror", "host",
                                                           "sampler"};

struct Sampling {
  Filter filter;
  Wrap wrap;

  // True if it reads the host's settings of the image.
  bool isByHost() const { return filter == Filter::Host || wrap == Wrap::Host; }
};

// A function of x, y, an image, its width and height and, where they count, the host's settings of
// it: how it wraps across and down, and 1 where it takes the nearest texel.
Definition definitionOf(const Sampling& sampling);
// The same from its settings.
Definition samplingFrom(std::uint32_t settings);

}  // namespace warpjet
