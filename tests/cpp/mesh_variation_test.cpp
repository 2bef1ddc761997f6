// Variation of normals and uvs over meshes of surfaces with known derivatives.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "mesh/surface/variation.hpp"
#include "shapes.hpp"

namespace warpjet {
namespace {

constexpr double pi = std::numbers::pi;

using Point = std::array<double, 3>;
using Matrix = std::array<Point, 3>;

// A surface with two parameters from 0 to 1, which are its uvs.
struct Sample {
  Point position, normal;
};
using Patch = std::function<Sample(double u, double v)>;

Mesh meshOf(const Patch& patch, int columns, int rows) {
  Mesh mesh;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const double u = double(i) / columns, v = double(j) / rows;
      const auto [p, n] = patch(u, v);
      append(mesh.positions, {p[0], p[1], p[2]});
      append(mesh.normals, {n[0], n[1], n[2]});
      append(mesh.uvs, {u, v});
    }
  }
  const auto row = static_cast<std::uint32_t>(columns + 1);
  for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rows); ++j) {
    for (std::uint32_t a = j * row; a + 1 < (j + 1) * row; ++a)
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, a + row + 1, a, a + row + 1, a + row});
  }
  return mesh;
}

Point vectorAt(const std::vector<float>& numbers, std::size_t vertex) {
  return {numbers[3 * vertex], numbers[3 * vertex + 1], numbers[3 * vertex + 2]};
}

// Returns the derivative of the normal, row by row.
Matrix shapeAt(const Mesh& mesh, std::size_t vertex) {
  return {vectorAt(mesh.gradients[0], vertex), vectorAt(mesh.gradients[1], vertex),
          vectorAt(mesh.gradients[2], vertex)};
}

Point uGradient(const Mesh& mesh, std::size_t vertex) {
  return vectorAt(mesh.gradients[3], vertex);
}
Point vGradient(const Mesh& mesh, std::size_t vertex) {
  return vectorAt(mesh.gradients[4], vertex);
}

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Returns the derivative of a normal with the curvature k1 along t, k2 across it and 0 along the
// normal.
Matrix shapeOf(const Point& normal, const Point& t, double k1, double k2) {
  const Point b{normal[1] * t[2] - normal[2] * t[1], normal[2] * t[0] - normal[0] * t[2],
                normal[0] * t[1] - normal[1] * t[0]};
  Matrix shape{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) shape[i][k] = k1 * t[i] * t[k] + k2 * b[i] * b[k];
  }
  return shape;
}

double difference(const Matrix& a, const Matrix& b) {
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) largest = std::max(largest, std::abs(a[i][k] - b[i][k]));
  }
  return largest;
}

void expectNear(const Point& actual, const Point& expected, double tolerance, std::size_t vertex) {
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(actual[i], expected[i], tolerance) << "vertex " << vertex << ", component " << i;
}

void expectFinite(const Mesh& mesh) {
  for (const auto& numbers : mesh.gradients) {
    for (const float x : numbers) ASSERT_TRUE(std::isfinite(x));
  }
}

Mesh sphere(double radius, int columns, int rows) {
  return meshOf(
      [&](double u, double v) -> Sample {
        const double a = 2 * pi * u, b = pi * v;
        const Point n{std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b)};
        return {{radius * n[0], radius * n[1], radius * n[2]}, n};
      },
      columns, rows);
}

TEST(SurfaceVariation, ASphereHasTheCurvatureOneOverItsRadius) {
  for (const double radius : {0.01, 1.0, 300.0}) {
    // At each pole, a whole row of triangles has no area.
    Mesh mesh = sphere(radius, 24, 12);
    addSurfaceVariation(mesh);
    expectFinite(mesh);
    for (std::size_t i = 0; i < mesh.vertexCount(); ++i) {
      const Point n = vectorAt(mesh.normals, i);
      const Point t = std::abs(n[2]) < 0.9 ? Point{n[1], -n[0], 0} : Point{n[2], 0, -n[0]};
      const double length = std::sqrt(dot(t, t));
      const Point unit{t[0] / length, t[1] / length, t[2] / length};
      EXPECT_LT(difference(shapeAt(mesh, i), shapeOf(n, unit, 1 / radius, 1 / radius)),
                2e-5 / radius)
          << i;
    }
  }
}

