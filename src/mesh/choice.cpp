// The refiner's choice of the edges that a pass splits.
#include <algorithm>
#include <limits>
#include <utility>

#include "mesh/refiner.hpp"

namespace warpjet {

namespace {

// A triangle whose height is less than this share of its longest side is split through that side
// whenever it is split at all. So triangles at the border of a fine region, or between two edges
// that are nearly one, do not become ever thinner. (Bisecting the longest side never makes the
// smallest angle less than half of what it was: Rosenberg and Stenger, "A lower bound on the angles
// of triangles constructed by bisecting the longest side", 1975.)
constexpr float sliver = 0.0625f;

}  // namespace

std::vector<std::uint32_t> Refiner::chooseEdges() const {
  std::vector<bool> chosen(needs_.size());
  for (std::size_t i = 0; i < needs_.size(); ++i) {
    const Edge& edge = surface_.edges()[i];
    // Overlapping triangles can bring back an edge that is split already.
    chosen[i] = edge.uses > 0 && (needs_[i].isWanted() || edge.middle != noNumber);
  }
  keepShape(chosen);
  std::vector<std::uint32_t> edges;
  for (std::uint32_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i]) edges.push_back(i);
  }
  const std::size_t count = surface_.triangles().size();
  return worst(std::move(edges),
               refinement_.maxTriangles - std::min(refinement_.maxTriangles, count));
}

void Refiner::keepShape(std::vector<bool>& chosen) const {
  const auto isChosen = [&](std::uint32_t side) { return chosen[surface_.sides()[side].edge]; };
  for (bool isChanging = true; isChanging;) {
    isChanging = false;
    for (const Triangle& triangle : surface_.triangles()) {
      if (std::none_of(triangle.sides.begin(), triangle.sides.end(), isChosen)) continue;
      const int longest = longestSide(triangle);
      const std::uint32_t edge = surface_.edgeNumber(triangle, longest);
      if (chosen[edge] || !needs_[edge].canSplit) continue;
      const float base = sideLength(triangle, longest);
      const float height = 2 * areaOf(triangle) / base;
      if (height < sliver * base) chosen[edge] = isChanging = true;
    }
  }
}

// Splitting an edge adds a triangle for each that uses it.
std::vector<std::uint32_t> Refiner::worst(std::vector<std::uint32_t> edges,
                                          std::size_t room) const {
  std::size_t added = 0, addedAgain = 0;
  for (const std::uint32_t i : edges) {
    const Edge& edge = surface_.edges()[i];
    added += edge.uses;
    if (edge.middle != noNumber) addedAgain += edge.uses;
  }
  if (added <= room) return edges;
  if (addedAgain > room) return {};
  // Equals in the order of their numbers, so that the same input has the same result.
  std::vector<std::pair<float, std::uint32_t>> ranks;
  for (const std::uint32_t i : edges) {
    const bool isAgain = surface_.edges()[i].middle != noNumber;
    ranks.emplace_back(isAgain ? -std::numeric_limits<float>::infinity() : -needs_[i].score, i);
  }
  std::sort(ranks.begin(), ranks.end());
  edges.clear();
  for (const auto& [rank, edge] : ranks) {
    const std::size_t uses = surface_.edges()[edge].uses;
    if (uses > room) continue;
    room -= uses;
    edges.push_back(edge);
  }
  return edges;
}

}  // namespace warpjet
