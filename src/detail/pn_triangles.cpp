#include "detail/pn_triangles.hpp"

#include <cmath>
#include <utility>

namespace warpjet {

namespace {

using glm::vec3;

vec3 read(const Attribute& attribute, std::uint32_t vertex) {
  const float* p = attribute.values.data() + std::size_t{3} * vertex;
  return {p[0], p[1], p[2]};
}

// Returns zero for a vector that has no direction.
vec3 normalizeOrZero(vec3 v) {
  const float scale = 1 / glm::length(v);
  return std::isfinite(scale) ? v * scale : vec3(0);
}

vec3 projectOntoPlane(vec3 v, vec3 normal) { return v - dot(v, normal) * normal; }

// The normals at one end of an edge: of both triangles, which differ where a mesh has a crease.
struct EndNormals {
  vec3 first{0}, second{0};
  bool hasFirst = false;

  void add(vec3 normal) {
    if (!hasFirst) first = normal;
    second = normal;
    hasFirst = true;
  }

  // Returns the part of an edge's direction that is tangent to both triangles: along the line in
  // which their planes meet, if these differ clearly.
  vec3 tangent(vec3 along) const {
    constexpr float minSine = 0.25f;
    const vec3 line = cross(first, second);
    if (dot(line, line) > minSine * minSine) return line * (dot(along, line) / dot(line, line));
    return (projectOntoPlane(along, first) + projectOntoPlane(along, second)) * 0.5f;
  }
};

// The control point of normals along an edge: the mean of both, mirrored at the plane across the
// edge, so that an inflection between the ends shows (equation 5 of the paper).
vec3 middleNormal(vec3 along, vec3 first, vec3 second) {
  const vec3 sum = first + second;
  const float square = dot(along, along);
  return normalizeOrZero(square > 0 ? sum - 2 * dot(along, sum) / square * along : sum);
}

// The side on which a point lies, since the weight of the corner opposite to it is 0; 3 for none.
int sideOf(const Weights& weights) {
  for (int i = 0; i < 3; ++i)
    if (weights[i] == 0) return (i + 1) % 3;
  return 3;
}

}  // namespace

PnTriangles::PnTriangles(BaseMesh mesh, std::size_t normals)
    : mesh_(std::move(mesh)), normals_(normals) {
  fit();
}

void PnTriangles::setAttributes(const std::vector<Attribute>& attributes) {
  mesh_.setAttributes(attributes);
  fit();
}

vec3 PnTriangles::place(std::uint32_t vertex) const { return read(mesh_.attributes()[0], vertex); }

vec3 PnTriangles::normalAt(std::uint32_t vertex) const {
  return normalizeOrZero(read(mesh_.attributes()[normals_], vertex));
}

void PnTriangles::fitCurves() {
  std::vector<std::array<EndNormals, 2>> normals(mesh_.edgeCount());
  for (std::size_t t = 0; t < mesh_.triangles().size(); ++t) {
    for (const std::uint32_t side : mesh_.sidesOf(t)) {
      const auto& [ends, edge, triangle] = mesh_.sides()[side];
      for (int k = 0; k < 2; ++k) normals[edge][k].add(normalAt(ends[k]));
    }
  }
  curves_.resize(mesh_.edgeCount());
  middleNormals_.clear();
  for (const auto& [ends, edge, triangle] : mesh_.sides()) {
    const vec3 a = place(ends[0]), b = place(ends[1]), along = b - a;
    curves_[edge] = {a + normals[edge][0].tangent(along) / 3.0f,
                     b - normals[edge][1].tangent(along) / 3.0f};
    middleNormals_.push_back(middleNormal(along, normalAt(ends[0]), normalAt(ends[1])));
  }
}

void PnTriangles::fit() {
  fitCurves();
  centers_.clear();
  for (std::size_t t = 0; t < mesh_.triangles().size(); ++t) {
    vec3 corners(0), between(0);
    for (int i = 0; i < 3; ++i) {
      corners += place(mesh_.triangles()[t][i]);
      const Curve& curve = curves_[mesh_.edgeOf(t, i)];
      between += curve[0] + curve[1];
    }
    centers_.push_back(between / 4.0f - corners / 6.0f);
  }
}

PnTriangles::SidePoint PnTriangles::onSide(std::size_t triangle, int side,
                                           const Weights& weights) const {
  const std::uint32_t number = mesh_.sidesOf(triangle)[side];
  const int next = (side + 1) % 3;
  const bool isForward = mesh_.startsAt(number, mesh_.triangles()[triangle][side]);
  return {number, weights[isForward ? side : next], weights[isForward ? next : side]};
}

vec3 PnTriangles::position(std::size_t triangle, const Weights& weights) const {
  // Leaves out the terms of the ends.
  const auto along = [&](const SidePoint& point) {
    const auto& [side, a, b] = point;
    const auto& [first, second] = curves_[mesh_.sides()[side].edge];
    return 3 * a * a * b * first + 3 * a * b * b * second;
  };
  if (const int side = sideOf(weights); side < 3) {
    const SidePoint point = onSide(triangle, side, weights);
    const auto& [start, end] = mesh_.sides()[point.side].ends;
    const float a = point.start, b = point.end;
    return a * a * a * place(start) + along(point) + b * b * b * place(end);
  }
  vec3 sum = 6 * weights[0] * weights[1] * weights[2] * centers_[triangle];
  for (int i = 0; i < 3; ++i) {
    const float w = weights[i];
    sum += w * w * w * place(mesh_.triangles()[triangle][i]) + along(onSide(triangle, i, weights));
  }
  return sum;
}

// A quadratic Bezier triangle. The paper leaves out the factor 2 of the Bernstein polynomials, and
// so pulls normals toward the corners: on a circle they would not be those of its points.
vec3 PnTriangles::normal(std::size_t triangle, const Weights& weights) const {
  if (const int side = sideOf(weights); side < 3) {
    const auto [number, a, b] = onSide(triangle, side, weights);
    const auto& [start, end] = mesh_.sides()[number].ends;
    return normalizeOrZero(a * a * normalAt(start) + 2 * a * b * middleNormals_[number] +
                           b * b * normalAt(end));
  }
  vec3 sum(0);
  for (int i = 0; i < 3; ++i) {
    const auto [number, a, b] = onSide(triangle, i, weights);
    sum += weights[i] * weights[i] * normalAt(mesh_.triangles()[triangle][i]) +
           2 * a * b * middleNormals_[number];
  }
  return normalizeOrZero(sum);
}

}  // namespace warpjet
