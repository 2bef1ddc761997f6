#include "functions/fold.hpp"
#include "noise/bodies.hpp"
#include "noise/random.hpp"
#include "noise/table.hpp"

namespace warpjet {

namespace {

// Octaves are shifted against each other, as all of them are 0 at integer coordinates.
constexpr double shifts[] = {0.6180339887498949, 0.7548776662466927, 0.8191725133961645,
                             0.8566748838545029};

}  // namespace

// Returns a loop of octaves, the first of which is the unshifted noise. The alternative is to write
// out each octave. This compares both, for warps with normals and 5 octaves of 3D noise, in
// milliseconds of the first draw, and of a later frame of 14,000 vertices (SwiftShader, medians of
// 3 rounds side by side on a busy machine):
//
//                                  every octave        a loop
//   fbm, GLSL 3.00                  1878    55        641   108
//   fbm, GLSL 1.00                  7079    91       1140    85
//   nested fbm, 3 deep, GLSL 3.00   6940   156       1560   143
//
// So later frames of a single fbm in GLSL 3.00 become slower, by half in a second measurement, but
// the first frame is more than a second faster.
Expression fractalNoise(Library& library, const Noise& noise, const Point& p,
                        const Expression* parameters, Expression (*shape)(Expression)) {
  const Expression seed = parameters[0], lacunarity = parameters[1], gain = parameters[2];
  const NoiseRow& kind = row(noise.kind);
  const double mean = kind.mean(noise, p.size(), 0);
  const double wavelength = kind.wavelength * row(noise.base).wavelength;
  // Returns an octave. The octave fades, not its base: the mean of |n| is not |the mean of n|.
  const auto octaveAt = [&](const Point& moved, Expression octaveSeed, Expression fineness) {
    const Expression value = shape(callBase(library, noise.base, moved, octaveSeed));
    return p.pixel ? fade(value, mean, *p.pixel * fineness, wavelength) : value;
  };
  Graph& graph = *seed.graph;
  const Expression zero{&graph, graph.constant(0)}, one{&graph, graph.constant(1)};
  if (noise.octaves == 1) return octaveAt({p, p.cells}, seed, one);
  const auto step = [&](const Numbers& states, Expression octave) {
    const Expression total = states[0], strengths = states[1];
    const Expression fineness = states[2], strength = states[3];
    Point moved;
    for (std::size_t i = 0; i < p.size(); ++i)
      moved.push_back(p[i] * fineness + octave * shifts[i]);
    for (const Expression cell : p.cells) moved.cells.push_back(cell * fineness);
    const Expression octaveSeed = ifElse(gt(octave, 0.0), hash(seed, octave), seed);
    const Expression value = octaveAt(moved, octaveSeed, fineness);
    return Numbers{total + value * strength, strengths + strength, fineness * lacunarity,
                   strength * gain};
  };
  const Numbers sums =
      fold(static_cast<std::uint32_t>(noise.octaves), {zero, zero, one, one}, step);
  return sums[0] / sums[1];
}

}  // namespace warpjet
