// Computed normals, compared with the known normals of simple meshes.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesh/check.hpp"
#include "mesh/surface/normals.hpp"
#include "shapes.hpp"

namespace warpjet {
namespace {

using Floats = std::vector<float>;

Mesh meshOf(Floats positions, std::vector<std::uint32_t> indices) {
  Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.indices = std::move(indices);
  return mesh;
}

void expectNear(const Floats& actual, const Floats& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) EXPECT_NEAR(actual[i], expected[i], 1e-6f) << i;
}

TEST(ComputeNormals, PointToTheSideFromWhichTrianglesAreCounterclockwise) {
  EXPECT_EQ(computeNormals(meshOf({0, 0, 0, 0, 2, 0, 0, 0, 3}, {})),
            (Floats{1, 0, 0, 1, 0, 0, 1, 0, 0}));
  EXPECT_EQ(computeNormals(meshOf({0, 0, 0, 0, 2, 0, 0, 0, 3}, {2, 1, 0})),
            (Floats{-1, 0, 0, -1, 0, 0, -1, 0, 0}));
}

TEST(ComputeNormals, DoNotDependOnTheDiagonalOfAQuad) {
  // The normal at a corner of a cube is its diagonal, however many triangles meet there: weighting
  // by angles ensures that, weighting by areas alone would not.
  Mesh cube =
      meshOf({-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1, -1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1},
             {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
              2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5});
  Floats diagonals = cube.positions;
  for (float& number : diagonals) number /= std::sqrt(3.0f);
  expectNear(computeNormals(cube), diagonals);
}

TEST(ComputeNormals, AreWeightedByAreaAndAngle) {
  // Two triangles meet at the origin: one with a right angle and the area 1/2, facing z, and one
  // with 45 degrees and the area 2, facing x. Twice the area times the angle is 1 * 90 for the
  // first and 4 * 45 for the second.
  const Floats normals =
      computeNormals(meshOf({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 2, 0, 0, 2, 2}, {0, 1, 2, 0, 3, 4}));
  const float length = std::sqrt(5.0f);
  expectNear({normals.begin(), normals.begin() + 3}, {2 / length, 0, 1 / length});
}

TEST(ComputeNormals, AreSharedByVerticesAtTheSamePosition) {
  // A roof of two sides without common vertices; 0 and -0 are the same position.
  const Floats normals =
      computeNormals(meshOf({0.0f, 0, 0, 0, 1, 0, -1, 0, -1, -0.0f, 0, 0, 1, 0, -1, 0, 1, 0}, {}));
  expectNear(normals, {0, 0, 1, 0, 0, 1, -std::sqrt(0.5f), 0, std::sqrt(0.5f),  //
                       0, 0, 1, std::sqrt(0.5f), 0, std::sqrt(0.5f), 0, 0, 1});
}

TEST(ComputeNormals, AreZeroIfNoTriangleDeterminesThem) {
  const Mesh mesh = meshOf({0, 0, 0, 1, 0, 0, 2, 0, 0, 9, 9, 9}, {0, 1, 2, 0, 0, 1});
  EXPECT_EQ(computeNormals(mesh), Floats(12, 0.0f));
  EXPECT_TRUE(computeNormals({}).empty());
}

TEST(ComputeNormals, UseTheFirstSideForVerticesOfBothSides) {
  EXPECT_EQ(computeNormals(meshOf({0, 0, 0, 1, 0, 0, 0, 1, 0}, {2, 1, 0, 0, 1, 2})),
            (Floats{0, 0, -1, 0, 0, -1, 0, 0, -1}));
}

// Gives every triangle its own vertices.
Mesh soupOf(const Mesh& mesh) {
  Mesh soup;
  for (const std::uint32_t i : mesh.indices)
    soup.positions.insert(soup.positions.end(), &mesh.positions[3 * i], &mesh.positions[3 * i] + 3);
  return soup;
}

// Adds each triangle again, facing the other way, with its own vertices.
Mesh addBackFaces(Mesh mesh) {
  const auto vertices = static_cast<std::uint32_t>(mesh.vertexCount());
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i < mesh.triangleCount(); ++i) {
    const auto [a, b, c] = mesh.corners(i);
    indices.insert(indices.end(), {a, b, c, vertices + b, vertices + a, vertices + c});
  }
  mesh.indices = indices;
  mesh.positions.insert(mesh.positions.end(), mesh.positions.begin(), mesh.positions.end());
  return mesh;
}

