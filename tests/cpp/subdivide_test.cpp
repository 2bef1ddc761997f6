// Tests only the results of adaptive subdivision: there are no cracks, and the warped triangles are
// close to the warped surface, which is sampled densely in double.
#include "mesh/refine/subdivide.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "conformity.hpp"
#include "sanitized.hpp"
#include "shapes.hpp"
#include "warped.hpp"

namespace warpjet {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

struct NamedWarp {
  std::string name;
  PointWarp warp;
};

const std::vector<NamedWarp> smoothWarps{{"twist", twist}, {"twist near one end", twistNearOneEnd},
                                         {"sines", sines}, {"waves", waves},
                                         {"bump", bump},   {"genie", genie}};

struct NamedMesh {
  std::string name;
  Mesh mesh;
};

std::vector<NamedMesh> closedMeshes() {
  return {{"cube", cube(100)},
          {"cube of faces", cubeOfFaces(100)},
          {"icosphere", icosphere(2, 50)},
          {"sphere with a seam", sphereWithSeam(16, 8, 50)}};
}

struct Pair {
  std::string name;
  const Mesh& mesh;
  const PointWarp& warp;
};

// Returns all pairs of meshes and warps; with sanitizers only every third pair, which still
// includes each mesh and each warp.
std::vector<Pair> pairsOf(const std::vector<NamedMesh>& meshes) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < meshes.size(); ++i)
    for (std::size_t k = 0; k < smoothWarps.size(); ++k)
      if (!isSanitized || (i + k) % 3 == 0)
        pairs.push_back(
            {meshes[i].name + ", " + smoothWarps[k].name, meshes[i].mesh, smoothWarps[k].warp});
  return pairs;
}

Refined refineWith(const Mesh& mesh, const PointWarp& warp, float tolerance,
                   float angle = infinity) {
  return subdivide(mesh, {tolerance, angle}, onMeshes(warp));
}

TEST(Subdivide, TestMeshesHaveTheirExpectedTopology) {
  for (const auto& [name, mesh] : closedMeshes()) {
    EXPECT_TRUE(isClosed(mesh)) << name;
    EXPECT_EQ(eulerCharacteristic(mesh), 2) << name;
    EXPECT_GT(signedVolume(mesh), 0.8 * 4 / 3 * 3.14 * 50 * 50 * 50) << name;
  }
}

TEST(Subdivide, ClosedSurfacesStayClosedWithTheSameAreaAndVolume) {
  const auto meshes = closedMeshes();
  for (const auto& [name, mesh, warp] : pairsOf(meshes)) {
    SCOPED_TRACE(name);
    const Refined result = refineWith(mesh, warp, 0.3f, 0.2f);
    EXPECT_GT(result.mesh.triangleCount(), mesh.triangleCount());
    EXPECT_TRUE(isClosed(result.mesh));
    EXPECT_EQ(eulerCharacteristic(result.mesh), 2);
    EXPECT_NEAR(totalArea(result.mesh) / totalArea(mesh), 1, 1e-6);
    EXPECT_NEAR(signedVolume(result.mesh) / signedVolume(mesh), 1, 1e-6);
  }
}

TEST(Subdivide, PreservesTheBorderOfAPlane) {
  const Refined result = refineWith(gridPlane(3, 100), bump, 0.1f);
  double border = 0;
  for (const auto& [edge, uses] : edgeUses(result.mesh)) {
    if (uses == std::pair(1, 1)) continue;
    EXPECT_EQ(uses.first + uses.second, 1);
    const auto& [a, b] = edge;
    EXPECT_TRUE((a[0] == b[0] && std::abs(a[0]) == 50) || (a[1] == b[1] && std::abs(a[1]) == 50));
    border += std::hypot(a[0] - b[0], a[1] - b[1]);
  }
  EXPECT_NEAR(border, 400, 1e-3);
  EXPECT_NEAR(totalArea(result.mesh), 10000, 1e-2);
}

TEST(Subdivide, MeetsTheTolerance) {
  auto meshes = closedMeshes();
  meshes.push_back({"plane of 2 triangles", gridPlane(1, 100)});
  meshes.push_back({"plane", gridPlane(8, 100)});
  for (const auto& [name, mesh, warp] : pairsOf(meshes)) {
    for (const float tolerance : {1.0f, 0.25f}) {
      const Refined result = refineWith(mesh, warp, tolerance);
      EXPECT_TRUE(result.reachedTolerance);
      EXPECT_LE(result.worst, tolerance);
      EXPECT_LE(geometricError(result.mesh, warp), tolerance)
          << name << ", " << result.mesh.triangleCount() << " triangles";
    }
  }
}

