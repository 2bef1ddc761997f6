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

// The vertex normals at one end of an edge, one for each adjacent triangle. The two differ at a
// crease.
struct EndNormals {
  vec3 first{0}, second{0};
  bool hasFirst = false;

  void add(vec3 normal) {
    if (!hasFirst) first = normal;
    second = normal;
    hasFirst = true;
  }

  // Projects an edge onto the line in which both tangent planes intersect. If the planes are nearly
  // parallel, returns the mean of the projections onto each.
  vec3 projectOntoTangents(vec3 along) const {
    constexpr float minSine = 0.25f;
    const vec3 line = cross(first, second);
    if (dot(line, line) > minSine * minSine) return line * (dot(along, line) / dot(line, line));
    return (projectOntoPlane(along, first) + projectOntoPlane(along, second)) * 0.5f;
  }
};

// Returns the middle control normal of an edge: the mean of the normals at its ends, reflected in
// the plane perpendicular to the edge, so that the normals can follow an inflection between the
// ends (equation 5 of the paper).
vec3 middleNormal(vec3 along, vec3 first, vec3 second) {
  const vec3 sum = first + second;
  const float square = dot(along, along);
  return normalizeOrZero(square > 0 ? sum - 2 * dot(along, sum) / square * along : sum);
}

// Returns the side that contains a point: the one opposite to the corner whose weight is 0. Returns
// 3 for an inner point.
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
    curves_[edge] = {a + normals[edge][0].projectOntoTangents(along) / 3.0f,
                     b - normals[edge][1].projectOntoTangents(along) / 3.0f};
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
  const std::uint32_t sideIndex = mesh_.sidesOf(triangle)[side];
  const int next = (side + 1) % 3;
  const bool isForward = mesh_.startsAt(sideIndex, mesh_.triangles()[triangle][side]);
  return {sideIndex, weights[isForward ? side : next], weights[isForward ? next : side]};
}

vec3 PnTriangles::position(std::size_t triangle, const Weights& weights) const {
  // Returns the Bezier terms of a side, without those of its ends.
  const auto innerTerms = [&](const SidePoint& point) {
    const auto& [sideIndex, a, b] = point;
    const auto& [first, second] = curves_[mesh_.sides()[sideIndex].edge];
    return 3 * a * a * b * first + 3 * a * b * b * second;
  };
  if (const int side = sideOf(weights); side < 3) {
    const SidePoint point = onSide(triangle, side, weights);
    const auto& [start, end] = mesh_.sides()[point.sideIndex].ends;
    const float a = point.start, b = point.end;
    return a * a * a * place(start) + innerTerms(point) + b * b * b * place(end);
  }
  vec3 sum = 6 * weights[0] * weights[1] * weights[2] * centers_[triangle];
  for (int i = 0; i < 3; ++i) {
    const float w = weights[i];
    sum += w * w * w * place(mesh_.triangles()[triangle][i]) +
           innerTerms(onSide(triangle, i, weights));
  }
  return sum;
}

// Evaluates a quadratic Bezier triangle. The paper leaves out the factor 2 of the Bernstein
// polynomials, which pulls normals toward those of the corners: on the mesh of a circle, the
// interpolated normals would not be those of the circle.
vec3 PnTriangles::normal(std::size_t triangle, const Weights& weights) const {
  if (const int side = sideOf(weights); side < 3) {
    const auto [sideIndex, a, b] = onSide(triangle, side, weights);
    const auto& [start, end] = mesh_.sides()[sideIndex].ends;
    return normalizeOrZero(a * a * normalAt(start) + 2 * a * b * middleNormals_[sideIndex] +
                           b * b * normalAt(end));
  }
  vec3 sum(0);
  for (int i = 0; i < 3; ++i) {
    const auto [sideIndex, a, b] = onSide(triangle, i, weights);
    sum += weights[i] * weights[i] * normalAt(mesh_.triangles()[triangle][i]) +
           2 * a * b * middleNormals_[sideIndex];
  }
  return normalizeOrZero(sum);
}

}  // namespace warpjet
