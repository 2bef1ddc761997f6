#include "eval/slope_jumps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "eval/program.hpp"

namespace warpjet {

namespace {

using Numbers = std::vector<double>;

// The max sizes of inputs that vary: a mesh may have the size of a unit or of a picture.
constexpr std::array sizes{1.0, 10.0, 100.0, 1000.0};
constexpr int linesPerSize = 12;
// A kink that is smooth on this many lines is no kink.
constexpr int maxSmooth = 3;

// The distance of the points that are compared, as a share of the line.
constexpr double reach = 1e-6;
// The min jump, as a share of the slope: half a degree.
constexpr double minJump = 0.01;

// Returns arbitrary numbers from -1 to 1, always the same ones (Numerical Recipes, section 7.1).
class Arbitrary {
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
  Line(const Program& program, std::size_t count, Numbers start, Numbers end)
      : program_(program), count_(count), start_(std::move(start)), end_(std::move(end)) {}

  Numbers at(double share) const {
    Numbers inputs(start_.size()), found(count_);
    for (std::size_t i = 0; i < inputs.size(); ++i)
      inputs[i] = start_[i] + share * (end_[i] - start_[i]);
    evaluate(program_.words, program_.instructions, inputs, found);
    return found;
  }

  // Returns where a number passes a limit; empty if it has the same sign at both ends.
  std::optional<double> crossing(std::size_t number, double limit) const {
    double low = 0, high = 1;
    const auto isAbove = [&](double share) { return at(share)[number] > limit; };
    const bool startsAbove = isAbove(low);
    if (isAbove(high) == startsAbove) return std::nullopt;
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (low + high);
      (isAbove(middle) == startsAbove ? low : high) = middle;
    }
    return high;
  }

  // Tests whether the slope of the first `results` numbers jumps. Second differences are
  // jump * h + curvature * h^2 for a distance of h, so that two distances yield the jump.
  std::optional<bool> jumpsAt(double share, std::size_t results) const {
    const Numbers middle = at(share);
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
  std::size_t count_;
  Numbers start_, end_;
};

// Makes inputs of a program. Those that don't vary are from 0.5 to 1.5.
class Lines {
 public:
  Lines(const Graph& graph, std::span<const std::uint32_t> varying) {
    for (std::uint32_t i = 0; i < graph.inputCount(); ++i) {
      const Shape shape = graph.input(i).shape;
      if (shape == imageShape) continue;
      const bool varies = std::find(varying.begin(), varying.end(), i) != varying.end();
      varies_.insert(varies_.end(), static_cast<std::size_t>(shape.size()), varies);
    }
  }

  Line make(const Program& program, std::size_t count, double size) {
    std::array<Numbers, 2> ends;
    for (const bool varies : varies_) {
      const double uniform = 1 + 0.5 * numbers_.next();
      for (Numbers& end : ends) end.push_back(varies ? size * numbers_.next() : uniform);
    }
    return {program, count, std::move(ends[0]), std::move(ends[1])};
  }

 private:
  std::vector<bool> varies_;
  Arbitrary numbers_;
};

}  // namespace

void removeSmooth(std::vector<FrontAt>& kinks, Module& module,
                  std::span<const std::uint32_t> results, std::span<const std::uint32_t> varying) {
  if (kinks.empty()) return;
  Output numbers{.name = "kinks", .shape = {}, .components = module.roots(results)};
  const std::size_t resultCount = numbers.components.size();
  for (const FrontAt& kink : kinks) numbers.components.push_back(kink.argument);
  const std::size_t count = numbers.components.size();
  module.outputs.push_back(std::move(numbers));
  const std::array all{static_cast<std::uint32_t>(module.outputs.size() - 1)};
  const std::optional<Program> made = program(module, all).program;
  module.outputs.pop_back();
  if (!made) return;
  std::vector<int> smooth(kinks.size()), jumps(kinks.size());
  Lines lines(module.graph, varying);
  for (const double size : sizes) {
    for (int i = 0; i < linesPerSize; ++i) {
      const Line line = lines.make(*made, count, size);
      for (std::size_t k = 0; k < kinks.size(); ++k) {
        const auto& [profile, limit, _] = kinks[k].front;
        if (profile != Profile::Kink || jumps[k] > 0 || smooth[k] >= maxSmooth) continue;
        const std::optional<double> crossing = line.crossing(resultCount + k, limit);
        const std::optional<bool> isJump =
            crossing ? line.jumpsAt(*crossing, resultCount) : std::nullopt;
        if (!isJump) continue;
        (*isJump ? jumps : smooth)[k]++;
      }
    }
  }
  std::vector<FrontAt> kept;
  for (std::size_t k = 0; k < kinks.size(); ++k) {
    if (jumps[k] > 0 || smooth[k] == 0) kept.push_back(kinks[k]);
  }
  kinks = std::move(kept);
}

}  // namespace warpjet