// Appends the opposite of each normal.
Floats addOpposites(Floats normals) {
  const std::size_t size = normals.size();
  for (std::size_t i = 0; i < size; ++i) normals.push_back(-normals[i]);
  return normals;
}

// Adds each triangle again, facing the other way, with the same vertices.
Mesh addBackFacesInPlace(Mesh mesh) {
  const std::size_t triangles = mesh.triangleCount();
  for (std::size_t i = 0; i < triangles; ++i) {
    const auto [a, b, c] = mesh.corners(i);
    mesh.indices.insert(mesh.indices.end(), {b, a, c});
  }
  return mesh;
}

Mesh saddle() {
  Mesh mesh = gridPlane(5, 2);
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3)
    mesh.positions[i + 2] = mesh.positions[i] * mesh.positions[i + 1];
  return mesh;
}

TEST(ComputeNormals, AreComputedPerSideOfTwoSidedSurfaces) {
  for (const Mesh& mesh : {saddle(), soupOf(saddle()), cube(2), soupOf(icosphere(2, 1))})
    expectNear(computeNormals(addBackFaces(mesh)), addOpposites(computeNormals(mesh)));
}

TEST(AddMissingNormals, GivesEachSideItsOwnVertices) {
  for (const Mesh& mesh : {saddle(), cube(2), icosphere(2, 1)}) {
    Mesh both = addBackFacesInPlace(mesh);
    addMissingNormals(both, std::vector<bool>(mesh.vertexCount()));
    EXPECT_EQ(problemOf(both), "");
    ASSERT_EQ(both.vertexCount(), 2 * mesh.vertexCount());
    const Floats front = computeNormals(mesh);
    expectNear({both.normals.begin(), both.normals.begin() + front.size()}, front);
    for (std::size_t i = mesh.triangleCount(); i < both.triangleCount(); ++i) {
      const auto after = both.corners(i), before = addBackFacesInPlace(mesh).corners(i);
      for (int k = 0; k < 3; ++k) {
        EXPECT_GE(after[k], mesh.vertexCount());
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_EQ(both.positions[3 * after[k] + axis], mesh.positions[3 * before[k] + axis]);
          EXPECT_NEAR(both.normals[3 * after[k] + axis], -front[3 * before[k] + axis], 1e-6f);
        }
      }
    }
  }
}

TEST(AddMissingNormals, PreservesExistingNormals) {
  Mesh mesh = addBackFacesInPlace(meshOf({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}));
  mesh.normals = {1, 0, 0, 0, 0, 0, 0, 1, 0};
  mesh.uvs = {1, 2, 3, 4, 5, 6};
  addMissingNormals(mesh, {true, false, true});
  EXPECT_EQ(mesh.normals, (Floats{1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, -1}));
  EXPECT_EQ(mesh.uvs, (Floats{1, 2, 3, 4, 5, 6, 3, 4}));
  EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 3, 0, 2}));
}

TEST(AddMissingNormals, ContinuesTheFacingSideIntoAOneSidedPart) {
  const Mesh mesh = saddle();
  Mesh half = mesh;
  half.indices.resize(mesh.indices.size() / 2);
  half = addBackFacesInPlace(half);
  half.indices.insert(half.indices.end(), mesh.indices.begin() + mesh.indices.size() / 2,
                      mesh.indices.end());
  addMissingNormals(half, std::vector<bool>(mesh.vertexCount()));
  const Floats front = computeNormals(mesh);
  expectNear({half.normals.begin(), half.normals.begin() + front.size()}, front);
}

TEST(AddMissingNormals, DoesNotMoveCorners) {
  std::mt19937 random(12);
  const auto below = [&](std::uint32_t end) { return static_cast<std::uint32_t>(random() % end); };
  for (int i = 0; i < 2000; ++i) {
    Mesh mesh;
    // Few positions, so that triangles coincide, touch and degenerate in every way.
    const std::uint32_t vertices = 3 + below(7);
    for (std::uint32_t k = 0; k < 3 * vertices; ++k)
      mesh.positions.push_back(static_cast<float>(below(2)));
    for (std::uint32_t k = 3 * (1 + below(12)); k-- > 0;) mesh.indices.push_back(below(vertices));
    std::vector<bool> hasNormal;
    for (std::uint32_t k = 0; k < vertices; ++k) hasNormal.push_back(below(4) == 0);
    const Mesh before = mesh;
    addMissingNormals(mesh, hasNormal);
    ASSERT_EQ(problemOf(mesh), "");
    for (std::size_t k = 0; k < mesh.indices.size(); ++k) {
      const std::uint32_t newVertex = mesh.indices[k], oldVertex = before.indices[k];
      ASSERT_TRUE(newVertex == oldVertex || (newVertex >= vertices && !hasNormal[oldVertex]));
      for (int axis = 0; axis < 3; ++axis)
        ASSERT_EQ(mesh.positions[3 * newVertex + axis], before.positions[3 * oldVertex + axis]);
    }
    for (std::uint32_t k = 0; k < mesh.vertexCount(); ++k) {
      const float* n = &mesh.normals[3 * k];
      const float length = std::hypot(n[0], n[1], n[2]);
      ASSERT_TRUE(length == 0 || std::abs(length - 1) < 1e-6f);
    }
  }
}

