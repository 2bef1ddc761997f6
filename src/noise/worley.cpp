#include "functions/fold.hpp"
#include "noise/bodies.hpp"
#include "noise/random.hpp"

namespace warpjet {

namespace {

// The number of cells that are searched along each axis: those nearest to the point. In n
// dimensions, random points in other cells are at least 1.5 away, and some random point in the 2^n
// nearest cells is at most √n away. In 2D that is √2, so the nearest distance is always exact.
//
// In 3D, the nearest distance is wrong only if the random points of all eight nearest cells are in
// a certain hundredth of their cells, once in 10^16 places. The second nearest distance is wrong
// only if the points of seven of these cells are in such a hundredth, or all points but one around
// a cell.
constexpr int cells = 4;

// Searches by a loop along each axis. If each cell is written out instead, frames are faster, but
// the first draw is far slower (SwiftShader, 3D, with normals, one round side by side on a busy
// machine):
//
//                                    loops    written out
//   code, characters                 3,769         66,376
//   first draw, GLSL 3.00, ms          114          1,126
//   first draw, GLSL 1.00, ms          206          8,859
//   frame, GLSL 3.00, ms                46             36
//   frame, GLSL 1.00, ms                81             54
class Search {
 public:
  explicit Search(const Point& p) {
    for (const Expression x : p) {
      corner_.push_back(p.cell(corner_.size(), floor(x + 0.5)));
      inside_.push_back(fract(x + 0.5) - 0.5);
    }
  }

  // Updates the squared distances to the nearest and to the second nearest point, for all cells
  // with the offsets `steps_` along the axes that are already fixed, by one loop per remaining
  // axis.
  Numbers search(Expression cellHash, const Numbers& before) {
    const std::size_t axis = steps_.size();
    if (axis == inside_.size()) return addPoint(cellHash, before);
    const Numbers fixed = steps_;
    return fold(cells, before, [&](const Numbers& nearest, Expression step) {
      const Expression offset = step - cells / 2.0;
      steps_ = fixed;
      steps_.push_back(offset);
      return search(hash(cellHash, corner_[axis] + offset), nearest);
    });
  }

 private:
  Numbers addPoint(Expression cellHash, const Numbers& before) const {
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
  const Numbers squares = Search(p).search(seed, {far, far});
  return {sqrt(squares[0]), sqrt(squares[1])};
}

}  // namespace warpjet
