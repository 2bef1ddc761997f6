// Subdivision reaches both of its goals, measured with more samples than subdivision takes, and
// reports goals that it can't reach.
#include <gtest/gtest.h>

#include <limits>

#include "mesh/refine/shortfall.hpp"
#include "mesh/refine/subdivide.hpp"
#include "sanitized.hpp"
#include "shapes.hpp"
#include "warped.hpp"

namespace warpjet {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

// Returns the sum of three octaves of products of sines, whose peaks never coincide.
double rough(const Point& p) {
  double sum = 0, size = 1;
  for (int octave = 0; octave < 3; ++octave, size /= 2) {
    const Point q = (0.31 / size) * p;
    sum += size * std::sin(q[0] + 1.7 * q[1]) * std::sin(1.3 * q[1] - 0.6 * q[2] + octave) *
           std::sin(0.8 * q[2] + 0.9 * q[0]);
  }
  return sum;
}

TEST(SubdivideGoals, RoughSurfacesMeetTheTolerance) {
  const PointWarp warp = [](const Point& p) { return p + Point{0, 0, 5 * rough(p)}; };
  for (const Mesh& mesh : {gridPlane(8, 60), icosphere(2, 30)}) {
    for (const float tolerance : {2.0f, 0.5f}) {
      const Refined result = subdivide(mesh, {tolerance, infinity}, onMeshes(warp));
      EXPECT_TRUE(result.reachedTolerance);
      EXPECT_LE(geometricError(result.mesh, warp, isSanitized ? 8 : 24), tolerance);
    }
  }
}

TEST(SubdivideGoals, DetectsASpikeOfA200thOfTheMeshWidth) {
  for (const double x : {13.3, -31.7}) {
    const PointWarp spike = [&](const Point& p) {
      const double d = std::hypot(p[0] - x, p[1] - 7.1) / 0.25;
      return p + Point{0, 0, 5 * std::exp(-d * d)};
    };
    const Refined result = subdivide(gridPlane(1, 100), {0.5f, infinity}, onMeshes(spike));
    EXPECT_LE(geometricError(result.mesh, spike, 300), 0.5);
  }
}

// From an issue: two triangles met the tolerance, but their normals were 1.5 radians off.
TEST(SubdivideGoals, RefinesForAnglesAfterTheToleranceIsMet) {
  const PointWarp ripples = [](const Point& p) {
    return p + Point{0, 0, 0.3 * std::sin(4 * p[0])};
  };
  const Refined result = subdivide(gridPlane(1, 10), {1, 0.17f}, onMeshes(ripples));
  EXPECT_TRUE(result.reachedAngle);
  EXPECT_LE(result.worstAngle, 0.17f);
  for (std::size_t i = 0; i < result.mesh.triangleCount(); ++i) {
    std::array<Point, 3> p, n;
    for (int j = 0; j < 3; ++j) {
      p[j] = pointOf(result.mesh.positions, result.mesh.corners(i)[j]);
      n[j] = warpedNormal(ripples, p[j], {0, 0, 1});
    }
    for (int u = 0; u <= 12; ++u) {
      for (int v = 0; u + v <= 12; ++v) {
        const double s = u / 12.0, t = v / 12.0;
        const Point between = (1 - s - t) * n[0] + s * n[1] + t * n[2];
        const Point normal =
            warpedNormal(ripples, (1 - s - t) * p[0] + s * p[1] + t * p[2], {0, 0, 1});
        ASSERT_LE(std::asin(length(cross(normal, between)) / length(between)), 1.02 * 0.17);
      }
    }
  }
}

std::string shortfallMessage(const Mesh& mesh, const Refinement& refinement,
                             const PointWarp& warp) {
  const auto messages = shortfallOf(subdivide(mesh, refinement, onMeshes(warp)), refinement);
  return messages.size() == 1 ? messages[0] : std::to_string(messages.size()) + " messages";
}

TEST(SubdivideGoals, ReportsGoalsThatWereNotReached) {
  const auto contains = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  const Mesh plane = gridPlane(1, 100);
  contains(shortfallMessage(plane, {0.01f, infinity, 100}, waves),
           "raise maxTriangles, which is 100.");
  contains(shortfallMessage(plane, {0.01f, infinity, 100}, waves), "above the tolerance of 0.01");
  contains(shortfallMessage(plane, {100, 0.1f, 100}, waves), "radians off, above the angle of 0.1");
  const PointWarp crease = [](const Point& p) {
    return p + Point{0, 0, std::max(0.0, 0.5 * (p[0] - 13.7))};
  };
  contains(shortfallMessage(plane, {1, 0.17f}, crease), "more would not help");
  contains(shortfallMessage(plane, {1e-9f, infinity, 1 << 12}, sines),
           "above the tolerance of 1e-09");
  const PointWarp hole = [](const Point& p) { return p[0] > 13.7 ? Point{nan, nan, nan} : p; };
  contains(shortfallMessage(plane, {1, infinity}, hole), "no finite position");
  EXPECT_EQ(shortfallMessage(plane, {1, 0.17f}, sines), "0 messages");
}

TEST(SubdivideGoals, AWarpMayReturnNormalsOnlyAtItsFirstCall) {
  int calls = 0;
  const Refined result = subdivide(gridPlane(4, 100), {0.5f}, [&](const Mesh& vertices) {
    Moved moved = onMeshes(sines)(vertices);
    if (calls++ > 0) moved.normals.clear();
    return moved;
  });
  EXPECT_GT(result.mesh.triangleCount(), 32u);
}

}  // namespace
}  // namespace warpjet
