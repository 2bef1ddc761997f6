#include "noise/bodies.hpp"
#include "noise/random.hpp"

namespace warpjet {

namespace {

// Octaves must not meet where all of them are 0, at whole coordinates: each is moved on by this.
constexpr double shifts[] = {0.6180339887498949, 0.7548776662466927, 0.8191725133961645,
                             0.8566748838545029};

}  // namespace

Expression fractalNoise(Library& library, const Noise& noise, const Numbers& p,
                        const Expression* parameters, Expression (*shaped)(Expression)) {
  const Expression seed = parameters[0], lacunarity = parameters[1], gain = parameters[2];
  const Expression one{seed.graph, seed.graph->constant(1)};
  Expression fineness = one, strength = one;
  Expression total = shaped(callBase(library, noise.base, p, seed)), strengths = one;
  for (int octave = 1; octave < noise.octaves; ++octave) {
    fineness = fineness * lacunarity;
    strength = strength * gain;
    Numbers moved;
    for (std::size_t i = 0; i < p.size(); ++i)
      moved.push_back(p[i] * fineness + octave * shifts[i]);
    const Expression finer = callBase(library, noise.base, moved, hash(seed, octave));
    total = total + shaped(finer) * strength;
    strengths = strengths + strength;
  }
  return total / strengths;
}

}  // namespace warpjet
