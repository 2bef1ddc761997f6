// Subdivision: attributes of new vertices, and degenerate meshes and warps.
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "conformity.hpp"
#include "mesh/refine/subdivide.hpp"
#include "shapes.hpp"
#include "warped.hpp"

namespace warpjet {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

Refined refineWith(const Mesh& mesh, const PointWarp& warp, float tolerance = 0.3f) {
  return subdivide(mesh, {tolerance}, onMeshes(warp));
}

TEST(SubdivideAttributes, AreInterpolatedLinearly) {
  Mesh plane = gridPlane(1, 100);
  for (std::size_t i = 0; i < plane.vertexCount(); ++i) {
    const Point p = pointOf(plane.positions, i);
    append(plane.colors, {p[0], p[1], p[0] - p[1], 0.5});
  }
  const Mesh result = refineWith(plane, bump).mesh;
  ASSERT_GT(result.vertexCount(), 30u);
  ASSERT_EQ(result.uvs.size(), 2 * result.vertexCount());
  ASSERT_EQ(result.colors.size(), 4 * result.vertexCount());
  for (std::size_t i = 0; i < result.vertexCount(); ++i) {
    const Point p = pointOf(result.positions, i);
    EXPECT_NEAR(result.uvs[2 * i], p[0] / 100 + 0.5, 1e-6);
    EXPECT_NEAR(result.uvs[2 * i + 1], p[1] / 100 + 0.5, 1e-6);
    EXPECT_NEAR(result.colors[4 * i], p[0], 1e-5);
    EXPECT_NEAR(result.colors[4 * i + 2], p[0] - p[1], 1e-5);
    EXPECT_EQ(result.colors[4 * i + 3], 0.5f);
  }
}

TEST(SubdivideAttributes, NewVerticesAndTrianglesRecordTheirOrigin) {
  const Mesh cube = cubeOfFaces(100);
  const Refined result = refineWith(cube, sines);
  const std::size_t before = cube.vertexCount(), after = result.mesh.vertexCount();
  ASSERT_GT(after, before);
  ASSERT_EQ(result.origins.ends.size(), 2 * (after - before));
  ASSERT_EQ(result.origins.triangles.size(), result.mesh.triangleCount());
  for (std::size_t i = before; i < after; ++i) {
    const std::uint32_t a = result.origins.ends[2 * (i - before)],
                        b = result.origins.ends[2 * (i - before) + 1];
    ASSERT_LT(std::max(a, b), i);
    const Point middle =
        0.5 * (pointOf(result.mesh.positions, a) + pointOf(result.mesh.positions, b));
    EXPECT_NEAR(length(middle - pointOf(result.mesh.positions, i)), 0, 1e-4);
  }
  // Each face has its own direction, and two triangles.
  for (std::size_t i = 0; i < result.mesh.triangleCount(); ++i) {
    const Point face = pointOf(cube.normals, cube.corners(result.origins.triangles[i])[0]);
    const Point normal = pointOf(result.mesh.normals, result.mesh.corners(i)[0]);
    EXPECT_NEAR(length(face - normal), 0, 1e-6);
  }
}

TEST(SubdivideAttributes, FacesPreserveTheirOwnAttributes) {
  const Mesh mesh = cubeOfFaces(100);
  const Mesh result = refineWith(mesh, sines).mesh;
  ASSERT_GT(result.triangleCount(), 300u);
  for (std::size_t i = 0; i < result.triangleCount(); ++i) {
    const Point outside = areaVector(cornersOf(result, i));
    for (std::size_t j = 3 * i; j < 3 * i + 3; ++j) {
      const Point normal = pointOf(result.normals, result.indices[j]);
      EXPECT_NEAR(length((1 / length(outside)) * outside - normal), 0, 1e-6);
      EXPECT_EQ(result.colors[4 * result.indices[j]], result.colors[4 * result.indices[3 * i]]);
    }
  }
}

TEST(SubdivideAttributes, OriginalVerticesAndMaterialAreUnchanged) {
  Mesh mesh = sphereWithSeam(12, 6, 50);
  mesh.material = Material{{1, 0.5f, 0, 1}, Image{{1, 2, 3}, "image/png"}};
  const Mesh result = refineWith(mesh, twist).mesh;
  EXPECT_EQ(result.material, mesh.material);
  const auto startsWith = [](const std::vector<float>& all, const std::vector<float>& first) {
    return std::equal(first.begin(), first.end(), all.begin());
  };
  EXPECT_TRUE(startsWith(result.positions, mesh.positions));
  EXPECT_TRUE(startsWith(result.normals, mesh.normals));
  EXPECT_TRUE(startsWith(result.uvs, mesh.uvs));
  EXPECT_TRUE(startsWith(result.tangents, mesh.tangents));
}

TEST(SubdivideAttributes, NormalsAndTangentsHaveUnitLength) {
  const Mesh result = refineWith(sphereWithSeam(12, 6, 50), twist).mesh;
  ASSERT_EQ(result.tangents.size(), 4 * result.vertexCount());
  for (std::size_t i = 0; i < result.vertexCount(); ++i) {
    EXPECT_NEAR(length(pointOf(result.normals, i)), 1, 1e-6);
    const float* const t = result.tangents.data() + 4 * i;
    EXPECT_NEAR(length({t[0], t[1], t[2]}), 1, 1e-6);
    EXPECT_EQ(t[3], 1);
  }
}

TEST(SubdivideAttributes, OppositeDirectionsGiveTheDirectionOfTheFirstVertex) {
  Mesh triangle;
  triangle.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  triangle.normals = {0, 0, 1, 0, 0, -1, 0, 0, 0};
  triangle.tangents = {1, 0, 0, -1, -1, 0, 0, 1, 0, 1, 0, 1};
  const Mesh result = subdivideUniformly(triangle, 1).mesh;
  ASSERT_EQ(result.vertexCount(), 6u);
  for (std::size_t i = 3; i < 6; ++i) {
    if (pointOf(result.positions, i) != Point{0.5, 0, 0}) continue;
    EXPECT_EQ(pointOf(result.normals, i), (Point{0, 0, 1}));
    const std::vector<float> tangent(result.tangents.data() + 4 * i,
                                     result.tangents.data() + 4 * i + 4);
    EXPECT_EQ(tangent, (std::vector<float>{1, 0, 0, -1}));
  }
}

// The warp reads attributes: each face of the cube moves independently.
TEST(SubdivideAttributes, WarpsThatReadAttributesLeaveTheUnwarpedSurfaceClosed) {
  const WarpFunction warp = [](const Mesh& vertices) {
    Moved moved{vertices.positions, vertices.normals};
    for (std::size_t i = 0; i < vertices.vertexCount(); ++i) {
      const float up = 10 * std::sin(7 * vertices.uvs[2 * i]) * vertices.colors[4 * i];
      for (std::size_t j = 3 * i; j < 3 * i + 3; ++j)
        moved.positions[j] += up * vertices.normals[j];
    }
    return moved;
  };
  const Refined result = subdivide(cubeOfFaces(100), {0.1f}, warp);
  EXPECT_TRUE(result.reachedTolerance);
  EXPECT_GT(result.mesh.triangleCount(), 100u);
  EXPECT_TRUE(isClosed(result.mesh));
}

TEST(SubdivideOddMeshes, AMeshWithoutTrianglesIsUnchanged) {
  Mesh points;
  points.positions = {1, 2, 3, 4, 5, 6};
  for (const Mesh& mesh : {Mesh{}, points}) {
    const Refined result = refineWith(mesh, twist);
    EXPECT_EQ(result.mesh.positions, mesh.positions);
    EXPECT_TRUE(result.mesh.indices.empty());
    EXPECT_TRUE(result.reachedTolerance);
    EXPECT_EQ(subdivideUniformly(mesh, 3).mesh.positions, mesh.positions);
  }
}

TEST(SubdivideOddMeshes, AMeshWithoutIndicesGetsIndices) {
  const Mesh faces = cubeOfFaces(100);
  Mesh soup;
  for (const std::uint32_t i : faces.indices) {
    for (std::size_t j = 3 * i; j < 3 * i + 3; ++j) {
      soup.positions.push_back(faces.positions[j]);
      soup.normals.push_back(faces.normals[j]);
    }
  }
  const Mesh result = refineWith(soup, sines).mesh;
  EXPECT_EQ(result.triangleCount(), refineWith(faces, sines).mesh.triangleCount());
  EXPECT_TRUE(isClosed(result));
  EXPECT_EQ(eulerCharacteristic(result), 2);
}

// Three triangles in different planes meet in an edge, one of them twice. Also has triangles
// without area, and an unused vertex.
TEST(SubdivideOddMeshes, AnEdgeOfManyTrianglesIsSplitForAllOfThem) {
  Mesh mesh;
  mesh.positions = {0, -50, 0, 0, 50, 0, 70, 0, 0, -70, 5, 0, 0, 0, 70, 9, 9, 9, 0, 50, 0};
  mesh.indices = {0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 1, 4, 0, 0, 1, 3, 3, 3, 0, 1, 6};
  const Refined result = refineWith(mesh, waves);
  EXPECT_TRUE(result.reachedTolerance);
  EXPECT_LE(geometricError(result.mesh, waves), 1.25 * 0.3);
  EXPECT_EQ(pointOf(result.mesh.positions, 5), (Point{9, 9, 9}));

  const Refined twisted = refineWith(mesh, [](const Point& p) {
    return twist(p + Point{30, 0, 0});
  });
  int pieces = 0;
  for (const auto& [edge, uses] : edgeUses(twisted.mesh)) {
    const auto& [a, b] = edge;
    if (a[0] != 0 || b[0] != 0 || a[2] != 0 || b[2] != 0) continue;
    ++pieces;
    EXPECT_EQ(uses.first + uses.second, 4);  // without the triangles that have no area
  }
  EXPECT_GT(pieces, 2);
}

TEST(SubdivideOddMeshes, TrianglesWithoutAreaAreNotAllRemoved) {
  Mesh slit;
  slit.positions = {0, -50, 0, 0, 50, 0, 0, 50, 0};
  slit.indices = {0, 1, 2};
  const PointWarp bent = [](const Point& p) { return p + Point{0, 0, 10 * std::cos(0.05 * p[1])}; };
  EXPECT_EQ(refineWith(slit, bent).mesh.indices, slit.indices);
  EXPECT_EQ(subdivideUniformly(slit, 2).mesh.indices, slit.indices);
}

TEST(SubdivideOddMeshes, ATJunctionOfTheMeshStaysClosed) {
  Mesh
      mesh;  // the middle of the left triangle's side is a corner of the two triangles on the right
  mesh.positions = {0, -50, 0, 0, 50, 0, -50, 0, 0, 0, 0, 0, 50, 0, 0};
  mesh.indices = {0, 1, 2, 0, 4, 3, 3, 4, 1};
  const PointWarp bent = [](const Point& p) { return p + Point{0, 0, 10 * std::cos(0.05 * p[1])}; };
  const Refined result = refineWith(mesh, bent);
  EXPECT_TRUE(result.reachedTolerance);
  for (const auto& [edge, uses] : edgeUses(result.mesh)) {
    const bool isShared = edge.first[0] == 0 && edge.second[0] == 0;
    EXPECT_TRUE(!isShared || uses == std::pair(1, 1));
  }
}

TEST(SubdivideOddWarps, DoesNotSplitTrianglesAtNaNOrInfinity) {
  const Mesh mesh = cubeOfFaces(100);
  for (const float value : {nan, infinity, -infinity}) {
    const Refined result = subdivide(mesh, {0.1f}, [&](const Mesh& vertices) {
      return Moved{std::vector<float>(vertices.positions.size(), value), {}};
    });
    EXPECT_EQ(result.mesh.indices, mesh.indices);
  }
  // The warp is NaN on one half of the cube; the other half is refined.
  const PointWarp logarithm = [](const Point& p) { return p + Point{0, 0, 20 * std::log(p[0])}; };
  const Refined result = subdivide(mesh, {0.5f, infinity, 20000}, onMeshes(logarithm));
  EXPECT_TRUE(isClosed(result.mesh));
  EXPECT_LE(result.mesh.triangleCount(), 20000u);
}

TEST(SubdivideOddWarps, TreatsMissingResultsOfAWarpAsNaN) {
  const Mesh mesh = cubeOfFaces(100);
  EXPECT_EQ(subdivide(mesh, {0.1f}, [](const Mesh&) { return Moved{}; }).mesh.indices,
            mesh.indices);
  const Refined result = subdivide(mesh, {0.1f}, [](const Mesh&) {
    return Moved{{1, 2, 3}, {0, 0, 1}};
  });
  EXPECT_EQ(result.mesh.indices, mesh.indices);
}

TEST(SubdivideOddWarps, ATearAddsFewTriangles) {
  const PointWarp tear = [](const Point& p) { return p + Point{0, 0, p[0] > 13.7 ? 30.0 : 0.0}; };
  const Refined result = refineWith(cubeOfFaces(100), tear, 0.1f);
  EXPECT_LT(result.mesh.triangleCount(), 60000u);
  EXPECT_TRUE(isClosed(result.mesh));
}

TEST(SubdivideOddWarps, ACreaseAddsFewTriangles) {
  const PointWarp crease = [](const Point& p) {
    return p + Point{0, 0, std::max(0.0, 0.5 * (p[0] - 13.7))};
  };
  const Refined result = refineWith(cubeOfFaces(100), crease, 0.05f);
  EXPECT_TRUE(result.reachedTolerance);
  EXPECT_FALSE(result.reachedAngle);
  EXPECT_FALSE(result.isFull);
  EXPECT_GT(result.worstAngle, 0.17f);
  EXPECT_LT(result.mesh.triangleCount(), 6000u);
}

TEST(SubdivideOddWarps, TerminatesForAnyTolerance) {
  for (const float tolerance : {1e-7f, 1e-30f}) {
    Mesh small = cube(1e-3);
    const Refined result =
        subdivide(small, {tolerance, infinity, 1 << 18}, onMeshes([](const Point& p) {
                    return p + Point{0, 0, 1000 + 1e-4 * std::sin(1000 * p[0])};
                  }));
    // Floats near 1000 are 6e-5 apart, so subdivision would not change the result visibly.
    EXPECT_EQ(result.mesh.triangleCount(), 12u) << tolerance;
  }
  // An edge between two adjacent floats has no float at its middle.
  Mesh sliver;
  sliver.positions = {1, 0, 0, std::nextafter(1.0f, 2.0f), 0, 0, 1, 1e-7f, 0};
  const Refined result = subdivide(sliver, {1e-30f, infinity, 1 << 18}, [](const Mesh& vertices) {
    Moved moved{vertices.positions, {}};
    for (std::size_t i = 0; i < moved.positions.size(); ++i)
      moved.positions[i] = static_cast<float>(std::sin(1e20 * moved.positions[i]));
    return moved;
  });
  EXPECT_LE(result.mesh.triangleCount(), std::size_t{1} << 18);
}

}  // namespace
}  // namespace warpjet
