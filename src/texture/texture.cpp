#include "texture/texture.hpp"

#include <string>

namespace warpjet {

namespace {

constexpr std::string_view filterNames[] = {"Bilinear", "Bicubic", "Bspline"};
constexpr std::string_view wrapNames[] = {"Clamp", "Repeat", "Mirror"};

constexpr int channels = 4;

// Texel centres lie at half texels, where not even a linear filter of the host's mixes neighbours.
constexpr ops::Helpers texelTexts{
    R"(highp vec4 warpjetTexel(highp float x, highp float y, highp sampler2D image) {
  return texelFetch(image, ivec2(int(x), int(y)), 0);
}
)",
    R"(highp vec4 warpjetTexel(highp float x, highp float y, highp sampler2D image, highp float width, highp float height) {
  return texture2D(image, vec2((x + 0.5) / width, (y + 0.5) / height));
}
)",
    R"(fn warpjetTexel(x: f32, y: f32, image: texture_2d<f32>) -> vec4f {
  return textureLoad(image, vec2i(i32(x), i32(y)), 0);
}
)"};

constexpr ops::Helpers sizeTexts{
    R"(highp vec2 warpjetImageSize(highp sampler2D image) {
  return vec2(textureSize(image, 0));
}
)",
    "",
    R"(fn warpjetImageSize(image: texture_2d<f32>) -> vec2f {
  return vec2f(textureDimensions(image));
}
)"};

// By texel, its weight as a polynomial of where between the middle two the point lies, from 0 to 1.
using Weights = double[4][4];
constexpr Weights catmullRom = {
    {0, -0.5, 1, -0.5}, {1, 0, -2.5, 1.5}, {0, 0.5, 2, -1.5}, {0, 0, -0.5, 0.5}};
constexpr Weights bspline = {{1. / 6, -0.5, 0.5, -1. / 6},
                             {4. / 6, 0, -1, 0.5},
                             {1. / 6, 0.5, 0.5, -0.5},
                             {0, 0, 0, 1. / 6}};

// A whole number of any size as the number of a texel. The half keeps a quotient that a GPU rounds
// away from whole numbers.
Expression wrapped(Expression i, Expression size, Wrap wrap) {
  const auto repeated = [&](Expression period) {
    return i - period * floor((i + 0.5) / period);
  };
  if (wrap == Wrap::Repeat) return repeated(size);
  if (wrap == Wrap::Clamp) return min(max(i, 0.0), size - 1.0);
  const Expression twice = size * 2.0, back = repeated(twice);
  return min(back, twice - 1.0 - back);
}

// Along one side of the image: the texels near a point, and how to mix them.
class Axis {
 public:
  Axis(Expression coordinate, Expression size, const Sampling& sampling) {
    const Expression position = coordinate * size - 0.5, first = floor(position);
    inside_ = build(ops::find("fract"), position);
    const bool isLinear = sampling.filter == Filter::Bilinear;
    for (int i = isLinear ? 0 : -1; i <= (isLinear ? 1 : 2); ++i)
      texels.push_back(wrapped(first + static_cast<double>(i), size, sampling.wrap));
    if (isLinear) return;
    for (const double* c : sampling.filter == Filter::Bicubic ? catmullRom : bspline)
      weights_.push_back(((inside_ * c[3] + c[2]) * inside_ + c[1]) * inside_ + c[0]);
  }

  Expression mix(std::span<const Expression> x) const {
    // With weights, a flat image would have a slope by rounding.
    if (weights_.empty()) return x[0] + inside_ * (x[1] - x[0]);
    Expression sum = weights_[0] * x[0];
    for (std::size_t i = 1; i < x.size(); ++i) sum = sum + weights_[i] * x[i];
    return sum;
  }

  Numbers texels;

 private:
  Expression inside_;
  Numbers weights_;
};

Numbers sizeOf(Library& library, std::span<const Expression> image) {
  if (image.size() > 1) return {image[1], image[2]};
  return library.call({.function = {"warpjetImageSize", 1, 2, 0}, .texts = sizeTexts}, image);
}

Numbers texel(Library& library, Expression x, Expression y, std::span<const Expression> image) {
  Numbers arguments{x, y};
  arguments.insert(arguments.end(), image.begin(), image.end());
  const int arity = static_cast<int>(arguments.size());
  return library.call({.function = {"warpjetTexel", arity, channels, 0}, .texts = texelTexts},
                      arguments);
}

Numbers body(Library& library, std::uint32_t settings, std::span<const Expression> arguments) {
  const Sampling sampling{Filter(settings & 255), Wrap(settings >> 8)};
  const auto image = arguments.subspan(2);
  const Numbers size = sizeOf(library, image);
  const Axis across(arguments[0], size[0], sampling), down(arguments[1], size[1], sampling);
  Numbers values;
  for (int channel = 0; channel < channels; ++channel) {
    Numbers rows;
    for (const Expression y : down.texels) {
      Numbers row;
      for (const Expression x : across.texels) row.push_back(texel(library, x, y, image)[channel]);
      rows.push_back(across.mix(row));
    }
    values.push_back(down.mix(rows));
  }
  return values;
}

}  // namespace

Definition definitionOf(const Sampling& sampling, bool takesSize) {
  const auto filter = static_cast<std::uint32_t>(sampling.filter);
  const auto wrap = static_cast<std::uint32_t>(sampling.wrap);
  std::string name = "warpjet";
  name += filterNames[filter];
  name += wrapNames[wrap];
  return {.function = {name, takesSize ? 5 : 3, channels, 2},
          .body = body,
          .settings = filter | wrap << 8,
          .parameters = Definition::imageParameters};
}

}  // namespace warpjet
