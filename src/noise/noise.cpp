#include "noise/noise.hpp"

#include <cmath>
#include <string>

#include "noise/table.hpp"
#include "ops/scalar.hpp"

namespace warpjet {

namespace {

constexpr std::uint32_t cellsFlag = std::uint32_t{1} << 31, fadingFlag = std::uint32_t{1} << 30;

// Packs a noise and its dimension into one number, for Definition::settings.
constexpr std::uint32_t pack(const Noise& noise, int dimensions) {
  return static_cast<std::uint32_t>(noise.kind) | static_cast<std::uint32_t>(noise.base) << 8 |
         static_cast<std::uint32_t>(noise.octaves) << 16 |
         static_cast<std::uint32_t>(dimensions) << 24 | (noise.hasCells ? cellsFlag : 0) |
         (noise.fades ? fadingFlag : 0);
}

struct Unpacked {
  Noise noise;
  std::size_t dimensions;
};

Unpacked unpack(std::uint32_t settings) {
  return {{NoiseKind(settings & 255), NoiseKind(settings >> 8 & 255),
           static_cast<int>(settings >> 16 & 255), (settings & cellsFlag) != 0,
           (settings & fadingFlag) != 0},
          settings >> 24 & 63};
}

Numbers body(Library& library, std::uint32_t settings, const Numbers& arguments) {
  const auto [noise, dimensions] = unpack(settings);
  Point p;
  for (std::size_t i = 0; i < dimensions; ++i) {
    p.push_back(arguments[i]);
    if (noise.hasCells) p.cells.push_back(arguments[arguments.size() - dimensions + i]);
  }
  const Expression* parameters = arguments.begin() + dimensions;
  if (noise.fades) p.pixel = *parameters++;
  const NoiseRow& kind = row(noise.kind);
  Numbers values = kind.body(library, noise, p, parameters);
  if (!p.pixel || isFractal(noise.kind) || kind.wavelength == 0) return values;
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = fade(values[i], kind.mean(noise, dimensions, i), *p.pixel, kind.wavelength);
  return values;
}

// The names of parameters. Definition::noiseParameters has those of noise with octaves.
constexpr std::string_view namesWithoutOctaves[] = {"seed", "cellX", "cellY", "cellZ", "cellW"};
constexpr std::string_view fadingNames[] = {"pixel", "seed",  "lacunarity", "gain",
                                            "cellX", "cellY", "cellZ",      "cellW"};
constexpr std::string_view fadingNamesWithoutOctaves[] = {"pixel", "seed",  "cellX",
                                                          "cellY", "cellZ", "cellW"};

const std::string_view* parameterNames(const Noise& noise) {
  if (isFractal(noise.kind)) return noise.fades ? fadingNames : Definition::noiseParameters;
  return noise.fades ? fadingNamesWithoutOctaves : namesWithoutOctaves;
}

// Returns a name such as warpjetNoise3, warpjetCurl4Simplex or warpjetFbm2Noise5.
std::string functionName(const Noise& noise, int dimensions) {
  std::string name = "warpjet" + capitalize(row(noise.kind).name) + std::to_string(dimensions);
  const NoiseUse use = row(noise.kind).use;
  if (use == NoiseUse::Composed || use == NoiseUse::Fractal)
    name += capitalize(row(noise.base).name);
  if (isFractal(noise.kind)) name += std::to_string(noise.octaves);
  if (noise.hasCells) name += "Cells";
  if (noise.fades) name += "Fading";
  return name;
}

}  // namespace

Definition definitionOf(const Noise& noise, int dimensions) {
  const NoiseRow& kind = row(noise.kind);
  const int parameters =
      (noise.fades ? 1 : 0) + (isFractal(noise.kind) ? 3 : 1) + (noise.hasCells ? dimensions : 0);
  Definition definition{
      {functionName(noise, dimensions), dimensions + parameters, kind.values, dimensions},
      body,
      pack(noise, dimensions)};
  definition.low = kind.low;
  definition.high = kind.high;
  if (kind.maxSlope) definition.maxSlope = kind.maxSlope(dimensions);
  definition.parameters = parameterNames(noise);
  definition.maker = noiseFrom;
  return definition;
}

Definition noiseFrom(std::uint32_t settings) {
  const auto [noise, dimensions] = unpack(settings);
  return definitionOf(noise, static_cast<int>(dimensions));
}

Definition withCells(const Definition& definition) {
  return noiseFrom(definition.settings | cellsFlag);
}

Definition withFading(const Definition& definition) {
  return noiseFrom(definition.settings | fadingFlag);
}

bool canTakeCells(const Definition& definition, std::optional<double> lacunarity) {
  if (noisePeriod(definition, lacunarity) != ops::hashPrime) return false;
  // Other kinds than fractals have no lacunarity.
  return std::pow(lacunarity.value_or(1), unpack(definition.settings).noise.octaves) < 0x1p13;
}

double noisePeriod(const Definition& definition, std::optional<double> lacunarity) {
  if (definition.maker != noiseFrom) return 0;
  const auto [noise, dimensions] = unpack(definition.settings);
  const NoiseUse use = row(noise.kind).use;
  // With an integer lacunarity, a shift by one period moves every octave by an integer number of
  // periods.
  const bool isInteger = lacunarity && *lacunarity == std::floor(*lacunarity);
  if (use == NoiseUse::Fractal && noise.octaves > 1 && !isInteger) return 0;
  const bool hasBase = use == NoiseUse::Fractal || use == NoiseUse::Composed;
  if ((hasBase ? noise.base : noise.kind) != noiseNamed("simplex")) return ops::hashPrime;
  // In 3D the grid is skewed by a third of each coordinate, in other dimensions by irrational
  // shares.
  return dimensions == 3 ? 3 * ops::hashPrime : 0;
}

double wavelengthOf(const Definition& definition, int octave) {
  const Noise noise = unpack(definition.settings).noise;
  const NoiseRow& kind = row(noise.kind);
  const bool hasBase = kind.use == NoiseUse::Fractal || kind.use == NoiseUse::Composed;
  if (!hasBase) return kind.wavelength;
  // Curl consists of derivatives, which are finer than their base.
  const double share = kind.use == NoiseUse::Fractal ? kind.wavelength : 0.5;
  return share * row(noise.base).wavelength / (1 << std::min(octave, noise.octaves - 1));
}

Expression callBase(Library& library, NoiseKind base, const Point& p, Expression seed) {
  Numbers arguments = p;
  if (p.pixel) arguments.push_back(*p.pixel);
  arguments.push_back(seed);
  for (const Expression cell : p.cells) arguments.push_back(cell);
  const Noise noise{base, {}, 1, p.cells.size() > 0, p.pixel.has_value()};
  return library.call(definitionOf(noise, static_cast<int>(p.size())), arguments)[0];
}

}  // namespace warpjet
