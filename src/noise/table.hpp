// The noise functions, one per row.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "noise/bodies.hpp"

namespace warpjet {

// The means of |n| and of n^2 over all of space for a base n, by dimension: averages of a million
// random points, which tests/cpp/noise_fading_test.cpp measures again.
struct Means {
  double magnitude[4], square[4];
};

struct NoiseRow {
  // Takes a point and its parameters: a hash, and for fractals lacunarity and gain.
  using Body = Numbers (*)(Library&, const Noise&, const Point& p, const Expression* parameters);
  // Returns the mean of value number `i` over all of space; for fractals, that of an octave.
  using Mean = double (*)(const Noise&, std::size_t dimensions, std::size_t i);

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
  // The wavelength that `fade` assumes, in cells; for fractals, as a share of their base's. Fitted
  // to means over square pixels; tests/cpp/noise_fading_test.cpp compares them. 0: the base fades
  // instead.
  double wavelength = 0;
  Mean mean = [](auto&, std::size_t, std::size_t) { return 0.0; };
  Means means = {};  // of bases
};

constexpr const NoiseRow& row(NoiseKind kind);

// A factor that covers the rounding of float32.
inline constexpr double slack = 1.001;

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

// The mean distances of worley, by dimension, measured like `Means`.
inline constexpr double worleyMeans[2][3] = {{0.2894, 0.4296, 0.5204}, {0.7545, 0.6992, 0.7168}};

inline constexpr NoiseRow::Mean zeroMean = NoiseRow{}.mean;

inline constexpr std::array noises{
    NoiseRow{"noise",
             NoiseUse::Base,
             1,
             -1,
             1,
             1,
             4,
             "",
             [](auto& library, auto&, auto& p, auto* x) {
               return Numbers{gradientNoise(library, p, x[0])};
             },
             [](int dimensions) { return slack * maxSlopeOfGradientNoise(dimensions); },
             1.37,
             zeroMean,
             {{0.2074, 0.2483, 0.1815, 0.1381}, {0.0752, 0.0922, 0.0489, 0.0287}}},
    NoiseRow{"simplex",
             NoiseUse::Base,
             1,
             -1,
             1,
             1,
             4,
             "",
             [](auto& library, auto&, auto& p, auto* x) {
               return Numbers{simplexNoise(library, p, x[0])};
             },
             [](int dimensions) { return slack * maxSlopeOfSimplexNoise(dimensions); },
             0.75,
             zeroMean,
             {{0.2510, 0.4666, 0.3115, 0.1768}, {0.1007, 0.2900, 0.1512, 0.0641}}},
    NoiseRow{"valueNoise",
             NoiseUse::Base,
             1,
             -1,
             1,
             1,
             4,
             "",
             [](auto& library, auto&, auto& p, auto* x) {
               return Numbers{valueNoise(library, p, x[0])};
             },
             [](int) { return slack * maxSlopeOfValueNoise(); },
             1.68,
             zeroMean,
             {{0.4318, 0.3793, 0.3308, 0.2884}, {0.2598, 0.2055, 0.1610, 0.1259}}},
    NoiseRow{"worley", NoiseUse::Plain, 2, -unbounded, unbounded, 1, 3,
             "a number, a vec2 or a vec3",
             [](auto&, auto&, auto& p, auto* x) { return worleyNoise(p, x[0]); },
             // A distance changes by no more than the distance moved.
             [](int) { return slack; }, 0.9,
             [](auto&, auto dimensions, auto i) { return worleyMeans[i][dimensions - 1]; }},
    NoiseRow{"curl", NoiseUse::Composed, 3, -unbounded, unbounded, 3, 4,
             "a vec3, or a vec4 whose last number is time",
             [](auto& library, auto& noise, auto& p, auto* x) {
               return curlNoise(library, noise.base, p, x[0]);
             }},
    NoiseRow{"fbm", NoiseUse::Fractal, 1, -1, 1, 1, 4, "",
             [](auto& library, auto& noise, auto& p, auto* x) {
               return Numbers{fractalNoise(library, noise, p, x, [](Expression n) { return n; })};
             },
             nullptr, 1},
    NoiseRow{"ridged", NoiseUse::Fractal, 1, 0, 1, 1, 4, "",
             [](auto& library, auto& noise, auto& p, auto* x) {
               return Numbers{fractalNoise(library, noise, p, x, [](Expression n) {
                 const Expression ridge = 1.0 - abs(n);
                 return ridge * ridge;
               })};
             },
             nullptr, 0.5,
             [](auto& noise, auto dimensions, auto) {
               const auto& [magnitude, square] = row(noise.base).means;
               return 1 - 2 * magnitude[dimensions - 1] + square[dimensions - 1];
             }},
    NoiseRow{"turbulence", NoiseUse::Fractal, 1, 0, 1, 1, 4, "",
             [](auto& library, auto& noise, auto& p, auto* x) {
               return Numbers{
                   fractalNoise(library, noise, p, x, [](Expression n) { return abs(n); })};
             },
             nullptr, 0.5,
             [](auto& noise, auto dimensions, auto) {
               return row(noise.base).means.magnitude[dimensions - 1];
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

// Returns the kind with that name. An unknown name doesn't compile.
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
