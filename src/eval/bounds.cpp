#include "eval/bounds.hpp"

#include <algorithm>
#include <cmath>

#include "eval/interval_program.hpp"

namespace warpjet {

namespace {

constexpr double infinity = Interval::infinity;

// A box is split only if one of its sides is longer than this share of the whole box's side.
constexpr double minShare = 0x1p-24;

// The number of instructions that may still be run.
class Budget {
 public:
  explicit Budget(std::uint64_t instructions) : left_(instructions) {}

  void spend(std::uint64_t instructions) { left_ -= std::min(left_, instructions); }
  std::uint64_t left() const { return left_; }

 private:
  std::uint64_t left_;
};

// Searches for the bounds of one result.
class Search {
 public:
  Search(IntervalProgram& program, std::span<const Interval> inputs, double tolerance,
         Budget& budget)
      : program_(program), tolerance_(tolerance), budget_(budget) {
    for (const std::uint32_t variable : program.variables()) whole_.push_back(inputs[variable]);
    point_.resize(dimensions());
    plain_ = range(whole_);
    if (isNeeded()) sampleCorners();
  }

  // Returns false if the result has no value, or if splitting gains nothing.
  bool isNeeded() const { return !plain_.isEmpty() && dimensions() > 0; }
  Interval plain() const { return plain_; }

  // Returns the upper bound of `sign` times the result; leaves `reserve` of the budget.
  double findUpperBound(double sign, std::uint64_t reserve);

 private:
  struct Entry {
    double bound;
    std::uint32_t box;

    // If bounds are equal, the newer box comes first: it is smaller, so that a pole is reached
    // soon.
    bool operator<(const Entry& other) const {
      return bound != other.bound ? bound < other.bound : box < other.box;
    }
  };

  std::size_t dimensions() const { return whole_.size(); }
  std::span<Interval> box(std::uint32_t i) {
    return std::span(boxes_).subspan(i * dimensions(), dimensions());
  }

  Interval range(std::span<const Interval> box) {
    budget_.spend(program_.cost());
    return program_.range(box);
  }
  double bound(double sign, std::span<const Interval> box) {
    const Interval interval = range(box);
    if (interval.isEmpty()) return -infinity;
    return sign > 0 ? interval.high : -interval.low;
  }

  void sample() {
    budget_.spend(program_.cost());
    const double value = program_.value(point_);
    if (!std::isfinite(value)) return;
    sampled_.low = std::min(sampled_.low, value);
    sampled_.high = std::max(sampled_.high, value);
  }
  void sampleCorners();
  void sampleBox(std::span<const Interval> box);

  // Returns the upper bound, for this sign, at which a box need not be split any more: the best
  // sampled value plus the tolerance.
  double target(double sign) const {
    const double best = sign > 0 ? sampled_.high : -sampled_.low;
    const double size = std::max(std::abs(sampled_.low), std::abs(sampled_.high));
    return best + std::max(tolerance_ * (sampled_.high - sampled_.low), float32Slack * size);
  }
  double share(std::span<const Interval> box, std::size_t i) const {
    return (box[i].high - box[i].low) / (whole_[i].high - whole_[i].low);
  }
  std::size_t axisToSplit(double sign, std::span<Interval> box);