// Each edge has 8 waves, which are 0 at its ends, its middle, its quarters and eighths.
TEST(Subdivide, DetectsWavesThatAreZeroAtEdgeMidpoints) {
  const PointWarp warp = [](const Point& p) {
    const auto wave = [](double x) { return 3 * std::sin(2 * std::numbers::pi * 8 * x / 100); };
    return p + Point{wave(p[1]), wave(p[2]), wave(p[0])};
  };
  EXPECT_LE(geometricError(refineWith(cube(100), warp, 0.5f).mesh, warp, 6), 0.5);
  EXPECT_LE(geometricError(refineWith(gridPlane(1, 100), warp, 0.5f).mesh, warp, 6), 0.5);
}

TEST(Subdivide, DetectsABumpInsideATriangleWithStraightEdges) {
  const PointWarp warp = [](const Point& p) {
    const double distance = std::hypot(p[0] - 20, p[1] + 20);
    return p + Point{0, 0, 9 * std::pow(std::max(0.0, 1 - distance * distance / 144), 3)};
  };
  const Refined result = refineWith(gridPlane(1, 100), warp, 0.2f);
  EXPECT_LE(geometricError(result.mesh, warp, 40), 0.2);
}

TEST(Subdivide, RefinesForNormalsWhereTheToleranceIsMet) {
  const PointWarp ripples = [](const Point& p) {
    return p + Point{0, 0, 0.2 * std::sin(0.7 * p[0])};  // slopes up to 8 degrees
  };
  const Mesh plane = gridPlane(1, 100);
  EXPECT_EQ(refineWith(plane, ripples, 0.5f).mesh.indices, plane.indices);
  const float angle = 0.03f;
  const Refined result = refineWith(plane, ripples, 0.5f, angle);
  EXPECT_TRUE(result.reachedTolerance);
  EXPECT_TRUE(result.reachedAngle);
  for (std::size_t i = 0; i < result.mesh.triangleCount(); ++i) {
    const auto corners = cornersOf(result.mesh, i);
    std::array<Point, 3> normals;
    for (int j = 0; j < 3; ++j) normals[j] = warpedNormal(ripples, corners[j], {0, 0, 1});
    for (const double t : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      const Point between = (1 - t) * normals[0] + t * normals[1];
      const Point normal = warpedNormal(ripples, (1 - t) * corners[0] + t * corners[1], {0, 0, 1});
      EXPECT_LE(std::asin(length(cross(normal, between)) / length(between)), 1.01 * angle);
    }
  }
}

TEST(Subdivide, DoesNotSplitUnderLinearWarps) {
  const PointWarp rotate = [](const Point& p) { return rotateAboutY(p + Point{3, 70, -8}, 0.7); };
  const PointWarp shear = [](const Point& p) {
    return Point{2 * p[0] + p[1], p[1] - 3 * p[2] + 70, 0.5 * p[2]};
  };
  for (const auto& [name, mesh] : closedMeshes()) {
    for (const Refined& result :
         {refineWith(mesh, rotate, 1e-3f, 0.01f), refineWith(mesh, shear, 1e-3f)}) {
      EXPECT_EQ(result.mesh.indices, mesh.indices) << name;
      EXPECT_EQ(result.mesh.positions, mesh.positions) << name;
      EXPECT_TRUE(result.reachedTolerance) << name;
      EXPECT_LE(result.worst, 1e-3f) << name;
    }
  }
}

TEST(Subdivide, NeverExceedsMaxTriangles) {
  for (const std::size_t maxTriangles : {0, 12, 13, 14, 100, 1001, 5000}) {
    for (const float angle : {infinity, 0.05f}) {
      const Refined result =
          subdivide(cubeOfFaces(100), {0.001f, angle, maxTriangles}, onMeshes(sines));
      EXPECT_LE(result.mesh.triangleCount(), std::max<std::size_t>(maxTriangles, 12));
      EXPECT_GE(result.mesh.triangleCount() + 2, maxTriangles);
      EXPECT_FALSE(result.reachedTolerance);
      EXPECT_GT(result.worst, 0.001f);
      EXPECT_TRUE(isClosed(result.mesh)) << maxTriangles;
    }
  }
}

