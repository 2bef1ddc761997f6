// Noise that fades where it is finer than a pixel, compared with the mean of 64 samples of the same
// noise without fading.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "emit/text.hpp"
#include "eval/program.hpp"
#include "noise/table.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

constexpr int dimensions = 3;

// A noise compiled for the CPU: returns its values, and their derivatives.
class CompiledNoise {
 public:
  explicit CompiledNoise(const Definition& definition) : definition_(definition) {
    Graph graph;
    Numbers arguments;
    for (int i = 0; i < definition.function.arity; ++i)
      arguments.push_back(scalar(graph, std::string(definition.argumentName(i))));
    library_.call(definition, arguments);
    Body& body = library_.withoutCalls(definition.function.name, 1);
    program_ = *program(body.graph, body.withoutCalls);
    results_.resize(body.withoutCalls.size());
  }

  // Ignores `pixel` if the noise does not fade.
  const std::vector<double>& at(const std::vector<double>& point, double pixel) {
    std::vector<double> arguments;
    for (int i = 0; i < definition_.function.arity; ++i) {
      const std::string_view name = definition_.argumentName(i);
      if (i < definition_.function.variables) arguments.push_back(point[i]);
      if (name == "pixel") arguments.push_back(pixel);
      if (name == "seed") arguments.push_back(17);
      if (name == "lacunarity") arguments.push_back(2);
      if (name == "gain") arguments.push_back(0.5);
    }
    evaluate(program_.words, program_.instructions, arguments, results_);
    return results_;
  }

 private:
  Definition definition_;
  Library library_;
  Program program_;
  std::vector<double> results_;
};

struct Kind {
  std::string_view name;
  int octaves = 1;
};

constexpr Kind kinds[] = {{"noise"},  {"simplex"},    {"valueNoise"}, {"worley"},
                          {"fbm", 5}, {"turbulence"}, {"ridged"},     {"ridged", 5}};

NoiseKind kindOf(std::string_view name) {
  std::size_t i = 0;
  while (noises[i].name != name) ++i;
  return static_cast<NoiseKind>(i);
}

Definition unfaded(const Kind& kind) {
  return definitionOf({kindOf(kind.name), noiseNamed("noise"), kind.octaves}, dimensions);
}

std::vector<double> randomPoint(std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-100, 100);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

TEST(NoiseFading, DoesNotStartWhileAWaveCoversFourPixels) {
  for (const Kind& kind : kinds) {
    CompiledNoise plain(unfaded(kind)), fading(withFading(unfaded(kind)));
    std::mt19937 random(1);
    const std::vector<double> point = randomPoint(random);
    // The shortest waves are those of five octaves of ridged, 1.37 / 2 / 16. A pixel of 0.0107 is a
    // quarter of that.
    for (const double pixel : {0.0, 0.0107}) EXPECT_EQ(plain.at(point, 0), fading.at(point, pixel));
  }
}

TEST(NoiseFading, LeavesTheMeanWhereAPixelCoversManyWaves) {
  for (const Kind& kind : kinds) {
    CompiledNoise plain(unfaded(kind)), fading(withFading(unfaded(kind)));
    std::mt19937 random(2);
    constexpr int count = 20'000;
    const auto values = static_cast<std::size_t>(unfaded(kind).function.values);
    std::vector<double> sums(values);
    for (int i = 0; i < count; ++i) {
      const std::vector<double>& found = plain.at(randomPoint(random), 0);
      for (std::size_t k = 0; k < values; ++k) sums[k] += found[k] / count;
    }
    const std::vector<double>& far = fading.at(randomPoint(random), 1000);
    for (std::size_t k = 0; k < values; ++k)
      EXPECT_NEAR(far[k], sums[k], 0.006) << kind.name << ' ' << k;
    for (std::size_t k = values; k < far.size(); ++k) EXPECT_EQ(far[k], 0) << kind.name;
  }
}

// Sums of squared errors of the gradient, compared with its mean over a square pixel parallel to x
// and y: of the fading noise, of a single sample of the plain noise, and of zero.
struct Errors {
  double faded = 0, plain = 0, mean = 0;
};

Errors measureErrors(const Kind& kind, double width) {
  CompiledNoise plain(unfaded(kind)), fading(withFading(unfaded(kind)));
  const auto values = static_cast<std::size_t>(unfaded(kind).function.values);
  std::mt19937 random(3);
  Errors errors;
  for (int i = 0; i < 100; ++i) {
    const std::vector<double> point = randomPoint(random);
    std::array<double, 2> mean{};
    for (int sample = 0; sample < 64; ++sample) {
      std::vector<double> near = point;
      near[0] += width * ((sample % 8 + 0.5) / 8 - 0.5);
      near[1] += width * ((sample / 8 + 0.5) / 8 - 0.5);
      const std::vector<double>& found = plain.at(near, 0);
      for (std::size_t k = 0; k < 2; ++k) mean[k] += found[(k + 1) * values] / 64;
    }
    const auto squaredErrorOf = [&](CompiledNoise& noise) {
      const std::vector<double>& found = noise.at(point, width);
      const double x = found[values] - mean[0], y = found[2 * values] - mean[1];
      return x * x + y * y;
    };
    errors.faded += squaredErrorOf(fading);
    errors.plain += squaredErrorOf(plain);
    errors.mean += mean[0] * mean[0] + mean[1] * mean[1];
  }
  return errors;
}

// Noise that faded too little would be no better than a single sample. Noise that faded too much
// would be no better than a flat surface, whose error is the mean itself.
TEST(NoiseFading, IsCloserThanASampleToTheMeanOverAPixel) {
  for (const Kind& kind : kinds) {
    for (const double width : {0.5, 1.0, 1.5, 3.0}) {
      const auto [faded, plain, mean] = measureErrors(kind, width);
      EXPECT_LT(faded, 0.9 * plain) << kind.name << ' ' << width;
      EXPECT_LT(faded, 1.01 * mean) << kind.name << ' ' << width;
    }
  }
}

}  // namespace
}  // namespace warpjet
