// Which noise functions there are, by name.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "functions/library.hpp"

namespace warpjet {

// The first three are what the others may be made of.
enum class NoiseKind : std::uint8_t {
  Gradient,
  Simplex,
  Value,
  Worley,
  Curl,
  Sum,
  Ridged,
  Turbulence
};

inline constexpr std::array<std::string_view, 8> noiseNames{
    "noise", "simplex", "valueNoise", "worley", "curl", "fbm", "ridged", "turbulence"};

constexpr std::string_view nameOf(NoiseKind kind) {
  return noiseNames[static_cast<std::size_t>(kind)];
}

constexpr bool isFractal(NoiseKind kind) { return kind >= NoiseKind::Sum; }

struct Noise {
  NoiseKind kind;
  NoiseKind base = NoiseKind::Gradient;  // of fractals and curls
  int octaves = 1;                       // of fractals
};

// A function of a point of so many dimensions and of a hash; of fractals, also of lacunarity and
// gain.
Definition definitionOf(const Noise& noise, int dimensions);
// The same from its settings.
Definition noiseFrom(std::uint32_t settings);

}  // namespace warpjet
