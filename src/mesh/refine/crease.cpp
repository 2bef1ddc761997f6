#include "mesh/refine/crease.hpp"

#include <utility>

#include "mesh/surface/blend.hpp"
#include "mesh/surface/points.hpp"

namespace warpjet {

namespace {

// After this number of halvings, a thousandth of the edge remains, and the edge was short to begin
// with.
constexpr int maxHalvings = 10;

Weights halfway(const Weights& a, const Weights& b) {
  return {0.5f * (a[0] + b[0]), 0.5f * (a[1] + b[1]), 0.5f * (a[2] + b[2])};
}

struct Search {
  std::size_t turn;
  Weights from, to;
  glm::vec3 normalFrom{}, normalTo{};
};

constexpr std::array<Weights, 3> cornerWeights{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

}  // namespace

std::vector<bool> findJumps(const Mesh& mesh, std::span<const Turn> turns, float angle,
                            const WarpFunction& warp) {
  Mesh vertices;
  for (const Turn& turn : turns) {
    appendBlend(vertices, mesh, {turn.corners, turn.weights});
    for (const Weights& corner : cornerWeights) appendBlend(vertices, mesh, {turn.corners, corner});
  }
  const auto normals = applyWarp(vertices, warp, true).normals;
  std::vector<Search> searches;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const glm::vec3 normal = at(normals, 4 * i);
    const auto turnOf = [&](std::size_t corner) {
      return angleBetween(normal, at(normals, 4 * i + 1 + corner));
    };
    std::size_t farthest = 0;
    for (std::size_t corner = 1; corner < 3; ++corner) {
      if (turnOf(corner) > turnOf(farthest)) farthest = corner;
    }
    searches.push_back(
        {i, turns[i].weights, cornerWeights[farthest], normal, at(normals, 4 * i + 1 + farthest)});
  }
  for (int halving = 0; halving < maxHalvings && !searches.empty(); ++halving) {
    vertices = {};
    for (const Search& search : searches)
      appendBlend(vertices, mesh, {turns[search.turn].corners, halfway(search.from, search.to)});
    const auto middles = applyWarp(vertices, warp, true).normals;
    std::vector<Search> remaining;
    for (std::size_t i = 0; i < searches.size(); ++i) {
      Search search = searches[i];
      const Weights middle = halfway(search.from, search.to);
      const glm::vec3 normal = at(middles, i);
      const float before = angleBetween(search.normalFrom, normal);
      const float after = angleBetween(normal, search.normalTo);
      if (before > after) {
        search.to = middle;
        search.normalTo = normal;
      } else {
        search.from = middle;
        search.normalFrom = normal;
      }
      if (std::max(before, after) > angle / 2) remaining.push_back(search);
    }
    searches = std::move(remaining);
  }
  std::vector<bool> hasJump(turns.size());
  for (const Search& search : searches) hasJump[search.turn] = true;
  return hasJump;
}

}  // namespace warpjet
