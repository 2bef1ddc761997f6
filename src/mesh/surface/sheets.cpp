#include "mesh/surface/sheets.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "mesh/surface/pairs.hpp"

namespace warpjet {

namespace {

using Ids = std::vector<std::uint32_t>;
using Three = std::array<std::uint32_t, 3>;

// Numbers that are equal for vertices that were joined.
class Groups {
 public:
  explicit Groups(std::size_t size) : parents_(size) {
    std::iota(parents_.begin(), parents_.end(), 0u);
  }

  std::uint32_t find(std::uint32_t i) {
    for (; parents_[i] != i; i = parents_[i]) parents_[i] = parents_[parents_[i]];
    return i;
  }

  void join(std::uint32_t a, std::uint32_t b) { parents_[find(a)] = find(b); }

 private:
  Ids parents_;
};

// Between two places, with the third corners of the two-sided triangles there.
struct SheetEdge {
  std::uint32_t oneCorner, otherCorner = none;
  bool isOfTwo = true;
  // A vertex at each end, on the side that passes `oneCorner` forwards and on the other one.
  std::array<std::array<std::uint32_t, 2>, 2> ends{{{none, none}, {none, none}}};
};

class Search {
 public:
  Search(const Mesh& mesh, const Ids& places) : mesh_(mesh), places_(places) {}

  Sheets run() {
    Sheets sheets{markTwoSided(), {}};
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < sheets.isTwoSided.size(); ++i) {
      if (sheets.isTwoSided[i]) found.push_back(i);
    }
    if (found.empty()) return sheets;
    for (const std::uint32_t i : found) forEachEdge(i, meet);
    Groups groups(mesh_.vertexCount());
    for (const std::uint32_t i : found)
      forEachEdge(i, [&](const Use& use) { joinAlong(use, groups); });
    for (std::uint32_t i = 0; i < mesh_.vertexCount(); ++i)
      sheets.ofVertices.push_back(groups.find(i));
    return sheets;
  }

 private:
  struct Use {
    SheetEdge& edge;
    bool isForwards;
    std::uint32_t corner;               // the place of the third
    std::array<std::uint32_t, 2> ends;  // vertices, as the edge has them
  };

  std::vector<bool> markTwoSided() const {
    Pairs pairs, triples;
    std::vector<std::array<bool, 2>> isThere;  // by three places, in each sense
    std::vector<std::pair<std::uint32_t, bool>> triangles;
    for (std::uint32_t i = 0; i < mesh_.triangleCount(); ++i) {
      Three p = placesOf(i);
      std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
      const bool isLeft = p[1] < p[2];
      const std::uint32_t pair = pairs.findOrAdd(p[0], std::min(p[1], p[2]), i);
      const auto next = static_cast<std::uint32_t>(isThere.size());
      const std::uint32_t triple = triples.findOrAdd(pair, std::max(p[1], p[2]), next);
      if (triple == next) isThere.emplace_back();
      isThere[triple][isLeft] = true;
      triangles.emplace_back(triple, p[0] != p[1] && p[1] != p[2] && p[2] != p[0]);
    }
    std::vector<bool> isTwoSided;
    for (const auto& [triple, hasArea] : triangles)
      isTwoSided.push_back(hasArea && isThere[triple][0] && isThere[triple][1]);
    return isTwoSided;
  }

  Three placesOf(std::uint32_t triangle) const {
    Three corners = mesh_.corners(triangle);
    for (std::uint32_t& corner : corners) corner = places_[corner];
    return corners;
  }

  template <class Visitor>
  void forEachEdge(std::uint32_t triangle, Visitor visit) {
    const Three corners = mesh_.corners(triangle);
    for (int i = 0; i < 3; ++i) {
      std::uint32_t a = corners[i], b = corners[(i + 1) % 3];
      const bool isForwards = places_[a] < places_[b];
      if (!isForwards) std::swap(a, b);
      const std::uint32_t corner = places_[corners[(i + 2) % 3]];
      const auto next = static_cast<std::uint32_t>(edges_.size());
      const std::uint32_t edge = numbers_.findOrAdd(places_[a], places_[b], next);
      if (edge == next) edges_.push_back({corner});
      visit({edges_[edge], isForwards, corner, {a, b}});
    }
  }

  static void meet(const Use& use) {
    SheetEdge& edge = use.edge;
    if (use.corner == edge.oneCorner) return;
    if (edge.otherCorner == none) edge.otherCorner = use.corner;
    edge.isOfTwo = edge.isOfTwo && use.corner == edge.otherCorner;
  }

  // Neighbours of one side pass their edge in opposite directions.
  static void joinAlong(const Use& use, Groups& groups) {
    if (!use.edge.isOfTwo) return;
    auto& ends = use.edge.ends[use.isForwards == (use.corner == use.edge.oneCorner)];
    for (int i = 0; i < 2; ++i) {
      if (ends[i] == none) ends[i] = use.ends[i];
      groups.join(use.ends[i], ends[i]);
    }
  }

  const Mesh& mesh_;
  const Ids& places_;
  Pairs numbers_;
  std::vector<SheetEdge> edges_;
};

}  // namespace

Sheets findSheets(const Mesh& mesh, const std::vector<std::uint32_t>& places) {
  return Search(mesh, places).run();
}

}  // namespace warpjet
