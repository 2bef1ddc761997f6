// The public interface of the noise functions.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "functions/library.hpp"

namespace warpjet {

// A row of noise/table.hpp, by number.
enum class NoiseKind : std::uint8_t {};

// The composition of a kind, which determines its options.
enum class NoiseUse : std::uint8_t {
  Base,      // the base of others
  Plain,     // not composed of others
  Composed,  // composed of one base
  Fractal    // octaves of a base
};

// Integers up to this limit are exact in a shader's float.
inline constexpr int maxSeed = 1 << 23;
inline constexpr int maxOctaves = 16;

struct Noise {
  NoiseKind kind;
  NoiseKind base = {};  // of fractals and curl
  int octaves = 1;      // of fractals
  // True if integer cells are passed, too, which are added to the point. Then float32 need not
  // represent the cells, so that it represents the position within a cell precisely, however far
  // away the point is.
  bool hasCells = false;
  // True if the width of a pixel is passed, too, in the space of the point: see `fadeNoise`.
  bool fades = false;
};

// Returns a function of a point with that many dimensions and of a hash; for fractals, also of
// lacunarity and gain. The width of a pixel precedes the hash, and cells are last.
Definition definitionOf(const Noise& noise, int dimensions);
// Returns the variant that takes integer cells, each within ±`ops::hashPrime` / 2.
Definition withCells(const Definition& definition);
// Returns true if `withCells` may be used: the period is known to be `ops::hashPrime`, and float32
// can represent the cells of the finest octave.
bool canTakeCells(const Definition& definition, std::optional<double> lacunarity);
// Returns the period of each coordinate; 0 if it is unknown, or if the definition isn't a noise.
// Cells have one of `ops::hashPrime` hashes, cyclically.
double noisePeriod(const Definition& definition, std::optional<double> lacunarity);
// Returns the wavelength in the space of the point. For fractals, returns the wavelength of octave
// number `octave`, or of the last one if there are fewer, assuming a lacunarity of 2.
double wavelengthOf(const Definition& definition, int octave);
// Returns the variant that takes the width of a pixel.
Definition withFading(const Definition& definition);
// Recreates the definition from its settings.
Definition noiseFrom(std::uint32_t settings);

}  // namespace warpjet
