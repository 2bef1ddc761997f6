#include "eval/slope_jumps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "eval/program.hpp"

namespace warpjet {

namespace {

using Values = std::vector<double>;

// The max sizes of inputs that vary: a mesh may have the size of a unit or of a picture, and a kink
// may be flattened everywhere but far from the origin.
constexpr std::array sizes{1.0, 10.0, 100.0, 1000.0};
constexpr int linesPerSize = 12;

// Longer programs take too long.
constexpr std::uint32_t maxInstructions = 10'000;

// The distance of the points that are compared, as a share of the line.
constexpr double reach = 1e-6;
// The min jump, as a share of the slope: half a degree.
constexpr double minJump = 0.01;

// Arbitrary numbers from -1 to 1, always the same ones (Numerical Recipes, section 7.1).
class RandomNumbers {
 public:
  double next() {
    state_ = state_ * 1664525u + 1013904223u;
    return static_cast<double>(state_) / 0x1p31 - 1;
  }

 private:
  std::uint32_t state_ = 1;
};

// The results of a module, followed by the numbers of its kinks, along a line through its inputs.
class Line {
 public:
  Line(const Program& program, std::size_t count, Values start, Values end)
      : program_(program), start_(std::move(start)), end_(std::move(end)), count_(count) {}

  Values at(double share) const {
    Values inputs(start_.size()), found(count_);
    for (std::size_t i = 0; i < inputs.size(); ++i)
      inputs[i] = start_[i] + share * (end_[i] - start_[i]);
    evaluate(program_.words, program_.instructions, inputs, found);
    return found;
  }

  // Returns where number i passes a limit, given its distances from it at both ends of the line: by
  // the regula falsi, with each third point in the middle, so that no end stays far away.
  double crossing(std::size_t i, double limit, double atStart, double atEnd) const {
    double low = 0, high = 1;
    for (int k = 0; k < 60 && high - low > 1e-13; ++k) {
      const double share = k % 3 == 2 ? 0.5 : atStart / (atStart - atEnd);
      const double middle = low + share * (high - low), found = at(middle)[i] - limit;
      if (found == 0 || middle <= low || middle >= high) return middle;
      const bool isBefore = (found > 0) == (atStart > 0);
      (isBefore ? low : high) = middle;
      (isBefore ? atStart : atEnd) = found;
    }
    return high;
  }

  // Tests whether the slope of the first `results` numbers jumps; empty if any isn't finite. Second
  // differences are jump * h + curvature * h^2 for a distance of h, so that two distances yield the
  // jump.
  std::optional<bool> jumpsAt(double share, std::size_t results) const {
    const Values middle = at(share);
    const std::array far{at(share - reach), at(share + reach)};
    const std::array near{at(share - reach / 2), at(share + reach / 2)};
    double squaredJump = 0, squaredSlope = 0;
    for (std::size_t i = 0; i < results; ++i) {
      const double wide = far[0][i] + far[1][i] - 2 * middle[i];
      const double narrow = near[0][i] + near[1][i] - 2 * middle[i];
      const double jump = 4 * narrow - wide, slope = 0.5 * (far[1][i] - far[0][i]);
      squaredJump += jump * jump;
      squaredSlope += slope * slope;
    }
    if (!std::isfinite(squaredJump + squaredSlope)) return std::nullopt;
    return squaredJump > minJump * minJump * squaredSlope;
  }

 private:
  const Program& program_;
  Values start_, end_;
  std::size_t count_;
};

// Makes random lines. Inputs that don't vary are from 0.5 to 1.5, or for every other line as large
// as those that do.
class RandomLines {
 public:
  RandomLines(const Graph& graph, std::span<const std::uint32_t> varying) {
    for (std::uint32_t i = 0; i < graph.inputCount(); ++i) {
      const Shape shape = graph.input(i).shape;
      if (shape == imageShape) continue;
      const bool varies = std::find(varying.begin(), varying.end(), i) != varying.end();
      varies_.insert(varies_.end(), static_cast<std::size_t>(shape.size()), varies);
    }
  }

  Line next(const Program& program, std::size_t count, double size) {
    hasLargeUniforms_ = !hasLargeUniforms_;
    std::array<Values, 2> ends;
    for (const bool varies : varies_) {
      const double uniform = (hasLargeUniforms_ ? size : 1) * (1 + 0.5 * numbers_.next());
      for (Values& end : ends) end.push_back(varies ? size * numbers_.next() : uniform);
    }
    return {program, count, std::move(ends[0]), std::move(ends[1])};
  }

 private:
  std::vector<bool> varies_;
  bool hasLargeUniforms_ = true;
  RandomNumbers numbers_;
};

// Compiles the results, followed by the numbers of the kinks.
std::optional<Program> compile(Module& module, std::vector<NodeId> numbers) {
  module.outputs.push_back({.name = "kinks", .shape = {}, .components = std::move(numbers)});
  const std::array all{static_cast<std::uint32_t>(module.outputs.size() - 1)};
  std::optional<Program> made = program(module, all).program;
  module.outputs.pop_back();
  return made && made->instructions <= maxInstructions ? std::move(made) : std::nullopt;
}

}  // namespace

void removeSmooth(std::vector<FrontAt>& kinks, Module& module,
                  std::span<const std::uint32_t> results, std::span<const std::uint32_t> varying) {
  std::vector<NodeId> numbers = module.roots(results);
  const std::size_t resultCount = numbers.size();
  for (const FrontAt& kink : kinks) numbers.push_back(kink.argument);
  const std::size_t count = numbers.size();
  const std::optional<Program> program = compile(module, std::move(numbers));
  if (!program) return;
  enum class Slope : std::uint8_t { Unknown, Smooth, Jumps };
  std::vector<Slope> slopes(kinks.size(), Slope::Unknown);
  RandomLines lines(module.graph, varying);
  for (const double size : sizes) {
    for (int i = 0; i < linesPerSize; ++i) {
      const Line line = lines.next(*program, count, size);
      const Values start = line.at(0), end = line.at(1);
      for (std::size_t k = 0; k < kinks.size(); ++k) {
        const auto& [profile, limit, isStill] = kinks[k].front;
        const std::size_t number = resultCount + k;
        const double atStart = start[number] - limit, atEnd = end[number] - limit;
        if (profile != Profile::Kink || slopes[k] == Slope::Jumps || !(atStart * atEnd < 0))
          continue;
        const double crossing = line.crossing(number, limit, atStart, atEnd);
        if (const auto jumps = line.jumpsAt(crossing, resultCount))
          slopes[k] = *jumps ? Slope::Jumps : Slope::Smooth;
      }
    }
  }
  std::vector<FrontAt> kept;
  for (std::size_t k = 0; k < kinks.size(); ++k) {
    if (slopes[k] != Slope::Smooth) kept.push_back(kinks[k]);
  }
  kinks = std::move(kept);
}

}  // namespace warpjet