  IntervalProgram& program_;
  double tolerance_;
  Budget& budget_;
  std::vector<Interval> whole_;  // the whole box
  Interval plain_;               // of the whole box, by interval arithmetic
  Interval sampled_;             // the hull of the values at samples
  std::vector<double> point_;
  std::vector<Interval> boxes_;  // `dimensions` intervals per box
};

double middle(const Interval& x) { return 0.5 * x.low + 0.5 * x.high; }

void Search::sampleCorners() {
  const std::size_t axes = std::min<std::size_t>(dimensions(), 4);
  for (std::size_t i = axes; i < dimensions(); ++i) point_[i] = middle(whole_[i]);
  for (std::uint32_t corner = 0; corner < 1u << axes; ++corner) {
    for (std::size_t i = 0; i < axes; ++i)
      point_[i] = corner >> i & 1 ? whole_[i].high : whole_[i].low;
    sample();
  }
}

// Samples the center of a box, and the point where it touches the border of the whole box, since
// extremes are often there.
void Search::sampleBox(std::span<const Interval> box) {
  for (std::size_t i = 0; i < dimensions(); ++i) point_[i] = middle(box[i]);
  sample();
  bool touches = false;
  for (std::size_t i = 0; i < dimensions(); ++i) {
    const bool isLow = box[i].low == whole_[i].low, isHigh = box[i].high == whole_[i].high;
    if (isLow == isHigh) continue;
    point_[i] = isLow ? box[i].low : box[i].high;
    touches = true;
  }
  if (touches) sample();
}

// Returns the axis whose extent widens the result most: if the box is flattened along this axis,
// the bound is smallest.
std::size_t Search::axisToSplit(double sign, std::span<Interval> box) {
  std::size_t best = 0;
  double smallest = infinity;
  for (std::size_t i = 0; i < dimensions(); ++i) {
    const Interval side = box[i];
    if (share(box, i) <= minShare) continue;
    box[i] = middle(side);
    const double flattened = bound(sign, box);
    box[i] = side;
    if (flattened < smallest || (flattened == smallest && share(box, i) > share(box, best))) {
      smallest = flattened;
      best = i;
    }
  }
  return best;
}

double Search::findUpperBound(double sign, std::uint64_t reserve) {
  boxes_ = whole_;
  std::vector<Entry> heap{{sign > 0 ? plain_.high : -plain_.low, 0}};
  double maxDone = -infinity;  // the max bound of the boxes that are good enough
  while (!heap.empty()) {
    const Entry worst = heap.front();
    if (worst.bound <= target(sign) || budget_.left() <= reserve) break;
    std::pop_heap(heap.begin(), heap.end());
    heap.pop_back();
    const std::size_t axis = axisToSplit(sign, box(worst.box));
    if (share(box(worst.box), axis) <= minShare) return std::max(worst.bound, maxDone);

    // The upper half becomes a new box, the lower one replaces the old box.
    const auto half = static_cast<std::uint32_t>(boxes_.size() / dimensions());
    for (std::size_t i = 0; i < dimensions(); ++i) {
      const Interval side = box(worst.box)[i];
      boxes_.push_back(side);
    }
    const double center = middle(box(half)[axis]);
    box(half)[axis].low = box(worst.box)[axis].high = center;
    for (const std::uint32_t child : {worst.box, half}) {
      const double childBound = std::min(worst.bound, bound(sign, box(child)));
      sampleBox(box(child));
      if (childBound <= target(sign)) {
        maxDone = std::max(maxDone, childBound);
      } else {
        heap.push_back({childBound, child});
        std::push_heap(heap.begin(), heap.end());
      }
    }
  }
  return heap.empty() ? maxDone : std::max(maxDone, heap.front().bound);
}

Range withSlack(Interval x) {
  if (x.isEmpty()) return {infinity, -infinity};
  const double slack = float32Slack * std::max(std::abs(x.low), std::abs(x.high));
  if (slack == infinity) return {x.low, x.high};
  return {x.low - slack, x.high + slack};
}

}  // namespace

std::vector<Range> bounds(std::span<const std::uint32_t> words, std::uint32_t instructions,
                          std::span<const Range> inputs, std::span<const std::uint32_t> wanted,
                          const BoundsOptions& options) {
  std::vector<Interval> intervals;
  for (const auto [low, high] : inputs) {
    // Zeros of both signs belong to the range.
    const Interval range{low == 0 ? -0.0 : low, high == 0 ? 0.0 : high};
    intervals.push_back(range.isEmpty() ? Interval::anything(true) : range);
  }
  Budget budget(options.budget);
  std::vector<Range> all;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    IntervalProgram program(Words(words, instructions), intervals, wanted[i]);
    Search search(program, intervals, options.tolerance, budget);
    Interval range = search.plain();
    if (search.isNeeded()) {
      // Each bound of each result has its share of the budget, plus what earlier ones did not use.
      const std::uint64_t sides = 2 * (wanted.size() - i), share = budget.left() / sides;
      range.high = search.findUpperBound(1, budget.left() - share);
      range.low = -search.findUpperBound(-1, budget.left() - budget.left() / (sides - 1));
    }
    all.push_back(withSlack(range));
  }
  return all;
}

}  // namespace warpjet
