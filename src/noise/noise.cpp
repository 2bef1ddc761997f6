#include "noise/noise.hpp"

#include <string>

#include "noise/bodies.hpp"

namespace warpjet {

namespace {

// A noise and its dimensions in one number, for Definition::settings.
constexpr std::uint32_t pack(const Noise& noise, int dimensions) {
  return static_cast<std::uint32_t>(noise.kind) | static_cast<std::uint32_t>(noise.base) << 8 |
         static_cast<std::uint32_t>(noise.octaves) << 16 |
         static_cast<std::uint32_t>(dimensions) << 24;
}

struct Unpacked {
  Noise noise;
  std::size_t dimensions;
};

Unpacked unpack(std::uint32_t settings) {
  return {{NoiseKind(settings & 255), NoiseKind(settings >> 8 & 255),
           static_cast<int>(settings >> 16 & 255)},
          settings >> 24};
}

Numbers body(Library& library, std::uint32_t settings, const Numbers& arguments) {
  const auto [noise, dimensions] = unpack(settings);
  Numbers p;
  while (p.size() < dimensions) p.push_back(arguments[p.size()]);
  const Expression* parameters = arguments.begin() + p.size();
  const Expression seed = parameters[0];
  switch (noise.kind) {
    case NoiseKind::Gradient:
      return {gradientNoise(library, p, seed)};
    case NoiseKind::Simplex:
      return {simplexNoise(library, p, seed)};
    case NoiseKind::Value:
      return {valueNoise(p, seed)};
    case NoiseKind::Worley:
      return worleyNoise(p, seed);
    case NoiseKind::Curl:
      return curlNoise(library, noise.base, p, seed);
    default:
      return {fractalNoise(library, noise, p, seed, parameters[1], parameters[2])};
  }
}

std::string capitalized(std::string_view text) {
  std::string name(text);
  name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

// warpjetNoise3, warpjetCurl4Simplex, warpjetFbm2Noise5
std::string functionName(const Noise& noise, int dimensions) {
  std::string name = "warpjet" + capitalized(nameOf(noise.kind)) + std::to_string(dimensions);
  if (noise.kind >= NoiseKind::Curl) name += capitalized(nameOf(noise.base));
  if (isFractal(noise.kind)) name += std::to_string(noise.octaves);
  return name;
}

}  // namespace

Definition definitionOf(const Noise& noise, int dimensions) {
  const int values = noise.kind == NoiseKind::Worley ? 2 : noise.kind == NoiseKind::Curl ? 3 : 1;
  const int parameters = isFractal(noise.kind) ? 3 : 1;
  Definition made{{functionName(noise, dimensions), dimensions + parameters, values, dimensions},
                  body,
                  pack(noise, dimensions)};
  if (values == 1) {
    made.low = noise.kind >= NoiseKind::Ridged ? 0 : -1;
    made.high = 1;
  }
  made.maker = noiseFrom;
  return made;
}

Definition noiseFrom(std::uint32_t settings) {
  const auto [noise, dimensions] = unpack(settings);
  return definitionOf(noise, static_cast<int>(dimensions));
}

Expression callBase(Library& library, NoiseKind base, const Numbers& p, Expression seed) {
  Numbers arguments = p;
  arguments.push_back(seed);
  return library.call(definitionOf({base}, static_cast<int>(p.size())), arguments)[0];
}

}  // namespace warpjet
