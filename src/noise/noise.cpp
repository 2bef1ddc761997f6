#include "noise/noise.hpp"

#include <cmath>
#include <string>

#include "noise/table.hpp"

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
  return row(noise.kind).body(library, noise, p, arguments.begin() + p.size());
}

// warpjetNoise3, warpjetCurl4Simplex, warpjetFbm2Noise5
std::string functionName(const Noise& noise, int dimensions) {
  std::string name = "warpjet" + capitalized(row(noise.kind).name) + std::to_string(dimensions);
  const NoiseUse use = row(noise.kind).use;
  if (use == NoiseUse::Made || use == NoiseUse::Fractal) name += capitalized(row(noise.base).name);
  if (isFractal(noise.kind)) name += std::to_string(noise.octaves);
  return name;
}

}  // namespace

Definition definitionOf(const Noise& noise, int dimensions) {
  const NoiseRow& kind = row(noise.kind);
  const int parameters = isFractal(noise.kind) ? 3 : 1;
  Definition made{
      {functionName(noise, dimensions), dimensions + parameters, kind.values, dimensions},
      body,
      pack(noise, dimensions)};
  made.low = kind.low;
  made.high = kind.high;
  if (kind.steepest) made.steepest = kind.steepest(dimensions);
  made.maker = noiseFrom;
  return made;
}

Definition noiseFrom(std::uint32_t settings) {
  const auto [noise, dimensions] = unpack(settings);
  return definitionOf(noise, static_cast<int>(dimensions));
}

double noisePeriod(const Definition& definition, std::optional<double> lacunarity) {
  if (definition.maker != noiseFrom) return 0;
  const auto [noise, dimensions] = unpack(definition.settings);
  const NoiseUse use = row(noise.kind).use;
  // Then octaves are whole numbers of periods too.
  const bool isWhole = lacunarity && *lacunarity == std::floor(*lacunarity);
  if (use == NoiseUse::Fractal && noise.octaves > 1 && !isWhole) return 0;
  const bool hasBase = use == NoiseUse::Fractal || use == NoiseUse::Made;
  if ((hasBase ? noise.base : noise.kind) != noiseNamed("simplex")) return ops::hashPrime;
  // In space its grid is skewed by a third of each coordinate, elsewhere by irrational shares.
  return dimensions == 3 ? 3 * ops::hashPrime : 0;
}

Expression callBase(Library& library, NoiseKind base, const Numbers& p, Expression seed) {
  Numbers arguments = p;
  arguments.push_back(seed);
  return library.call(definitionOf({base}, static_cast<int>(p.size())), arguments)[0];
}

}  // namespace warpjet
