// The noise functions, one per row.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "noise/bodies.hpp"

namespace warpjet {

struct NoiseRow {
  // Takes a point and its parameters: a hash, and for fractals lacunarity and gain.
  using Body = Numbers (*)(Library&, const Noise&, const Point& p, const Expression* parameters);

  std::string_view name;
  NoiseUse use;
  int values;
  double low, high;                  // bounds of each value
  int minDimensions, maxDimensions;  // dimensions of the point
  std::string_view points;           // the name of valid points in messages, unless all are valid
  Body body;
  // The bound of the magnitude of each first derivative, by dimension; null for noises composed of
  // others.
  double (*maxSlope)(int) = nullptr;
};

// Covers the rounding of float32.
inline constexpr double slack = 1.001;

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

inline constexpr std::array noises{
    NoiseRow{"noise", NoiseUse::Base, 1, -1, 1, 1, 4, "",
             [](auto& library, auto&, auto& p, auto* x) {
               return Numbers{gradientNoise(library, p, x[0])};
             },
             [](int dimensions) { return slack * maxSlopeOfGradientNoise(dimensions); }},
    NoiseRow{"simplex", NoiseUse::Base, 1, -1, 1, 1, 4, "",
             [](auto& library, auto&, auto& p, auto* x) {
               return Numbers{simplexNoise(library, p, x[0])};
             },
             [](int dimensions) { return slack * maxSlopeOfSimplexNoise(dimensions); }},
    NoiseRow{"valueNoise", NoiseUse::Base, 1, -1, 1, 1, 4, "",
             [](auto& library, auto&, auto& p, auto* x) {
               return Numbers{valueNoise(library, p, x[0])};
             },
             [](int) { return slack * maxSlopeOfValueNoise(); }},
    NoiseRow{"worley", NoiseUse::Plain, 2, -unbounded, unbounded, 1, 3,
             "a number, a vec2 or a vec3",
             [](auto&, auto&, auto& p, auto* x) { return worleyNoise(p, x[0]); },
             // A distance changes by no more than the distance moved.
             [](int) { return slack; }},
    NoiseRow{"curl", NoiseUse::Composed, 3, -unbounded, unbounded, 3, 4,
             "a vec3, or a vec4 whose last number is time",
             [](auto& library, auto& noise, auto& p, auto* x) {
               return curlNoise(library, noise.base, p, x[0]);
             }},
    NoiseRow{"fbm", NoiseUse::Fractal, 1, -1, 1, 1, 4, "",
             [](auto& library, auto& noise, auto& p, auto* x) {
               return Numbers{fractalNoise(library, noise, p, x, [](Expression n) { return n; })};
             }},
    NoiseRow{"ridged", NoiseUse::Fractal, 1, 0, 1, 1, 4, "",
             [](auto& library, auto& noise, auto& p, auto* x) {
               return Numbers{fractalNoise(library, noise, p, x, [](Expression n) {
                 const Expression ridge = 1.0 - abs(n);
                 return ridge * ridge;
               })};
             }},
    NoiseRow{"turbulence", NoiseUse::Fractal, 1, 0, 1, 1, 4, "",
             [](auto& library, auto& noise, auto& p, auto* x) {
               return Numbers{
                   fractalNoise(library, noise, p, x, [](Expression n) { return abs(n); })};
             }},
};

constexpr bool takesAllPoints(const NoiseRow& row) {
  return row.minDimensions == 1 && row.maxDimensions == 4;
}
static_assert(std::all_of(noises.begin(), noises.end(),
                          [](auto& row) { return takesAllPoints(row) == row.points.empty(); }),
              "A row names the valid points if and only if it rejects some of 1 to 4 dimensions.");
static_assert(std::all_of(noises.begin(), noises.end(),
                          [](auto& row) {
                            return row.use != NoiseUse::Base ||
                                   (takesAllPoints(row) && row.values == 1);
                          }),
              "A base has one value at points of 1 to 4 dimensions: fractals and curl call it so.");

// Not constexpr, so that reaching it at compile time is an error.
void noSuchNoise();

// The kind with that name. An unknown name doesn't compile.
consteval NoiseKind noiseNamed(std::string_view name) {
  for (std::size_t i = 0; i < noises.size(); ++i) {
    if (noises[i].name == name) return static_cast<NoiseKind>(i);
  }
  noSuchNoise();
  return {};
}

constexpr const NoiseRow& row(NoiseKind kind) { return noises[static_cast<std::size_t>(kind)]; }
constexpr bool isFractal(NoiseKind kind) { return row(kind).use == NoiseUse::Fractal; }

}  // namespace warpjet