TEST(ComputeNormals, AreComputedPerSheetWhereThreeTwoSidedSheetsMeet) {
  const Mesh sheets =
      meshOf({0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 1, -1, 1, 0, 0, 0, 0, 0, 0, 1, -1, -1, 0},
             {0, 1, 2, 3, 4, 5, 6, 7, 8});
  const float half = std::sqrt(0.5f);
  Floats normals;
  for (const auto& normal : {Floats{0, 1, 0}, {-half, -half, 0}, {half, -half, 0}}) {
    for (int i = 0; i < 3; ++i) normals.insert(normals.end(), normal.begin(), normal.end());
  }
  expectNear(computeNormals(addBackFaces(sheets)), addOpposites(normals));
}

// A surface is repeated if several nodes of a file show one mesh at the same place.
TEST(ComputeNormals, AreNotAffectedByRepeatedSurfaces) {
  Mesh many;
  for (int i = 0; i < 40000; ++i) append(many.positions, {0, 0, 0, 1, 0, 0, 0, 1, 0});
  const Floats normals = computeNormals(addBackFaces(many));
  for (std::size_t i = 0; i < normals.size(); i += 3) {
    ASSERT_EQ(normals[i], 0);
    ASSERT_EQ(normals[i + 1], 0);
    ASSERT_EQ(normals[i + 2], i < normals.size() / 2 ? 1 : -1);
  }
}

TEST(ComputeNormals, AreCorrectForExtremeFloats) {
  for (const float size : {3e38f, 1e-38f, 1e-45f})
    EXPECT_EQ(computeNormals(meshOf({0, 0, 0, size, 0, 0, 0, size, 0}, {})),
              (Floats{0, 0, 1, 0, 0, 1, 0, 0, 1}))
        << size;
}

TEST(ProblemOf, ReportsTheArrayAndTheVertex) {
  const Mesh valid = meshOf({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2});
  EXPECT_EQ(problemOf(valid), "");
  EXPECT_EQ(problemOf({}), "");
  const auto problemAfter = [&](auto change) {
    Mesh mesh = valid;
    change(mesh);
    return problemOf(mesh);
  };
  EXPECT_EQ(problemAfter([](Mesh& mesh) { mesh.positions.pop_back(); }),
            "positions must hold 3 numbers a vertex, but hold 8.");
  EXPECT_EQ(problemAfter([](Mesh& mesh) { mesh.uvs.assign(5, 0); }),
            "uvs must hold 2 numbers a vertex, 6 for 3 vertices, but hold 5.");
  EXPECT_EQ(problemAfter([](Mesh& mesh) { mesh.positions[4] = NAN; }),
            "positions must be finite numbers, but vertex 1 has NaN.");
  EXPECT_EQ(problemAfter([](Mesh& mesh) { mesh.colors.assign(12, INFINITY); }),
            "colors must be finite numbers, but vertex 0 has Infinity.");
  EXPECT_EQ(problemAfter([](Mesh& mesh) { mesh.tangents.assign(9, 0); }),
            "tangents must hold 4 numbers a vertex, 12 for 3 vertices, but hold 9.");
  EXPECT_EQ(problemAfter([](Mesh& mesh) { mesh.normals.assign(12, 0); }),
            "normals must hold 3 numbers a vertex, 9 for 3 vertices, but hold 12.");
  EXPECT_EQ(problemAfter([](Mesh& mesh) { mesh.indices[1] = 3; }),
            "index 3 has no vertex; there are only 3 vertices, counted from 0.");
  EXPECT_EQ(problemAfter([](Mesh& mesh) { mesh.indices.pop_back(); }),
            "every three indices make a triangle, but there are 2 indices.");
  EXPECT_EQ(problemAfter([](Mesh& mesh) {
              mesh.indices.clear();
              mesh.positions.resize(12);
            }),
            "without indices every three vertices make a triangle, but there are 4 vertices.");
}

}  // namespace
}  // namespace warpjet
