#include "detail/topology.hpp"

namespace warpjet {

std::vector<std::uint32_t> topologyOf(const BaseMesh& base) {
  std::vector<std::uint32_t> words;
  words.reserve(6 * base.triangles().size() + 3 * base.sides().size());
  for (std::size_t t = 0; t < base.triangles().size(); ++t) {
    const Corners& corners = base.triangles()[t];
    words.insert(words.end(), corners.begin(), corners.end());
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t side = base.sidesOf(t)[i];
      words.push_back(2 * side + (base.startsAt(side, corners[i]) ? 1 : 0));
    }
  }
  for (const BaseMesh::Side& side : base.sides()) {
    words.insert(words.end(), side.ends.begin(), side.ends.end());
    words.push_back(side.edge);
  }
  return words;
}

}  // namespace warpjet
