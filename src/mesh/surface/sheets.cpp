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

// Union-find: numbers that are equal for joined vertices.
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
  bool isOfTwo = true;
  bool isFull = false;  // two-sided triangles have both third corners
  // A corner at each end, on the side that passes `oneCorner` forwards and on the other one.
  std::array<std::array<std::uint32_t, 2>, 2> ends{{{none, none}, {none, none}}};
};

class Search {
 public:
  Search(const Mesh& mesh, const Ids& places) : mesh_(mesh), places_(places) {}

  Sheets run() {
    findTwoSided();
    if (twoSided_.empty()) return {};
    findOthersThere();
    for (const std::uint32_t i : twoSided_) forEachEdge(i, meet);
    for (SheetEdge& edge : edges_) edge.isFull = edge.otherCorner != none;
    for (const std::uint32_t i : others_) forEachEdge(i, meet);

    Groups groups(3 * mesh_.triangleCount());
    joinAtVertices(groups);
    for (const auto* triangles : {&twoSided_, &others_}) {
      for (const std::uint32_t i : *triangles)
        forEachEdge(i, [&](const Use& use) { joinAlong(use, groups); });
    }
    return numberValues(groups);
  }

 private:
  struct Use {
    SheetEdge& edge;
    bool isForwards;
    std::uint32_t corner;               // the position of the third corner
    std::array<std::uint32_t, 2> ends;  // corners, in the order of the edge
  };

  Three placesOf(std::uint32_t triangle) const {
    Three corners = mesh_.corners(triangle);
    for (std::uint32_t& corner : corners) corner = places_[corner];
    return corners;
  }

  static bool hasArea(const Three& p) { return p[0] != p[1] && p[1] != p[2] && p[2] != p[0]; }

  void findTwoSided() {
    Pairs pairs, triples;
    std::vector<std::array<bool, 2>> isThere;  // by three positions, in each orientation
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
      triangles.emplace_back(triple, isLeft);
    }
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      const std::array<bool, 2>& senses = isThere[triangles[i].first];
      if (senses[0] && senses[1] && hasArea(placesOf(i))) twoSided_.push_back(i);
    }
    if (!twoSided_.empty()) findOnBothSides(triangles);
  }

  // `triangles` have the number of their three positions, and their orientation.
  void findOnBothSides(const std::vector<std::pair<std::uint32_t, bool>>& triangles) {
    isOnBothSides_.resize(mesh_.vertexCount());
    Pairs uses;
    std::vector<bool> senses;  // the orientation in which a vertex was used first
    for (const std::uint32_t i : twoSided_) {
      const auto& [triple, isLeft] = triangles[i];
      for (const std::uint32_t vertex : mesh_.corners(i)) {
        const auto next = static_cast<std::uint32_t>(senses.size());
        const std::uint32_t use = uses.findOrAdd(triple, vertex, next);
        if (use == next) senses.push_back(isLeft);
        if (senses[use] != isLeft) isOnBothSides_[vertex] = true;
      }
    }
  }

  // One-sided triangles adjacent to the others: they continue one of the sides.
  void findOthersThere() {
    isThere_.resize(mesh_.vertexCount());
    for (const std::uint32_t i : twoSided_) {
      for (const std::uint32_t place : placesOf(i)) isThere_[place] = true;
    }
    auto next = twoSided_.begin();
    for (std::uint32_t i = 0; i < mesh_.triangleCount(); ++i) {
      if (next != twoSided_.end() && *next == i) {
        ++next;
        continue;
      }
      const Three p = placesOf(i);
      if (hasArea(p) && (isThere_[p[0]] || isThere_[p[1]] || isThere_[p[2]])) others_.push_back(i);
    }
  }

  template <class Visitor>
  void forEachEdge(std::uint32_t triangle, Visitor visit) {
    const Three p = placesOf(triangle);
    for (std::uint32_t i = 0; i < 3; ++i) {
      std::uint32_t a = i, b = (i + 1) % 3;
      const bool isForwards = p[a] < p[b];
      if (!isForwards) std::swap(a, b);
      const std::uint32_t corner = p[(i + 2) % 3];
      const auto next = static_cast<std::uint32_t>(edges_.size());
      const std::uint32_t edge = numbers_.findOrAdd(p[a], p[b], next);
      if (edge == next) edges_.push_back({corner});
      visit({edges_[edge], isForwards, corner, {3 * triangle + a, 3 * triangle + b}});
    }
  }

  static void meet(const Use& use) {
    SheetEdge& edge = use.edge;
    if (use.corner == edge.oneCorner || edge.isFull) return;
    if (edge.otherCorner == none) edge.otherCorner = use.corner;
    edge.isOfTwo = edge.isOfTwo && use.corner == edge.otherCorner;
  }

  // Corners that share a vertex are meant to be joined.
  void joinAtVertices(Groups& groups) const {
    Ids first(mesh_.vertexCount(), none);
    for (const auto* triangles : {&twoSided_, &others_}) {
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

  // Neighbors on one side traverse their edge in opposite directions.
  static void joinAlong(const Use& use, Groups& groups) {
    const SheetEdge& edge = use.edge;
    const bool isOne = use.corner == edge.oneCorner;
    if (!edge.isOfTwo || !(isOne || use.corner == edge.otherCorner)) return;
    auto& ends = use.edge.ends[use.isForwards == isOne];
    for (int i = 0; i < 2; ++i) {
      if (ends[i] == none) ends[i] = use.ends[i];
      groups.join(use.ends[i], ends[i]);
    }
  }

  Sheets numberValues(Groups& groups) {
    Sheets sheets{Ids(3 * mesh_.triangleCount(), none), 0, std::move(isOnBothSides_)};
    Ids ofGroups(sheets.ofCorners.size(), none);
    for (const auto* triangles : {&twoSided_, &others_}) {
      for (const std::uint32_t i : *triangles) {
        const Three p = placesOf(i);
        for (std::uint32_t k = 0; k < 3; ++k) {
          if (!isThere_[p[k]]) continue;
          std::uint32_t& number = ofGroups[groups.find(3 * i + k)];
          if (number == none) number = sheets.count++;
          sheets.ofCorners[3 * i + k] = number;
        }
      }
    }
    return sheets;
  }

  const Mesh& mesh_;
  const Ids& places_;
  Ids twoSided_, others_;      // triangles
  std::vector<bool> isThere_;  // by position: true if it has a two-sided triangle
  std::vector<bool> isOnBothSides_;
  Pairs numbers_;
  std::vector<SheetEdge> edges_;
};

}  // namespace

Sheets findSheets(const Mesh& mesh, const std::vector<std::uint32_t>& places) {
  return Search(mesh, places).run();
}

}  // namespace warpjet
