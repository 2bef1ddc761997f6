#include "mesh/refine/surface.hpp"

#include <algorithm>
#include <utility>

#include "mesh/surface/blend.hpp"
#include "mesh/surface/points.hpp"

namespace warpjet {

namespace {

// Triangles whose height is below this share of their longest side are slivers.
constexpr float sliver = 0.0625f;

Position positionOf(const Mesh& mesh, std::size_t vertex) {
  const glm::vec3 p = at(mesh.positions, vertex);
  return {p.x, p.y, p.z};
}

}  // namespace

Surface::Surface(Mesh mesh) : mesh_(std::move(mesh)) {
  welded_.reserve(mesh_.vertexCount());
  for (std::size_t i = 0; i < mesh_.vertexCount(); ++i)
    welded_.push_back(welder_.weld(positionOf(mesh_, i)));
  triangles_.reserve(mesh_.triangleCount());
  for (std::uint32_t i = 0; i < mesh_.triangleCount(); ++i) {
    const Three corners = mesh_.corners(i);
    const auto& [a, b, c] = corners;
    add(corners, {findSide(a, b), findSide(b, c), findSide(c, a)}, i);
  }
}

std::uint32_t Surface::findSide(std::uint32_t a, std::uint32_t b) {
  if (std::pair(welded_[a], a) > std::pair(welded_[b], b)) std::swap(a, b);
  // Sides have their own table: where shapes coincide, an edge has any number of sides.
  const auto nextSide = static_cast<std::uint32_t>(sides_.size());
  const std::uint32_t side = sidesByEnds_.findOrAdd(a, b, nextSide);
  if (side != nextSide) return side;
  const auto nextEdge = static_cast<std::uint32_t>(edges_.size());
  const std::uint32_t edge = edgesByEnds_.findOrAdd(welded_[a], welded_[b], nextEdge);
  if (edge == nextEdge) edges_.push_back({{welded_[a], welded_[b]}});
  sides_.push_back({{a, b}, edge});
  return side;
}

// In double, since the product of two floats may overflow.
double Surface::areaOf(const Three& corners) const {
  const auto corner = [&](int i) { return glm::dvec3(at(mesh_.positions, corners[i])); };
  const glm::dvec3 a = corner(0);
  return glm::length(glm::cross(corner(1) - a, corner(2) - a)) / 2;
}

void Surface::add(const Three& corners, const Three& sides, std::uint32_t origin) {
  std::array<float, 3> lengths;
  for (int i = 0; i < 3; ++i)
    lengths[i] = distance(mesh_.positions, corners[i], corners[(i + 1) % 3]);
  const auto longest = std::max_element(lengths.begin(), lengths.end());
  const double length = *longest;
  const bool isSliver = 2 * areaOf(corners) < sliver * length * length;
  triangles_.push_back(
      {corners, sides, origin, static_cast<int>(longest - lengths.begin()), isSliver});
  for (const std::uint32_t side : sides) ++edges_[sides_[side].edge].uses;
}

Position Surface::middleOf(const Edge& edge) const {
  const Position &a = endOf(edge, 0), &b = endOf(edge, 1);
  return {0.5f * a[0] + 0.5f * b[0], 0.5f * a[1] + 0.5f * b[1], 0.5f * a[2] + 0.5f * b[2]};
}

void Surface::addMiddles(std::span<const std::uint32_t> edges) {
  // Welded with the other positions: a T-junction in the file closes if both positions are equal.
  for (const std::uint32_t edge : edges) edges_[edge].middle = welder_.weld(middleOf(edges_[edge]));

  for (const Triangle& triangle : triangles_) {
    if (isDegenerate(triangle)) continue;
    for (const std::uint32_t side : triangle.sides) {
      if (edges_[sides_[side].edge].middle != none && sides_[side].middle == none) split(side);
    }
  }
}

void Surface::split(std::uint32_t side) {
  const auto [a, b] = sides_[side].ends;
  const std::uint32_t position = edges_[sides_[side].edge].middle;
  const auto middle = static_cast<std::uint32_t>(mesh_.vertexCount());
  appendBlend(mesh_, mesh_, {{a, b, a}, {0.5f, 0.5f, 0}});
  ends_.insert(ends_.end(), {a, b});
  std::copy_n(welder_.position(position).begin(), 3, mesh_.positions.end() - 3);
  welded_.push_back(position);
  sides_[side].middle = middle;
  const std::uint32_t atA = findSide(a, middle), atB = findSide(middle, b);
  sides_[side].halves = {atA, atB};
}

bool Surface::isDegenerate(const Triangle& triangle) const {
  const auto [a, b, c] = triangle.corners;
  return welded_[a] == welded_[b] || welded_[b] == welded_[c] || welded_[c] == welded_[a];
}

std::uint32_t Surface::halfOf(std::uint32_t side, std::uint32_t end) const {
  return sides_[side].halves[sides_[side].ends[0] == end ? 0 : 1];
}

void Surface::divide(const std::vector<float>& positions) {
  const std::vector<Triangle> old = std::exchange(triangles_, {});
  triangles_.reserve(2 * old.size());
  for (const Triangle& triangle : old) divide(triangle, positions);
}

void Surface::divide(const Triangle& triangle, const std::vector<float>& positions) {
  const auto isSplit = [this](std::uint32_t side) {
    return edges_[sides_[side].edge].middle != none;
  };
  const auto splits = std::count_if(triangle.sides.begin(), triangle.sides.end(), isSplit);
  if (splits == 0) {
    triangles_.push_back(triangle);
    return;
  }
  for (const std::uint32_t side : triangle.sides) --edges_[sides_[side].edge].uses;
  if (isDegenerate(triangle)) return;

  // Rotates the triangle until the split sides come first.
  int first = 0;
  while (!isSplit(triangle.sides[first]) ||
         (splits == 2 && !isSplit(triangle.sides[(first + 1) % 3])))
    ++first;
  const auto rotate = [first](Three three) {
    std::rotate(three.begin(), three.begin() + first, three.end());
    return three;
  };
  const std::uint32_t origin = triangle.origin;
  const auto [a, b, c] = rotate(triangle.corners);
  const auto [sideAB, sideBC, sideCA] = rotate(triangle.sides);
  const std::uint32_t ab = sides_[sideAB].middle, bc = sides_[sideBC].middle,
                      ca = sides_[sideCA].middle;

  if (splits == 1) {
    const std::uint32_t inner = findSide(ab, c);
    add({a, ab, c}, {halfOf(sideAB, a), inner, sideCA}, origin);
    add({ab, b, c}, {halfOf(sideAB, b), sideBC, inner}, origin);
    return;
  }
  const std::uint32_t atB = findSide(ab, bc);
  add({ab, b, bc}, {halfOf(sideAB, b), halfOf(sideBC, b), atB}, origin);
  if (splits == 3) {
    const std::uint32_t atC = findSide(bc, ca), atA = findSide(ca, ab);
    add({bc, c, ca}, {halfOf(sideBC, c), halfOf(sideCA, c), atC}, origin);
    add({ca, a, ab}, {halfOf(sideCA, a), halfOf(sideAB, a), atA}, origin);
    add({ab, bc, ca}, {atB, atC, atA}, origin);
  } else if (distance(positions, a, bc) <= distance(positions, ab, c)) {
    const std::uint32_t diagonal = findSide(a, bc);
    add({a, ab, bc}, {halfOf(sideAB, a), atB, diagonal}, origin);
    add({a, bc, c}, {diagonal, halfOf(sideBC, c), sideCA}, origin);
  } else {
    const std::uint32_t diagonal = findSide(ab, c);
    add({a, ab, c}, {halfOf(sideAB, a), diagonal, sideCA}, origin);
    add({ab, bc, c}, {atB, halfOf(sideBC, c), diagonal}, origin);
  }
}

Origins Surface::origins() const {
  Origins origins{ends_, {}};
  origins.triangles.reserve(triangles_.size());
  for (const Triangle& triangle : triangles_) origins.triangles.push_back(triangle.origin);
  return origins;
}

Mesh Surface::takeMesh() && {
  mesh_.indices.clear();
  mesh_.indices.reserve(3 * triangles_.size());
  for (const Triangle& triangle : triangles_)
    mesh_.indices.insert(mesh_.indices.end(), triangle.corners.begin(), triangle.corners.end());
  return std::move(mesh_);
}

}  // namespace warpjet
