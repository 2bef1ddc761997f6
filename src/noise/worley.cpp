#include "noise/bodies.hpp"
#include "noise/random.hpp"

namespace warpjet {

namespace {

// The four cells nearest to the point along each axis. What lies beyond is at least 1.5 away, and
// some point of the 2^n cells that are nearest is at most √n away, √2 on a plane. In space all
// eight nearest points would have to lie in a hundredth of their cells for the nearest to jump,
// once in 10^16 places; for the second nearest seven of them would, or all but one of those around
// a cell.
constexpr int cells = 4;

class Search {
 public:
  Search(const Numbers& p, Expression seed)
      : inside_(), corner_(), first_(far(seed)), second_(far(seed)) {
    for (const Expression x : p) {
      corner_.push_back(floor(x + 0.5));
      inside_.push_back(fract(x + 0.5) - 0.5);
    }
    visit(seed);
  }

  Numbers distances() const { return {sqrt(first_), sqrt(second_)}; }

 private:
  static Expression far(Expression seed) { return {seed.graph, seed.graph->constant(100)}; }

  // All cells that lie at `steps_` along the axes so far.
  void visit(Expression cellHash) {
    const std::size_t axis = depth_;
    if (axis == inside_.size()) return meet(cellHash);
    for (int step = -cells / 2; step < cells / 2; ++step) {
      steps_[depth_++] = step;
      visit(hash(cellHash, corner_[axis] + static_cast<double>(step)));
      --depth_;
    }
  }

  void meet(Expression cellHash) {
    Numbers away = randomNumbers(cellHash, static_cast<int>(depth_));
    for (std::size_t i = 0; i < away.size(); ++i) away[i] = away[i] + steps_[i] - inside_[i];
    const Expression square = dot(away, away);
    second_ = min(second_, max(first_, square));
    first_ = min(first_, square);
  }

  Numbers inside_, corner_;
  double steps_[3] = {};  // as many as `depth_`
  std::size_t depth_ = 0;
  Expression first_, second_;  // squares of distances
};

}  // namespace

Numbers worleyNoise(const Numbers& p, Expression seed) { return Search(p, seed).distances(); }

}  // namespace warpjet