TEST(Subdivide, SplitsTheWorstTriangleFirst) {
  const PointWarp twoBumps = [](const Point& p) {
    const auto bumpAt = [&](double x) {
      return std::exp(-((p[0] - x) * (p[0] - x) + p[1] * p[1]) / 200);
    };
    return p + Point{0, 0, 20 * bumpAt(-25) + 0.5 * bumpAt(25)};
  };
  const Mesh plane = gridPlane(10, 100);
  const Refined result = subdivide(plane, {0.01f, infinity, 230}, onMeshes(twoBumps));
  EXPECT_EQ(result.mesh.triangleCount(), 230u);
  for (std::size_t i = plane.vertexCount(); i < result.mesh.vertexCount(); ++i)
    EXPECT_LT(result.mesh.positions[3 * i], 0);
}

TEST(Subdivide, LocalWarpsNeedAtMostAThirdOfTheTriangles) {
  const Mesh mesh = cubeOfFaces(100);
  for (const auto& [name, warp] :
       {NamedWarp{"bump", bump}, {"twist near one end", twistNearOneEnd}, {"genie", genie}}) {
    const Refined adaptive = refineWith(mesh, warp, 0.2f);
    // The finest uniform subdivision with less than three times as many triangles.
    const Mesh uniform = subdivideUniformly(mesh, 20, 3 * adaptive.mesh.triangleCount() - 1).mesh;
    EXPECT_GT(geometricError(uniform, warp), geometricError(adaptive.mesh, warp)) << name;
  }
}

TEST(Subdivide, IsDeterministic) {
  const Mesh mesh = sphereWithSeam(16, 8, 50);
  const Refined a = subdivide(mesh, {0.01f, 0.1f, 3000}, onMeshes(genie));
  const Refined b = subdivide(mesh, {0.01f, 0.1f, 3000}, onMeshes(genie));
  EXPECT_EQ(a.mesh.positions, b.mesh.positions);
  EXPECT_EQ(a.mesh.indices, b.mesh.indices);
}

TEST(Subdivide, EvaluatesTheWarpAFewTimesPerVertex) {
  std::size_t evaluations = 0;
  const WarpFunction warp = onMeshes(genie);
  const Refined result = subdivide(sphereWithSeam(32, 16, 50), {0.01f}, [&](const Mesh& vertices) {
    evaluations += vertices.vertexCount();
    return warp(vertices);
  });
  // Each vertex takes one evaluation itself, 5 on each of about 3 edges, and 4 in each of 2
  // triangles. Edges and triangles that were split had been sampled before: a third as many again.
  // In addition, a grid of 320 by 320 points per square of the mesh's size is evaluated once, here
  // on 3.14 squares: a coarser grid could miss a spike with a width of a 200th of the mesh.
  EXPECT_GT(result.mesh.vertexCount(), 10000u);
  EXPECT_LT(evaluations, 32 * result.mesh.vertexCount() + 322000);
}

TEST(Subdivide, UniformSubdivisionSplitsEachTriangleIntoFour) {
  for (const auto& [name, mesh] : closedMeshes()) {
    const Mesh finer = subdivideUniformly(mesh, 3).mesh;
    EXPECT_EQ(finer.triangleCount(), 64 * mesh.triangleCount()) << name;
    EXPECT_TRUE(isClosed(finer)) << name;
    EXPECT_EQ(eulerCharacteristic(finer), 2) << name;
    EXPECT_NEAR(signedVolume(finer) / signedVolume(mesh), 1, 1e-6) << name;
  }
  EXPECT_EQ(subdivideUniformly(cube(1), 0).mesh.indices, cube(1).indices);
  EXPECT_EQ(subdivideUniformly(cube(1), 9, 12 * 16).mesh.triangleCount(), 12u * 16);
  EXPECT_EQ(subdivideUniformly(cube(1), 9, 12 * 16).levels, 2);
  EXPECT_EQ(subdivideUniformly(cube(1), 2, 12 * 16).levels, 2);
  EXPECT_EQ(subdivideUniformly(Mesh{}, 9).levels, 9);
  EXPECT_EQ(subdivideUniformly(cube(1), 9, 12 * 16 - 1).mesh.triangleCount(), 12u * 4);
}

}  // namespace
}  // namespace warpjet
