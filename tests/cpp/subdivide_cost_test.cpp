// Subdivision of meshes that would take minutes if all triangles were searched for each triangle.
#include <gtest/gtest.h>

#include <ctime>
#include <limits>

#include "mesh/refine/subdivide.hpp"
#include "shapes.hpp"
#include "warped.hpp"

namespace warpjet {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// Fails a test that takes long: each one takes about a second on a slow machine.
class SubdivideCost : public testing::Test {
 protected:
  void TearDown() override { EXPECT_LT(std::clock() - start_, 20 * CLOCKS_PER_SEC); }

 private:
  std::clock_t start_ = std::clock();
};

// Triangles coincide if several nodes of a file show one mesh at the same place.
TEST_F(SubdivideCost, CoincidentTrianglesAreSplitLikeOne) {
  constexpr std::uint32_t copies = 25000;
  Mesh mesh;
  for (std::uint32_t i = 0; i < copies; ++i) {
    append(mesh.positions, {0, 0, 0, 100, 0, 0, 0, 100, 0});
    mesh.indices.insert(mesh.indices.end(), {3 * i, 3 * i + 1, 3 * i + 2});
  }
  EXPECT_EQ(subdivideUniformly(mesh, 1).mesh.triangleCount(), 4 * copies);
  const PointWarp bowl = [](const Point& p) {
    return p + Point{0, 0, 0.002 * (p[0] * p[0] + p[1] * p[1])};
  };
  Mesh one;
  one.positions = {0, 0, 0, 100, 0, 0, 0, 100, 0};
  const auto triangles = [&](const Mesh& from) {
    return subdivide(from, {2, infinity}, onMeshes(bowl)).mesh.triangleCount();
  };
  EXPECT_GT(triangles(one), 1u);
  EXPECT_EQ(triangles(mesh), copies * triangles(one));
}

// A fan whose spokes get longer and longer: splitting one makes the next triangle a worse sliver,
// which is then split, and so on up to the last. The triangles are in reverse order.
TEST_F(SubdivideCost, ACascadeOfSliversIsFast) {
  constexpr int spokes = 50000;
  Mesh mesh;
  mesh.positions = {0, 0, 0};
  for (int i = 0; i <= spokes; ++i) {
    const double length = 100 + 1e-3 * i, angle = 1e-4 * i;
    append(mesh.positions, {length * std::cos(angle), length * std::sin(angle), 0});
  }
  for (std::uint32_t i = spokes; i > 0; --i) mesh.indices.insert(mesh.indices.end(), {0, i, i + 1});
  const PointWarp ridge = [](const Point& p) {
    return p + Point{0, 0, 20 * std::exp(-1e6 * p[1] * p[1]) * (1 - p[0] / 100)};
  };
  const Refined result = subdivide(mesh, {5, infinity, 2 * spokes + 1000}, onMeshes(ridge));
  EXPECT_GE(result.mesh.triangleCount(), 2u * spokes);
}

// Triangles whose area overflows a float must not get more samples than the mesh has for all.
TEST_F(SubdivideCost, HugeTrianglesShareTheSamplesOfTheMesh) {
  Mesh mesh;
  for (const float size : {1e15f, 1e30f, 1e30f, 1e30f, 1e30f})
    append(mesh.positions, {0, 0, 0, size, 0, 0, 0, size, 0});
  std::size_t evaluations = 0;
  const Refined result = subdivide(mesh, {1, infinity}, [&](const Mesh& vertices) {
    evaluations += vertices.vertexCount();
    return Moved{vertices.positions, {}};
  });
  EXPECT_EQ(result.mesh.triangleCount(), 5u);
  EXPECT_LT(evaluations, std::size_t{3} << 19);
}

}  // namespace
}  // namespace warpjet
