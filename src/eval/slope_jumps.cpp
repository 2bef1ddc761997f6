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
// may be flattened everywhere but far from the origin. On each line, each input has a share of it
// instead, since it may be flattened everywhere but close to an axis.
constexpr std::array sizes{1.0, 10.0, 100.0, 1000.0};
constexpr std::array shares{1.0, 0.1, 0.01};
constexpr int linesPerSize = 12;

// Longer programs take too long, and so do more instructions in all: these take about 0.1 s.
constexpr std::uint32_t maxInstructions = 10'000;
constexpr std::uint64_t maxExecuted = 20'000'000;

// The distance of the points that are compared, as a share of the line.
constexpr double reach = 1e-7;
// The min jump, as a share of the slope: half a degree. A jump of less than `maxSmooth`, or than
// the rounding error of a difference of results, is none; one in between may be larger elsewhere.
constexpr double minJump = 0.01;
constexpr double maxSmooth = 1e-5;
constexpr double rounding = 1e-14;

// Arbitrary numbers from -1 to 1, always the same ones (Numerical Recipes, section 7.1).
class RandomNumbers {
 public:
  double next() {
    state_ = state_ * 1664525u + 1013904223u;
    return static_cast<double>(state_) / 0x1p31 - 1;
  }
  // Returns one of these numbers.
  double choose(std::span<const double> numbers) {
    const double part = (next() + 1) / 2;
    return numbers[static_cast<std::size_t>(part * static_cast<double>(numbers.size()))];
  }

 private:
  std::uint32_t state_ = 1;
};

// The slope as one line shows it. A larger value outweighs those of other lines.
enum class Slope : std::uint8_t { NotReached, Smooth, Unclear, Jumps };

// The results of a module, followed by the arguments of its kinks, along a line through its inputs.
class Line {
 public:
  Line(const Program& program, std::size_t count, Values start, Values end)
      : program_(program), start_(std::move(start)), end_(std::move(end)), count_(count) {}

  Values at(double t) const {
    Values inputs(start_.size()), outputs(count_);
    for (std::size_t i = 0; i < inputs.size(); ++i)
      inputs[i] = start_[i] + t * (end_[i] - start_[i]);
    evaluate(program_.words, program_.instructions, inputs, outputs);
    executed_ += program_.instructions;
    return outputs;
  }

  // The number of instructions that were executed for this line.
  std::uint64_t executed() const { return executed_; }

  // Returns where number i passes a limit, given its distances from it at both ends of the line: by
  // the regula falsi, with each third point in the middle, so that no end stays far away.
  double crossing(std::size_t i, double limit, double atStart, double atEnd) const {
    double low = 0, high = 1;
    for (int k = 0; k < 60 && high - low > 1e-13; ++k) {
      const double fraction = k % 3 == 2 ? 0.5 : atStart / (atStart - atEnd);
      const double middle = low + fraction * (high - low), found = at(middle)[i] - limit;
      if (found == 0 || middle <= low || middle >= high) return middle;
      const bool isBefore = (found > 0) == (atStart > 0);
      (isBefore ? low : high) = middle;
      (isBefore ? atStart : atEnd) = found;
    }
    return high;
  }

  // Tests whether the slope of the first `results` numbers jumps at t. Second differences are jump
  // * h + a * h^2 + b * h^3 for a distance of h, so that three distances yield the jump.
  Slope slopeAt(double t, std::size_t results) const {
    const Values middle = at(t);
    const auto around = [&](double h) { return std::array{at(t - h), at(t + h)}; };
    const auto far = around(reach), half = around(reach / 2), near = around(reach / 4);
    double squaredJump = 0, squaredSlope = 0, squaredError = 0;
    for (std::size_t i = 0; i < results; ++i) {
      const auto difference = [&](const std::array<Values, 2>& sides) {
        return sides[0][i] + sides[1][i] - 2 * middle[i];
      };
      const double first = 4 * difference(half) - difference(far);
      const double second = 4 * difference(near) - difference(half);
      const double jump = (8 * second - first) / 3, slope = 0.5 * (far[1][i] - far[0][i]);
      squaredJump += jump * jump;
      squaredSlope += slope * slope;
      squaredError += rounding * rounding * middle[i] * middle[i];
    }
    if (!std::isfinite(squaredJump + squaredSlope)) return Slope::NotReached;
    if (squaredJump <= maxSmooth * maxSmooth * squaredSlope + squaredError) return Slope::Smooth;
    return squaredJump > minJump * minJump * squaredSlope ? Slope::Jumps : Slope::Unclear;
  }

 private:
  const Program& program_;
  Values start_, end_;
  std::size_t count_;
  mutable std::uint64_t executed_ = 0;
};

// Makes random lines. Inputs that don't vary are around 0, 1 or the size of those that do, with
// either sign, since a kink may depend on them.
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
    const std::array uniforms{0.0, 1.0, -1.0, size, -size};
    std::array<Values, 2> ends;
    for (const bool varies : varies_) {
      const double scale = varies ? size * numbers_.choose(shares) : numbers_.choose(uniforms);
      const double uniform = scale * (1 + 0.5 * numbers_.next());
      for (Values& end : ends) end.push_back(varies ? scale * numbers_.next() : uniform);
    }
    return {program, count, std::move(ends[0]), std::move(ends[1])};
  }

 private:
  std::vector<bool> varies_;
  RandomNumbers numbers_;
};

// Compiles nodes as the only result of a program.
std::optional<Program> compile(Module& module, std::vector<NodeId> nodes) {
  module.outputs.push_back({.name = "kinks", .shape = {}, .components = std::move(nodes)});
  const std::array all{static_cast<std::uint32_t>(module.outputs.size() - 1)};
  std::optional<Program> made = program(module, all).program;
  module.outputs.pop_back();
  return made && made->instructions <= maxInstructions ? std::move(made) : std::nullopt;
}

}  // namespace

void removeSmoothKinks(std::vector<FrontAt>& kinks, Module& module,
                       std::span<const std::uint32_t> results,
                       std::span<const std::uint32_t> varying) {
  std::vector<NodeId> nodes = module.roots(results);
  const std::size_t resultCount = nodes.size();
  for (const FrontAt& kink : kinks) nodes.push_back(kink.argument);
  const std::size_t count = nodes.size();
  const std::optional<Program> program = compile(module, std::move(nodes));
  if (!program) return;
  std::vector<Slope> slopes(kinks.size(), Slope::NotReached);
  std::uint64_t executed = 0;
  RandomLines lines(module.graph, varying);
  for (int i = 0; i < linesPerSize; ++i) {
    for (const double size : sizes) {
      const Line line = lines.next(*program, count, size);
      const Values start = line.at(0), end = line.at(1);
      for (std::size_t k = 0; k < kinks.size() && executed + line.executed() < maxExecuted; ++k) {
        const Front& front = kinks[k].front;
        const std::size_t argument = resultCount + k;
        const double atStart = start[argument] - front.first, atEnd = end[argument] - front.first;
        // A cusp has only one side.
        if (front.profile != Profile::Kink || slopes[k] == Slope::Jumps || !(atStart * atEnd < 0))
          continue;
        const double t = line.crossing(argument, front.first, atStart, atEnd);
        slopes[k] = std::max(slopes[k], line.slopeAt(t, resultCount));
      }
      executed += line.executed();
    }
  }
  std::vector<FrontAt> kept;
  for (std::size_t k = 0; k < kinks.size(); ++k) {
    if (slopes[k] != Slope::Smooth) kept.push_back(kinks[k]);
  }
  kinks = std::move(kept);
}

}  // namespace warpjet
