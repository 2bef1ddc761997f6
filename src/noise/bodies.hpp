// The noise functions as nodes: `p` is a point, `seed` a hash. They return one value unless their
// comment says otherwise.
#pragma once

#include <optional>

#include "functions/library.hpp"
#include "noise/noise.hpp"

namespace warpjet {

// A point whose coordinates may be split into integer cells and remainders, so that float32 keeps
// the position within the cell precise.
struct Point : Numbers {
  Numbers cells;  // one per coordinate, or empty
  // The width of a pixel, for noise that fades.
  std::optional<Expression> pixel = {};

  // Returns the cell of coordinate `i`, given the cell of its remainder.
  Expression cell(std::size_t i, Expression ofRemainder) const {
    return cells.size() > 0 ? ofRemainder + cells[i] : ofRemainder;
  }
};

// Returns Perlin's gradient noise, "Improving Noise" (2002), with random unit vectors at the
// corners of a grid and his fifth-degree blend: twice continuously differentiable, 0 at the
// corners, from -1 to 1.
Expression gradientNoise(Library& library, const Point& p, Expression seed);
// Returns an upper bound of the magnitude of each first derivative, by dimension.
double maxSlopeOfGradientNoise(int dimensions);

// Blends a random number per corner with the same weights; from -1 to 1.
Expression valueNoise(Library& library, const Point& p, Expression seed);
double maxSlopeOfValueNoise();

// Returns simplex noise (Perlin, "Noise hardware", 2001; Gustavson, "Simplex noise demystified",
// 2005) with kernels whose support ends with their simplices, three times continuously
// differentiable; from -1 to 1.
Expression simplexNoise(Library& library, const Numbers& p, Expression seed);
double maxSlopeOfSimplexNoise(int dimensions);

// Returns the distances to the nearest and to the second nearest of random points, one per cell
// (Worley, "A cellular texture basis function", 1996): two values.
Numbers worleyNoise(const Point& p, Expression seed);

// Returns the curl of three noises of kind `base`, a divergence-free vector field (Bridson,
// Hourihan, Nordenstam, "Curl-noise for procedural fluid flow", 2007, equation 1): three values. A
// fourth coordinate is time.
Numbers curlNoise(Library& library, NoiseKind base, const Point& p, Expression seed);

// Sums octaves of a noise, each `lacunarity` times as fine and `gain` times as strong as the
// preceding one, and divides by the sum of all strengths. `shape` is applied to each octave n: n,
// from -1 to 1; |n|, from 0 to 1 (Perlin, "An image synthesizer", 1985); or (1 - |n|)², from 0 to 1
// (after Musgrave's ridged multifractal, "Texturing and Modeling", chapter 16). The parameters are
// a hash, lacunarity and gain.
Expression fractalNoise(Library& library, const Noise& noise, const Point& p,
                        const Expression* parameters, Expression (*shape)(Expression));

// Blends a value toward its mean where `pixel` is wider than a quarter of `wavelength`; both are in
// the units of the point.
Expression fade(Expression value, double mean, Expression pixel, double wavelength);

// Calls a noise with a single value.
Expression callBase(Library& library, NoiseKind base, const Point& p, Expression seed);

}  // namespace warpjet
