// Warps written by hand for tests of the mesh module, and the distance of a warped surface from the
// triangles that approximate it. Everything is computed in double, without code of src/.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "mesh/mesh.hpp"
#include "mesh/refine/subdivide.hpp"

namespace warpjet {

using Point = std::array<double, 3>;
using PointWarp = std::function<Point(const Point&)>;

inline Point operator+(const Point& a, const Point& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Point operator-(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Point operator*(double s, const Point& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Point& a) { return std::sqrt(dot(a, a)); }

inline Point pointOf(const std::vector<float>& numbers, std::size_t vertex) {
  return {numbers[3 * vertex], numbers[3 * vertex + 1], numbers[3 * vertex + 2]};
}

// The following warps are for meshes with a size of about 100.
inline Point rotateAboutY(const Point& p, double angle) {
  return {p[0] * std::cos(angle) - p[2] * std::sin(angle), p[1],
          p[0] * std::sin(angle) + p[2] * std::cos(angle)};
}

inline Point twist(const Point& p) { return rotateAboutY(p, 0.015 * p[1]); }

// Twists only the part above y = 20.
inline Point twistNearOneEnd(const Point& p) {
  const double t = std::clamp((p[1] - 20) / 30, 0.0, 1.0);
  return rotateAboutY(p, 1.2 * t * t * (3 - 2 * t));
}

// The warp of the cube in figure 6 of the paper.
inline Point sines(const Point& p) {
  return p + Point{22 * std::sin(0.035 * p[1]), 22 * std::sin(0.035 * p[2]),
                   22 * std::sin(0.035 * p[0])};
}

// Makes almost five waves over a length of 100.
inline Point waves(const Point& p) { return p + Point{0, 0, 6 * std::sin(0.3 * p[0])}; }

// Adds a bump about 40 wide on the side where z = 50.
inline Point bump(const Point& p) {
  const Point d = p - Point{20, 15, 50};
  return p + Point{0, 0, 20 * std::exp((d[0] * d[0] + d[1] * d[1] + 0.1 * d[2] * d[2]) / -200)};
}

// Pulls the mesh along a curve into a spout, the nearest parts first.
inline Point genie(const Point& p) {
  const Point spout{50, 93, 0}, above{75, 0, 0};
  const double s = std::clamp((0.8 - length(p - spout) / 240) / 0.5, 0.0, 1.0);
  const double t = s * s * (3 - 2 * s);
  return (1 - t) * (1 - t) * p + 2 * t * (1 - t) * above + t * t * spout;
}

// Returns the normal of the warped surface, by central differences along two directions
// perpendicular to the normal n.
inline Point warpedNormal(const PointWarp& warp, const Point& p, const Point& n) {
  if (length(n) == 0) return {};
  const Point helper = std::abs(n[0]) < 0.6 * length(n) ? Point{1, 0, 0} : Point{0, 1, 0};
  const double step = 1e-5;
  const Point u = cross(n, helper), v = cross(n, u);
  const Point du = warp(p + step * u) - warp(p - step * u);
  const Point dv = warp(p + step * v) - warp(p - step * v);
  const Point normal = cross(du, dv);
  return length(normal) > 0 ? (1 / length(normal)) * normal : Point{};
}

// Adapts the warp for `subdivide`.
inline WarpFunction onMeshes(const PointWarp& warp) {
  return [warp](const Mesh& vertices) {
    Moved moved;
    for (std::size_t i = 0; i < vertices.vertexCount(); ++i) {
      const Point p = pointOf(vertices.positions, i);
      for (const double x : warp(p)) moved.positions.push_back(static_cast<float>(x));
      if (vertices.normals.empty()) continue;
      for (const double x : warpedNormal(warp, p, pointOf(vertices.normals, i)))
        moved.normals.push_back(static_cast<float>(x));
    }
    return moved;
  };
}

inline double distanceToSegment(const Point& p, const Point& a, const Point& b) {
  const Point ab = b - a;
  const double squared = dot(ab, ab);
  const double t = squared > 0 ? std::clamp(dot(p - a, ab) / squared, 0.0, 1.0) : 0;
  return length(p - (a + t * ab));
}

// Solves a 2x2 system for the barycentric coordinates of the foot of the perpendicular. If it is
// outside of the triangle, the nearest point is on a side.
inline double distanceToTriangle(const Point& p, const Point& a, const Point& b, const Point& c) {
  const Point ab = b - a, ac = c - a, ap = p - a;
  const double bb = dot(ab, ab), bc = dot(ab, ac), cc = dot(ac, ac);
  const double determinant = bb * cc - bc * bc;
  if (determinant > 1e-12 * bb * cc) {
    const double v = (cc * dot(ap, ab) - bc * dot(ap, ac)) / determinant;
    const double w = (bb * dot(ap, ac) - bc * dot(ap, ab)) / determinant;
    if (v >= 0 && w >= 0 && v + w <= 1) return length(ap - (v * ab + w * ac));
  }
  return std::min(
      {distanceToSegment(p, a, b), distanceToSegment(p, b, c), distanceToSegment(p, c, a)});
}

// Returns the largest distance of the warped surface from the warped triangles, at (steps +
// 1)(steps + 2)/2 points of each triangle.
inline double geometricError(const Mesh& mesh, const PointWarp& warp, int steps = 5) {
  double largest = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    std::array<Point, 3> corners, warped;
    for (std::size_t j = 0; j < 3; ++j) {
      corners[j] = pointOf(mesh.positions, mesh.indices[i + j]);
      warped[j] = warp(corners[j]);
    }
    for (int u = 0; u <= steps; ++u) {
      for (int v = 0; u + v <= steps; ++v) {
        const double x = double(u) / steps, y = double(v) / steps;
        const Point p = (1 - x - y) * corners[0] + x * corners[1] + y * corners[2];
        largest = std::max(largest, distanceToTriangle(warp(p), warped[0], warped[1], warped[2]));
      }
    }
  }
  return largest;
}

}  // namespace warpjet
