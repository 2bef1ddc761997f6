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

// Bilinear is continuous. Bicubic passes through the texels too and is continuously differentiable
// (Keys, "Cubic Convolution Interpolation for Digital Image Processing", 1981, with a = -1/2: the
// Catmull-Rom spline). Bspline is the uniform cubic B-spline with the texels as control points: it
// smooths them and is twice continuously differentiable (Sigg, Hadwiger, "Fast Third-Order Texture
// Filtering", GPU Gems 2, chapter 20, 2005). Nearest is the texel itself, for images that hold
// data.
enum class Filter : std::uint8_t { Bilinear, Bicubic, Bspline, Nearest };

// What is beyond the edges: the texels there, the image again, or its mirror image.
enum class Wrap : std::uint8_t { Clamp, Repeat, Mirror };

// What sketches call them, by number.
inline constexpr std::array<std::string_view, 4> filterNames{"bilinear", "bicubic", "bspline",
                                                             "nearest"};
inline constexpr std::array<std::string_view, 3> wrapNames{"clamp", "repeat", "mirror"};

struct Sampling {
  Filter filter;
  Wrap wrap;
};

// A function of x, y, an image, and its width and height.
Definition definitionOf(const Sampling& sampling);
// The same from its settings.
Definition samplingFrom(std::uint32_t settings);

}  // namespace warpjet