TEST(SurfaceVariation, ACylinderIsCurvedOnlyAroundItsAxis) {
  Mesh mesh = meshOf(
      [](double u, double v) -> Sample {
        const Point n{std::cos(2 * pi * u), 0, std::sin(2 * pi * u)};
        return {{2 * n[0], 5 * v, 2 * n[2]}, n};
      },
      20, 7);
  addSurfaceVariation(mesh);
  for (std::size_t i = 0; i < mesh.vertexCount(); ++i) {
    const Point n = vectorAt(mesh.normals, i);
    EXPECT_LT(difference(shapeAt(mesh, i), shapeOf(n, {0, 1, 0}, 0, 0.5)), 1e-5) << i;
    expectNear(vGradient(mesh, i), {0, 0.2, 0}, 1e-5, i);
    // u grows by 1 over the circumference of 4 pi; the edges are a little shorter than the arcs.
    expectNear(uGradient(mesh, i), {-n[2] / (4 * pi), 0, n[0] / (4 * pi)}, 1e-3, i);
  }
}

// Returns the largest error for a torus of `steps` steps, relative to the largest curvature.
double torusError(int steps) {
  constexpr double big = 1, small = 0.4;
  Mesh mesh = meshOf(
      [](double u, double v) -> Sample {
        const double a = 2 * pi * u, b = 2 * pi * v;
        const Point n{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
        return {{std::cos(a) * big + small * n[0], std::sin(a) * big + small * n[1], small * n[2]},
                n};
      },
      2 * steps, steps);
  addSurfaceVariation(mesh);
  double largest = 0;
  for (std::size_t i = 0; i < mesh.vertexCount(); ++i) {
    const double a = 2 * pi * mesh.uvs[2 * i], b = 2 * pi * mesh.uvs[2 * i + 1];
    const Point along{-std::sin(a), std::cos(a), 0};
    const double aroundAxis = std::cos(b) / (big + small * std::cos(b));
    const Matrix expected = shapeOf(vectorAt(mesh.normals, i), along, aroundAxis, 1 / small);
    largest = std::max(largest, small * difference(shapeAt(mesh, i), expected));
  }
  return largest;
}

// Doubling the steps divides the error by about four: convergence is of order two, also at the
// seams, whose vertices share their values.
TEST(SurfaceVariation, ATorusConvergesToItsPrincipalCurvatures) {
  const double coarse = torusError(16), fine = torusError(32), finest = torusError(64);
  EXPECT_LT(coarse, 0.03);
  EXPECT_LT(fine, 0.3 * coarse);
  EXPECT_LT(finest, 0.3 * fine);
}

TEST(SurfaceVariation, ASaddleHasCurvaturesOfBothSigns) {
  // z = (x² - y²) / 2 with the normal (-x, y, 1): in the middle the curvatures are -1 and 1.
  constexpr int steps = 20;
  Mesh mesh = meshOf(
      [](double u, double v) -> Sample {
        const double x = u - 0.5, y = v - 0.5, length = std::sqrt(x * x + y * y + 1);
        return {{x, y, (x * x - y * y) / 2}, {-x / length, y / length, 1 / length}};
      },
      steps, steps);
  addSurfaceVariation(mesh);
  const std::size_t middle = (steps + 1) * (steps / 2) + steps / 2;
  EXPECT_LT(difference(shapeAt(mesh, middle), shapeOf({0, 0, 1}, {1, 0, 0}, -1, 1)), 5e-3);
  expectNear(uGradient(mesh, middle), {1, 0, 0}, 2e-3, middle);
  expectNear(vGradient(mesh, middle), {0, 1, 0}, 2e-3, middle);
}

TEST(SurfaceVariation, APlaneHasOnlyGradientsOfUvs) {
  Mesh mesh = gridPlane(3, 8);
  addSurfaceVariation(mesh);
  for (std::size_t i = 0; i < mesh.vertexCount(); ++i) {
    EXPECT_EQ(difference(shapeAt(mesh, i), Matrix{}), 0);
    expectNear(uGradient(mesh, i), {0.125, 0, 0}, 1e-7, i);
    expectNear(vGradient(mesh, i), {0, 0.125, 0}, 1e-7, i);
  }
}

TEST(SurfaceVariation, StopsAtHardEdges) {
  Mesh mesh = cubeOfFaces(2);
  addSurfaceVariation(mesh);
  // Each face has a size of 2, and its image covers it once.
  for (std::size_t i = 0; i < mesh.vertexCount(); ++i) {
    EXPECT_LT(difference(shapeAt(mesh, i), Matrix{}), 1e-7);
    const Point u = uGradient(mesh, i), v = vGradient(mesh, i);
    EXPECT_NEAR(dot(u, u), 0.25, 1e-6);
    EXPECT_NEAR(dot(v, v), 0.25, 1e-6);
    EXPECT_NEAR(dot(u, v), 0, 1e-6);
    EXPECT_NEAR(dot(u, vectorAt(mesh.normals, i)), 0, 1e-6);
  }
}

TEST(SurfaceVariation, DoesNotDependOnTheWindingOfTriangles) {
  Mesh mesh = sphere(1, 12, 6), reversed = mesh;
  for (std::size_t i = 0; i < reversed.indices.size(); i += 3)
    std::swap(reversed.indices[i], reversed.indices[i + 1]);
  addSurfaceVariation(mesh);
  addSurfaceVariation(reversed);
  for (std::size_t i = 0; i < mesh.vertexCount(); ++i)
    EXPECT_LT(difference(shapeAt(mesh, i), shapeAt(reversed, i)), 1e-6);
}

TEST(SurfaceVariation, IsZeroIfNoTriangleDeterminesIt) {
  Mesh mesh;
  mesh.positions = {0, 0, 0, 1, 0, 0, 2, 0, 0, 9, 9, 9};
  mesh.normals = {0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 0, 1};
  mesh.indices = {0, 1, 2, 0, 0, 1};
  addSurfaceVariation(mesh);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(mesh.gradients[i], std::vector<float>(12, 0.0f));
  EXPECT_TRUE(mesh.gradients[3].empty() && mesh.gradients[4].empty());

  Mesh none;
  addSurfaceVariation(none);
  EXPECT_TRUE(none.gradients[0].empty());

  // A zero normal, as where a warp has collapsed the surface.
  Mesh lost = sphere(1, 8, 4);
  for (std::size_t i = 0; i < 3; ++i) lost.normals[3 * 20 + i] = 0;
  addSurfaceVariation(lost);
  expectFinite(lost);
  EXPECT_EQ(difference(shapeAt(lost, 20), Matrix{}), 0);
}

TEST(SurfaceVariation, IsFiniteForExtremeFloats) {
  for (const double size : {3e38, 1e-38, 1e-45}) {
    Mesh mesh = sphere(1, 8, 4);
    for (float& x : mesh.positions) x = static_cast<float>(x * size);
    addSurfaceVariation(mesh);
    expectFinite(mesh);
  }
}

// Adds a triangle whose height is a tiny fraction of its length. Its normals are rounded to
// float32.
TEST(SurfaceVariation, SliversHaveLittleInfluence) {
  Mesh mesh = sphere(1, 16, 8);
  const Mesh whole = mesh;
  const auto count = static_cast<std::uint32_t>(mesh.vertexCount());
  // A vertex almost on an edge, and the sliver between them.
  for (int i = 0; i < 3; ++i) {
    mesh.positions.push_back((whole.positions[3 * 60 + i] + whole.positions[3 * 61 + i]) / 2 *
                             (1 + 1e-7f));
    mesh.normals.push_back((whole.normals[3 * 60 + i] + whole.normals[3 * 61 + i]) / 2);
  }
  append(mesh.uvs, {0.5, 0.5});
  mesh.indices.insert(mesh.indices.end(), {60, count, 61});
  addSurfaceVariation(mesh);
  for (const std::size_t i : {60u, 61u}) {
    const Point n = vectorAt(mesh.normals, i);
    const double length = std::hypot(n[0], n[1]);
    const Point t{n[1] / length, -n[0] / length, 0};
    EXPECT_LT(difference(shapeAt(mesh, i), shapeOf(n, t, 1, 1)), 1e-2) << i;
  }
}

}  // namespace
}  // namespace warpjet
