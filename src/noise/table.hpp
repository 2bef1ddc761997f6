// Which noise functions there are: one row each.
#pragma once

#include <array>
#include <limits>
#include <string_view>

#include "noise/bodies.hpp"

namespace warpjet {

struct NoiseRow {
  // From a point and what follows it: a hash, and of a fractal lacunarity and gain.
  using Body = Numbers (*)(Library&, const Noise&, const Point& p, const Expression* parameters);

  std::string_view name;
  NoiseUse use;
  int values;
  double low, high;         // what each value lies between
  int fewest, most;         // dimensions of the point
  std::string_view points;  // what they are called, unless any will do
  Body body;
  // By dimensions, what the size of each first derivative does not exceed; of those that are made
  // of others nothing is said.
  double (*steepest)(int) = nullptr;
};

// As much as float32 may round.
inline constexpr double slack = 1.001;

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

inline constexpr std::array noises{
    NoiseRow{"noise", NoiseUse::Base, 1, -1, 1, 1, 4, "",
             [](auto& library, auto&, auto& p, auto* x) {
               return Numbers{gradientNoise(library, p, x[0])};
             },
             [](int dimensions) { return slack * steepestGradientNoise(dimensions); }},
    NoiseRow{"simplex", NoiseUse::Base, 1, -1, 1, 1, 4, "",
             [](auto& library, auto&, auto& p, auto* x) {
               return Numbers{simplexNoise(library, p, x[0])};
             },
             [](int dimensions) { return slack * steepestSimplexNoise(dimensions); }},
    NoiseRow{"valueNoise", NoiseUse::Base, 1, -1, 1, 1, 4, "",
             [](auto& library, auto&, auto& p, auto* x) {
               return Numbers{valueNoise(library, p, x[0])};
             },
             [](int) { return slack * steepestValueNoise(); }},
    NoiseRow{"worley", NoiseUse::Plain, 2, -unbounded, unbounded, 1, 3,
             "a number, a vec2 or a vec3",
             [](auto&, auto&, auto& p, auto* x) { return worleyNoise(p, x[0]); },
             // A distance changes by no more than the way.
             [](int) { return slack; }},
    NoiseRow{"curl", NoiseUse::Made, 3, -unbounded, unbounded, 3, 4,
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

// Not constexpr, so that reaching it while compiling is an error.
void noSuchNoise();

// The kind of that name. A name that the table lacks does not compile.
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
