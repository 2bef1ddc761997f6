// The part of the refiner that chooses the edges to split in a pass.
#include <algorithm>
#include <limits>
#include <utility>

#include "mesh/refine/refiner.hpp"

namespace warpjet {

std::vector<std::uint32_t> Refiner::chooseEdges() {
  std::vector<bool> chosen(needs_.size());
  for (std::size_t i = 0; i < needs_.size(); ++i) {
    const Edge& edge = surface_.edges()[i];
    // Overlapping triangles can bring back an edge that was already split.
    chosen[i] = edge.uses > 0 && (needs_[i].isWanted() || edge.middle != none);
  }
  keepShape(chosen);
  std::vector<std::uint32_t> edges;
  for (std::uint32_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i]) edges.push_back(i);
  }
  const std::size_t count = surface_.triangles().size();
  return keepWorst(std::move(edges),
                   refinement_.maxTriangles - std::min(refinement_.maxTriangles, count));
}

// If any side of a sliver is chosen, also chooses its longest side. So triangles at the border of a
// fine region, or between two nearly parallel edges, don't become ever thinner. (Bisecting the
// longest side never reduces the smallest angle below half of its initial value: Rosenberg and
// Stenger, "A lower bound on the angles of triangles constructed by bisecting the longest side",
// 1975.) The consequences of a choice are propagated from edge to edge.
void Refiner::keepShape(std::vector<bool>& chosen) const {
  struct Entailed {
    std::uint32_t edge, next;
  };
  std::vector<Entailed> entailed;
  std::vector<std::uint32_t> first(chosen.size(), none);  // by edge: the head of a list
  for (const Triangle& triangle : surface_.triangles()) {
    const std::uint32_t edge = surface_.edgeNumber(triangle, triangle.longest);
    if (!triangle.isSliver || !needs_[edge].canSplit) continue;
    for (const int other : {(triangle.longest + 1) % 3, (triangle.longest + 2) % 3}) {
      std::uint32_t& head = first[surface_.edgeNumber(triangle, other)];
      entailed.push_back({edge, head});
      head = static_cast<std::uint32_t>(entailed.size() - 1);
    }
  }
  std::vector<std::uint32_t> waiting;
  for (std::uint32_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i]) waiting.push_back(i);
  }
  while (!waiting.empty()) {
    std::uint32_t i = first[waiting.back()];
    waiting.pop_back();
    for (; i != none; i = entailed[i].next) {
      if (chosen[entailed[i].edge]) continue;
      chosen[entailed[i].edge] = true;
      waiting.push_back(entailed[i].edge);
    }
  }
}

// Returns the edges with the highest scores that fit into `room` more triangles. Splitting an edge
// adds one triangle per triangle that uses it. Edges that were split before come first.
std::vector<std::uint32_t> Refiner::keepWorst(std::vector<std::uint32_t> edges, std::size_t room) {
  std::size_t added = 0, addedAgain = 0;
  for (const std::uint32_t i : edges) {
    const Edge& edge = surface_.edges()[i];
    added += edge.uses;
    if (edge.middle != none) addedAgain += edge.uses;
  }
  isFull_ = added > room;
  if (!isFull_) return edges;
  if (addedAgain > room) return {};
  // Ties are ordered by number, so that the result is deterministic.
  std::vector<std::pair<float, std::uint32_t>> ranks;
  for (const std::uint32_t i : edges) {
    const bool isAgain = surface_.edges()[i].middle != none;
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
