#include "functions/fold.hpp"
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

// A loop along each axis. Where each cell stood in the text (SwiftShader, in space, with normals,
// one round side by side on a busy machine, milliseconds): 66,376 characters for 3,769, a first
// draw of 1,126 for 114 in GLSL 3.00 and of 8,859 for 206 in 1.00, frames of 36 for 46 and of 54
// for 81.
class Search {
 public:
  explicit Search(const Point& p) {
    for (const Expression x : p) {
      corner_.push_back(p.cell(corner_.size(), floor(x + 0.5)));
      inside_.push_back(fract(x + 0.5) - 0.5);
    }
  }

  // The squares of the distances to the nearest and to the second nearest, once those in all cells
  // have been met that lie at `steps_` along the axes so far: a loop for each of the other axes.
  Numbers meet(Expression cellHash, const Numbers& before) {
    const std::size_t axis = steps_.size();
    if (axis == inside_.size()) return meetPoint(cellHash, before);
    const Numbers taken = steps_;
    return fold(cells, before, [&](const Numbers& nearest, Expression step) {
      const Expression place = step - cells / 2.0;
      steps_ = taken;
      steps_.push_back(place);
      return meet(hash(cellHash, corner_[axis] + place), nearest);
    });
  }

 private:
  Numbers meetPoint(Expression cellHash, const Numbers& before) const {
    const Expression first = before[0], second = before[1];
    Numbers away = randomNumbers(cellHash, static_cast<int>(steps_.size()));
    for (std::size_t i = 0; i < away.size(); ++i) away[i] = away[i] + steps_[i] - inside_[i];
    const Expression square = dot(away, away);
    return {min(first, square), min(second, max(first, square))};
  }

  Numbers inside_, corner_, steps_;
};

}  // namespace

Numbers worleyNoise(const Point& p, Expression seed) {
  const Expression far{seed.graph, seed.graph->constant(100)};
  const Numbers squares = Search(p).meet(seed, {far, far});
  return {sqrt(squares[0]), sqrt(squares[1])};
}

}  // namespace warpjet
