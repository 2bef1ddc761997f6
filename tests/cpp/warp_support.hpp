// Fixtures that evaluate warped normals and tangents, at a point of space and on a torus.
#pragma once

#include <gtest/gtest.h>

#include "algebra/matrices.hpp"
#include "support.hpp"
#include "warp/warp.hpp"

namespace warpjet {

using Point = std::array<double, 3>;

class WarpTest : public testing::Test {
 protected:
  Graph graph;
  Differentiator differentiator{graph};
  Value p = vector3(graph, "position"), n = vector3(graph, "normal");
  Expression zero{&graph, graph.constant(0)};

  Value vec3(Expression x, Expression y, Expression z) {
    const Expression components[] = {x, y, z};
    return fill(graph, vectorOf(3), [&](int i) { return components[i]; });
  }

  Point normalOf(const Value& offset, Point position, Point normal) {
    const Value warped = warpNormal(deformation(differentiator, offset, p), n);
    Inputs inputs;
    for (int i = 0; i < 3; ++i) {
      inputs[p[i].id] = position[i];
      inputs[n[i].id] = normal[i];
    }
    return {evaluateNode(graph, warped[0].id, inputs), evaluateNode(graph, warped[1].id, inputs),
            evaluateNode(graph, warped[2].id, inputs)};
  }

  static void expectNear(const Point& a, const Point& b) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-14) << "component " << i;
  }
};

// A point of a torus at two angles, which are u and v; with the gradients of the angles and of the
// normal, which follow from the principal curvatures (do Carmo, "Differential Geometry of Curves
// and Surfaces", section 3.3).
struct TorusPoint {
  Point position, normal;
  std::array<Point, 5> gradients;
  double u, v;

  TorusPoint(double a, double b) : u(a), v(b) {
    constexpr double big = 2, small = 0.7;
    const double ca = std::cos(a), sa = std::sin(a), cb = std::cos(b), sb = std::sin(b);
    const double ring = big + small * cb;
    position = {ring * ca, ring * sa, small * sb};
    normal = {ca * cb, sa * cb, sb};
    const Point along{-sa, ca, 0}, around{-ca * sb, -sa * sb, cb};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 3; ++i)
        gradients[i][k] = along[i] * along[k] * cb / ring + around[i] * around[k] / small;
      gradients[3][k] = along[k] / ring;
      gradients[4][k] = around[k] / small;
    }
  }
};

class SurfaceTest : public WarpTest {
 protected:
  Value uv = variable(graph, "uv", vectorOf(2));
  std::array<Value, 5> gradients{vector3(graph, "nx"), vector3(graph, "ny"), vector3(graph, "nz"),
                                 vector3(graph, "nu"), vector3(graph, "nv")};

  Value surfaceDeformation(const Value& offset) {
    Value m = deformation(differentiator, offset, p);
    const Expression inputs[] = {n[0], n[1], n[2], uv[0], uv[1]};
    for (std::size_t i = 0; i < 5; ++i)
      m = varyInput(differentiator, m, offset, inputs[i], gradients[i]);
    return m;
  }

  Inputs inputsAt(const TorusPoint& point) const {
    Inputs inputs{{uv[0].id, point.u}, {uv[1].id, point.v}};
    for (int k = 0; k < 3; ++k) {
      inputs[p[k].id] = point.position[k];
      inputs[n[k].id] = point.normal[k];
      for (std::size_t i = 0; i < 5; ++i) inputs[gradients[i][k].id] = point.gradients[i][k];
    }
    return inputs;
  }

  Point evaluateAt(const Value& value, const TorusPoint& point) const {
    const Inputs inputs = inputsAt(point);
    Point found;
    for (int i = 0; i < 3; ++i) found[i] = evaluateNode(graph, value[i].id, inputs);
    return found;
  }

  // Returns the normal of the moved surface, by finite differences along its angles.
  Point movedNormal(const Value& offset, double a, double b) const {
    const double step = 1e-5;
    const auto slope = [&](double da, double db) {
      const TorusPoint after(a + da, b + db), before(a - da, b - db);
      const Point x = evaluateAt(p + offset, after), y = evaluateAt(p + offset, before);
      return Point{(x[0] - y[0]) / (2 * step), (x[1] - y[1]) / (2 * step),
                   (x[2] - y[2]) / (2 * step)};
    };
    const Point s = slope(step, 0), t = slope(0, step);
    Point normal{s[1] * t[2] - s[2] * t[1], s[2] * t[0] - s[0] * t[2], s[0] * t[1] - s[1] * t[0]};
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    for (double& x : normal) x /= length;
    return normal;
  }

  // Compares the warped normal with that of the moved surface.
  void expectCorrectNormals(const Value& offset) {
    const Value m = surfaceDeformation(offset);
    const Value warped = warpNormal(m, n);
    for (double a = 0.1; a < 6; a += 0.9) {
      for (double b = 0.2; b < 6; b += 0.7) {
        const Point found = evaluateAt(warped, {a, b}), expected = movedNormal(offset, a, b);
        for (std::size_t i = 0; i < 3; ++i)
          EXPECT_NEAR(found[i], expected[i], 1e-8) << a << ", " << b;
      }
    }
  }
};

class WholeWarpTest : public SurfaceTest {
 protected:
  Value t = variable(graph, "tangent", vectorOf(4));
  WarpInputs inputs{
      p, n, uv, t, {gradients[0], gradients[1], gradients[2], gradients[3], gradients[4]}};

  static void expectSame(const Value& a, const Value& b) {
    ASSERT_EQ(a.shape(), b.shape());
    for (int i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].id, b[i].id) << "component " << i;
  }
};

}  // namespace warpjet
