#include "noise/random.hpp"

#include <string>

namespace warpjet {

namespace {

// Products of a hash below 2^12 and these factors are below 2^24, and their quotient by 4096 is
// exact in float. The factors are 4096 over powers of the golden ratio and of its analog in three
// dimensions, the real root of x³ = x + 1 (Roberts, "The Unreasonable Effectiveness of Quasirandom
// Sequences", 2018), rounded to odd numbers.
constexpr double denominator = 4096;
constexpr double factorsOfTwo[] = {1, 2531}, factorsOfThree[] = {1, 3091, 2333};

// Folds a cube onto the surface of the polytope with its corners on the axes, as in McEwan, Sheets,
// Richardson and Gustavson, "Efficient Computational Noise in GLSL" (2012), section 5, and
// normalizes the result.
Numbers directionFromCube(Expression hash, int dimensions) {
  Numbers v = randomNumbers(hash, dimensions - 1);
  Expression last{hash.graph, hash.graph->constant(0.5 * (dimensions - 1))};
  for (Expression& x : v) {
    x = x * 2.0 - 1.0;
    last = last - abs(x);
  }
  for (Expression& x : v) x = ifElse(lt(last, 0.0), x - sign(x), x);
  v.push_back(last);
  const Expression shorten = inversesqrt(dot(v, v));
  for (Expression& x : v) x = x * shorten;
  return v;
}

}  // namespace

Numbers randomNumbers(Expression hash, int count) {
  const double* factors = count < 3 ? factorsOfTwo : factorsOfThree;
  Numbers numbers;
  for (int i = 0; i < count; ++i) numbers.push_back(fract(hash * (factors[i] / denominator)));
  return numbers;
}

Numbers randomDirection(Library& library, Expression hash, int dimensions) {
  if (dimensions == 1) return {randomNumbers(hash, 1)[0] * 2.0 - 1.0};
  const Definition direction{{"warpjetDirection" + std::to_string(dimensions), 1, dimensions, 0},
                             [](Library&, std::uint32_t count, const Numbers& arguments) {
                               return directionFromCube(arguments[0], static_cast<int>(count));
                             },
                             static_cast<std::uint32_t>(dimensions)};
  return library.call(direction, {hash});
}

}  // namespace warpjet
