// The noise functions, each as nodes: `p` is a point, `seed` a hash, and one value leaves unless
// said otherwise.
#pragma once

#include "functions/library.hpp"
#include "noise/noise.hpp"

namespace warpjet {

// Whole numbers may be told apart from the rest, so that float32 keeps where in its cell it is.
struct Point : Numbers {
  Numbers cells;  // as many, or none

  // From the cell of coordinate `i` as far as the rest tells it.
  Expression cell(std::size_t i, Expression found) const {
    return cells.size() > 0 ? found + cells[i] : found;
  }
};

// Perlin's gradient noise, "Improving Noise" (2002), with random directions of length 1 at the
// corners of a grid and his fifth-degree blend: twice continuously differentiable, 0 at the
// corners, from -1 to 1.
Expression gradientNoise(Library& library, const Point& p, Expression seed);
// Above what the size of each first derivative can be, in so many dimensions.
double steepestGradientNoise(int dimensions);

// A random number at each corner, blended alike; from -1 to 1.
Expression valueNoise(Library& library, const Point& p, Expression seed);
double steepestValueNoise();

// Simplex noise (Perlin, "Noise hardware", 2001; Gustavson, "Simplex noise demystified", 2005) with
// kernels that end where their simplices do, three times continuously differentiable; from -1 to 1.
Expression simplexNoise(Library& library, const Numbers& p, Expression seed);
double steepestSimplexNoise(int dimensions);

// The distances to the nearest and to the second nearest of points strewn one a cell (Worley, "A
// cellular texture basis function", 1996): two values.
Numbers worleyNoise(const Point& p, Expression seed);

// The curl of three noises of kind `base`, a vector field without divergence (Bridson, Hourihan,
// Nordenstam, "Curl-noise for procedural fluid flow", 2007, equation 1): three values. A fourth
// coordinate is time.
Numbers curlNoise(Library& library, NoiseKind base, const Point& p, Expression seed);

// Octaves of a noise, each `lacunarity` times as fine and `gain` times as strong as the one before:
// their sum, from -1 to 1; of their absolute values, from 0 to 1 (Perlin, "An image synthesizer",
// 1985); or of the squares of what these lack to 1, from 0 to 1 (after Musgrave's ridged
// multifractal, "Texturing and Modeling", chapter 16). Divided by the sum of all strengths.
// `shaped` is done to each octave; the parameters are a hash, lacunarity and gain.
Expression fractalNoise(Library& library, const Noise& noise, const Point& p,
                        const Expression* parameters, Expression (*shaped)(Expression));

// A call of a noise of one value.
Expression callBase(Library& library, NoiseKind base, const Point& p, Expression seed);

}  // namespace warpjet
