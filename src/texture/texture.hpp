// Functions that read an image: they take x and y in texels, where 0 is the center of the first
// texel, and return red, green, blue and alpha, interpolated between texels. Reading a texel is the
// only step that isn't a node, and it is locally constant; so derivatives of every order are those
// of the interpolant itself, whatever filter the host has set.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "functions/library.hpp"

namespace warpjet {

// The function that reads a texel; each language has its own source.
inline constexpr const char* texelName = "warpjetTexel";
// The function that reads a texel that may be beyond the edges: the host's sampler wraps its index.
inline constexpr const char* sampledTexelName = "warpjetSampledTexel";

// Bilinear is continuous. Bicubic also interpolates the texels and is continuously differentiable
// (Keys, "Cubic Convolution Interpolation for Digital Image Processing", 1981, with a = -1/2: the
// Catmull-Rom spline). Bspline is the uniform cubic B-spline with the texels as control points: it
// smooths them and is twice continuously differentiable (Sigg, Hadwiger, "Fast Third-Order Texture
// Filtering", GPU Gems 2, chapter 20, 2005). Nearest is the texel itself, for images that contain
// data. Host is Bilinear, or Nearest if the third number of the host's settings is 1.
enum class Filter : std::uint8_t { Bilinear, Bicubic, Bspline, Nearest, Host };

// Beyond its edges, the image has the texels at the edge, or is repeated or mirrored. Host takes
// the mode of each axis from the host's settings: 0 is Clamp, 1 Repeat and 2 Mirror. Sampler leaves
// the wrapping to the host's sampler; WGSL, which has no such sampler here, clamps.
enum class Wrap : std::uint8_t { Clamp, Repeat, Mirror, Host, Sampler };

// Public names, by number.
inline constexpr std::array<std::string_view, 5> filterNames{"bilinear", "bicubic", "bspline",
                                                             "nearest", "host"};
inline constexpr std::array<std::string_view, 5> wrapNames{"clamp", "repeat", "mirror", "host",
                                                           "sampler"};

struct Sampling {
  Filter filter;
  Wrap wrap;

  // Returns true if the function reads the host's settings of the image.
  bool isByHost() const { return filter == Filter::Host || wrap == Wrap::Host; }
};

// Returns a function of x, y, an image, its width and height and, if they are needed, the host's
// settings of the image: the wrap modes of both axes, and 1 if it is sampled with the nearest
// filter.
Definition definitionOf(const Sampling& sampling);
// Recreates the definition from its settings.
Definition samplingFrom(std::uint32_t settings);

}  // namespace warpjet
