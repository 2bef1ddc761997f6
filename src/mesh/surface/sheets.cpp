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

// Groups of corners (union-find): `find` returns the same number for all corners that were joined.
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

// An edge between two positions, with the third corners of its triangles.
struct SheetEdge {
  std::uint32_t oneCorner, otherCorner = none;
  bool hasTwoCorners = true;  // no triangle has another third corner
  bool isFull = false;        // two-sided triangles already gave both third corners
  // The first corner at each end, for each side of the surface. Side 1 is the one on which the
  // triangle of `oneCorner` traverses the edge forwards.
  std::array<std::array<std::uint32_t, 2>, 2> ends{{{none, none}, {none, none}}};
};

class SheetFinder {
 public:
  SheetFinder(const Mesh& mesh, const Ids& positionIds) : mesh_(mesh), positionIds_(positionIds) {}

  Sheets run() {
    findTwoSided();
    if (twoSided_.empty()) return {};
    findOneSidedNeighbors();
    for (const std::uint32_t i : twoSided_) forEachEdge(i, addCorner);
    for (SheetEdge& edge : edges_) edge.isFull = edge.otherCorner != none;
    for (const std::uint32_t i : oneSided_) forEachEdge(i, addCorner);

    Groups groups(3 * mesh_.triangleCount());
    joinAtVertices(groups);
    for (const auto* triangles : {&twoSided_, &oneSided_}) {
      for (const std::uint32_t i : *triangles)
        forEachEdge(i, [&](const Use& use) { joinAlong(use, groups); });
    }
    return numberSheets(groups);
  }

 private:
  struct Use {
    SheetEdge& edge;
    bool isForwards;
    std::uint32_t corner;               // the position of the third corner
    std::array<std::uint32_t, 2> ends;  // corners, in the order of the edge
  };

  Three positionIdsOf(std::uint32_t triangle) const {
    Three corners = mesh_.corners(triangle);
    for (std::uint32_t& corner : corners) corner = positionIds_[corner];
    return corners;
  }

  static bool hasArea(const Three& p) { return p[0] != p[1] && p[1] != p[2] && p[2] != p[0]; }

