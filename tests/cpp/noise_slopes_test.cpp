// The slopes of noise: its derivatives at random points, compared with the bounds in src/noise.
#include <gtest/gtest.h>

#include <random>

#include "eval/program.hpp"
#include "noise/table.hpp"
#include "sanitized.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

// Returns the largest first derivative that is found at random points. The derivatives are those of
// the noise's body: unlike those of its calls, they aren't clamped.
double steepestFound(Library& library, const Definition& definition, int points) {
  const Function& function = definition.function;
  Body& body = library.withoutCalls(function.name, 1);
  const auto compiled = program(body.graph, body.withoutCalls);
  EXPECT_TRUE(compiled);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-300, 300);
  std::vector<double> arguments(static_cast<std::size_t>(function.arity)),
      results(body.withoutCalls.size());
  double steepest = 0;
  for (int point = 0; point < points; ++point) {
    for (double& x : arguments) x = coordinate(random);
    arguments.back() = point % 4091;
    evaluate(compiled->words, compiled->instructions, arguments, results);
    for (std::size_t i = static_cast<std::size_t>(function.values); i < results.size(); ++i)
      steepest = std::max(steepest, std::abs(results[i]));
  }
  return steepest;
}

TEST(NoiseSlopes, StayWithinTheirBounds) {
  for (const NoiseRow& row : noises) {
    if (row.maxSlope == nullptr) continue;
    const NoiseKind kind = static_cast<NoiseKind>(&row - noises.data());
    for (int dimensions = row.minDimensions; dimensions <= row.maxDimensions; ++dimensions) {
      Graph graph;
      Library library;
      const Definition definition = definitionOf({kind}, dimensions);
      Numbers arguments;
      while (arguments.size() < static_cast<std::size_t>(definition.function.arity))
        arguments.push_back(scalar(graph, "x" + std::to_string(arguments.size())));
      library.call(definition, arguments);
      const int points = kind == noiseNamed("worley") ? 3000 : 20'000;
      const double found = steepestFound(library, definition, isSanitized ? points / 10 : points);
      const std::string name = definition.function.name;
      EXPECT_LE(found, definition.maxSlope) << name;
      EXPECT_GE(found, definition.maxSlope / 5) << name << ": the bound is loose";
      RecordProperty(name, std::to_string(found) + " of " + std::to_string(definition.maxSlope));
    }
  }
}

}  // namespace
}  // namespace warpjet
