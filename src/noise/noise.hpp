// The noise functions, as those see them who call them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "functions/library.hpp"

namespace warpjet {

// A row of noise/table.hpp, by its number.
enum class NoiseKind : std::uint8_t {};

// What a kind is made of, and so what it takes.
enum class NoiseUse : std::uint8_t {
  Base,    // what others may be made of
  Plain,   // nothing but itself
  Made,    // one base
  Fractal  // octaves of a base
};

// Whole numbers up to here are exact in a float of the shader.
inline constexpr int mostSeed = 1 << 23;
inline constexpr int mostOctaves = 16;

struct Noise {
  NoiseKind kind;
  NoiseKind base = {};  // of fractals and curls
  int octaves = 1;      // of fractals
  // Whether whole numbers follow that are to be added to the point, which may lie so far away then
  // that float32 would not tell where in its cell it is.
  bool hasCells = false;
};

// A function of a point of so many dimensions and of a hash; of fractals, also of lacunarity and
// gain.
Definition definitionOf(const Noise& noise, int dimensions);
// The same with such whole numbers, at most half of `ops::hashPrime` from 0.
Definition withCells(const Definition& definition);
// Whether there is such a one, and float32 has the cells of its finest octave.
bool knowsCells(const Definition& definition, std::optional<double> lacunarity);
// By how much each coordinate may be moved without any change; 0 if nothing is known, as of what is
// no noise. Cells have one of `ops::hashPrime` hashes, one after the other.
double noisePeriod(const Definition& definition, std::optional<double> lacunarity);
// The same from its settings.
Definition noiseFrom(std::uint32_t settings);

}  // namespace warpjet