  void findTwoSided() {
    Pairs pairs, triples;
    std::vector<std::array<bool, 2>> orientations;  // by triple of positions: which ones occur
    std::vector<std::pair<std::uint32_t, bool>> triangles;
    for (std::uint32_t i = 0; i < mesh_.triangleCount(); ++i) {
      Three p = positionIdsOf(i);
      std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
      const bool isLeft = p[1] < p[2];
      const std::uint32_t pair = pairs.findOrAdd(p[0], std::min(p[1], p[2]), i);
      const auto next = static_cast<std::uint32_t>(orientations.size());
      const std::uint32_t triple = triples.findOrAdd(pair, std::max(p[1], p[2]), next);
      if (triple == next) orientations.emplace_back();
      orientations[triple][isLeft] = true;
      triangles.emplace_back(triple, isLeft);
    }
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      const auto& [right, left] = orientations[triangles[i].first];
      if (right && left && hasArea(positionIdsOf(i))) twoSided_.push_back(i);
    }
    if (!twoSided_.empty()) findOnBothSides(triangles);
  }

  // Finds the vertices that both a triangle and its reverse use. `triangles` has for each triangle
  // the index of its triple of positions, and its orientation.
  void findOnBothSides(const std::vector<std::pair<std::uint32_t, bool>>& triangles) {
    isOnBothSides_.resize(mesh_.vertexCount());
    Pairs uses;
    std::vector<bool> firstOrientations;  // by use of a vertex in a triple of positions
    for (const std::uint32_t i : twoSided_) {
      const auto& [triple, isLeft] = triangles[i];
      for (const std::uint32_t vertex : mesh_.corners(i)) {
        const auto next = static_cast<std::uint32_t>(firstOrientations.size());
        const std::uint32_t use = uses.findOrAdd(triple, vertex, next);
        if (use == next) firstOrientations.push_back(isLeft);
        if (firstOrientations[use] != isLeft) isOnBothSides_[vertex] = true;
      }
    }
  }

  // Finds one-sided triangles that share a position with two-sided ones: they continue one of the
  // sides.
  void findOneSidedNeighbors() {
    isTwoSidedPosition_.resize(mesh_.vertexCount());
    for (const std::uint32_t i : twoSided_) {
      for (const std::uint32_t id : positionIdsOf(i)) isTwoSidedPosition_[id] = true;
    }
    auto next = twoSided_.begin();
    for (std::uint32_t i = 0; i < mesh_.triangleCount(); ++i) {
      if (next != twoSided_.end() && *next == i) {
        ++next;
        continue;
      }
      const Three p = positionIdsOf(i);
      if (hasArea(p) &&
          (isTwoSidedPosition_[p[0]] || isTwoSidedPosition_[p[1]] || isTwoSidedPosition_[p[2]]))
        oneSided_.push_back(i);
    }
  }

  template <class Visitor>
  void forEachEdge(std::uint32_t triangle, Visitor visit) {
    const Three p = positionIdsOf(triangle);
    for (std::uint32_t i = 0; i < 3; ++i) {
      std::uint32_t a = i, b = (i + 1) % 3;
      const bool isForwards = p[a] < p[b];
      if (!isForwards) std::swap(a, b);
      const std::uint32_t corner = p[(i + 2) % 3];
      const auto next = static_cast<std::uint32_t>(edges_.size());
      const std::uint32_t edge = edgesByEnds_.findOrAdd(p[a], p[b], next);
      if (edge == next) edges_.push_back({corner});
      visit({edges_[edge], isForwards, corner, {3 * triangle + a, 3 * triangle + b}});
    }
  }

  static void addCorner(const Use& use) {
    SheetEdge& edge = use.edge;
    if (use.corner == edge.oneCorner || edge.isFull) return;
    if (edge.otherCorner == none) edge.otherCorner = use.corner;
    edge.hasTwoCorners = edge.hasTwoCorners && use.corner == edge.otherCorner;
  }

  // Joins corners that share a vertex, as the mesh itself does.
  void joinAtVertices(Groups& groups) const {
    Ids first(mesh_.vertexCount(), none);
    for (const auto* triangles : {&twoSided_, &oneSided_}) {
      for (const std::uint32_t i : *triangles) {
        const Three vertices = mesh_.corners(i);
        for (std::uint32_t k = 0; k < 3; ++k) {
          if (isOnBothSides_[vertices[k]]) continue;
          if (first[vertices[k]] == none) first[vertices[k]] = 3 * i + k;
          groups.join(3 * i + k, first[vertices[k]]);
        }
      }
    }
  }

  // Joins neighbors on the same side, which traverse their edge in opposite directions.
  static void joinAlong(const Use& use, Groups& groups) {
    const SheetEdge& edge = use.edge;
    const bool isOne = use.corner == edge.oneCorner;
    if (!edge.hasTwoCorners || !(isOne || use.corner == edge.otherCorner)) return;
    auto& ends = use.edge.ends[use.isForwards == isOne];
    for (int i = 0; i < 2; ++i) {
      if (ends[i] == none) ends[i] = use.ends[i];
      groups.join(use.ends[i], ends[i]);
    }
  }

  Sheets numberSheets(Groups& groups) {
    Sheets sheets{Ids(3 * mesh_.triangleCount(), none), 0, std::move(isOnBothSides_)};
    Ids sheetOfGroup(sheets.sheetOfCorner.size(), none);
    for (const auto* triangles : {&twoSided_, &oneSided_}) {
      for (const std::uint32_t i : *triangles) {
        const Three p = positionIdsOf(i);
        for (std::uint32_t k = 0; k < 3; ++k) {
          if (!isTwoSidedPosition_[p[k]]) continue;
          std::uint32_t& sheet = sheetOfGroup[groups.find(3 * i + k)];
          if (sheet == none) sheet = sheets.count++;
          sheets.sheetOfCorner[3 * i + k] = sheet;
        }
      }
    }
    return sheets;
  }

  const Mesh& mesh_;
  const Ids& positionIds_;
  Ids twoSided_, oneSided_;               // triangles
  std::vector<bool> isTwoSidedPosition_;  // true if a two-sided triangle uses the position
  std::vector<bool> isOnBothSides_;
  Pairs edgesByEnds_;
  std::vector<SheetEdge> edges_;
};

}  // namespace

Sheets findSheets(const Mesh& mesh, const std::vector<std::uint32_t>& positionIds) {
  return SheetFinder(mesh, positionIds).run();
}

}  // namespace warpjet
