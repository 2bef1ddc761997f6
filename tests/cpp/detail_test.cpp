// Tests detail: tessellations of triangles, the numbers of pieces that edges need, and divided
// meshes.
#include "detail/detail.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "detail/tessellation.hpp"
#include "detail_support.hpp"

namespace warpjet {
namespace {

using glm::dvec2;

// Returns the points of a tessellation in the triangle (0, 0), (1, 0), (0, 1).
std::vector<dvec2> pointsOf(const SidePieces& pieces, const Tessellation& tessellation) {
  const std::array corners{dvec2(0), dvec2(1, 0), dvec2(0, 1)};
  std::vector<dvec2> points;
  for (int side = 0; side < 3; ++side) {
    for (std::uint32_t i = 0; i < pieces[side]; ++i) {
      const double t = static_cast<double>(i) / pieces[side];
      points.push_back(corners[side] * (1 - t) + corners[(side + 1) % 3] * t);
    }
  }
  for (const auto& w : tessellation.inner)
    points.push_back(corners[0] * double{w[0]} + corners[1] * double{w[1]} +
                     corners[2] * double{w[2]});
  return points;
}

// Returns the triangles with the diagonals that are shorter if the sides have these squares.
std::vector<Corners> trianglesFor(const Tessellation& tessellation, const SquaredSides& sides) {
  std::vector<Corners> triangles;
  for (std::size_t i = 0; i < tessellation.triangles.size(); ++i)
    triangles.push_back(withShorterDiagonal(tessellation.triangles, tessellation.flips, i, sides));
  return triangles;
}

void expectCover(const SidePieces& pieces, const SquaredSides& squares = {}) {
  SCOPED_TRACE(testing::Message() << pieces[0] << ", " << pieces[1] << ", " << pieces[2]);
  const Tessellation tessellation = makeTessellation(pieces);
  const std::vector<dvec2> points = pointsOf(pieces, tessellation);
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  double sum = 0;
  for (const Corners& t : trianglesFor(tessellation, squares)) {
    const dvec2 u = points[t[1]] - points[t[0]], v = points[t[2]] - points[t[0]];
    const double area = u.x * v.y - u.y * v.x;
    EXPECT_GT(area, 1e-9);
    sum += area;
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(sides.emplace(t[i], t[(i + 1) % 3]).second);
  }
  EXPECT_NEAR(sum, 1, 1e-6);
  // Sides without a neighbor are the pieces of the triangle's sides, each from its point to the
  // next.
  const std::uint32_t around = pieces[0] + pieces[1] + pieces[2];
  std::uint32_t open = 0;
  for (const auto& [a, b] : sides) {
    if (sides.count({b, a})) continue;
    ++open;
    EXPECT_EQ(b, (a + 1) % around);
  }
  EXPECT_EQ(open, around);
}

// Tests only some of the finest tessellations: all 2,197 would take minutes under the sanitizers.
TEST(Detail, TessellationsCoverTheTriangle) {
  for (const std::uint32_t a : pieceCounts)
    for (const std::uint32_t b : pieceCounts)
      for (const std::uint32_t c : pieceCounts)
        if (a <= 12 && b <= a && c <= a) expectCover({a, b, c});
  for (const SidePieces& pieces : {SidePieces{32, 32, 32},
                                   {32, 1, 1},
                                   {1, 32, 1},
                                   {32, 24, 1},
                                   {16, 32, 16},
                                   {4, 32, 4},
                                   {24, 12, 16},
                                   {2, 3, 32}})
    expectCover(pieces);
}

TEST(Detail, TessellationsWithFlippedDiagonalsCoverTheTriangle) {
  for (const SidePieces& pieces : {SidePieces{3, 3, 1}, {1, 12, 8}, {6, 1, 4}, {8, 24, 16}}) {
    std::size_t flips = 0;
    for (const SquaredSides& squares : {SquaredSides{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {9, 4, 1}}) {
      expectCover(pieces, squares);
      const Tessellation tessellation = makeTessellation(pieces);
      if (trianglesFor(tessellation, squares) != tessellation.triangles) ++flips;
    }
    EXPECT_GT(flips, 0u);
  }
}

// Returns the length of the longest side of all triangles, if the sides of the whole triangle have
// these lengths.
double longestSide(const SidePieces& pieces, std::array<double, 3> sides) {
  const auto [bottom, right, left] = sides;
  const double x = (bottom * bottom + left * left - right * right) / (2 * bottom);
  const dvec2 first(bottom, 0), second(x, std::sqrt(left * left - x * x));
  const Tessellation tessellation = makeTessellation(pieces);
  const std::vector<dvec2> points = pointsOf(pieces, tessellation);
  const auto square = [](double length) { return static_cast<float>(length * length); };
  double longest = 0;
  for (const Corners& t :
       trianglesFor(tessellation, {square(bottom), square(right), square(left)})) {
    for (int i = 0; i < 3; ++i) {
      const dvec2 side = points[t[(i + 1) % 3]] - points[t[i]];
      longest = std::max(longest, length(side.x * first + side.y * second));
    }
  }
  return longest;
}

// With the diagonals for sides of 3, 3 and 1, the longest side is 1.6.
TEST(Detail, DiagonalsFollowTheLengthsOfTheSides) {
  EXPECT_LT(longestSide({3, 3, 1}, {2.94, 2.11, 0.9}), 1.01);
  EXPECT_LT(longestSide({3, 1, 3}, {2.94, 0.9, 2.11}), 1.01);
}

// Both long sides have about the same length, so the points of both should be connected along their
// whole length. Where all extra points are connected to the corner, the longest side is 2.7.
TEST(Detail, PointsOfAFinerSideAreConnectedEvenly) {
  EXPECT_LT(longestSide({1, 12, 8}, {0.9, 8.13, 7.4}), 1.3);
}

TEST(Detail, NPiecesOnEachSideMakeNSquaredTriangles) {
  for (const std::uint32_t n : pieceCounts)
    EXPECT_EQ(makeTessellation({n, n, n}).triangles.size(), std::size_t{n} * n);
}

TEST(Detail, TessellationsOfUnequalSidesAreNotAsFineAsTheirFinestSide) {
  EXPECT_LE(makeTessellation({8, 8, 1}).triangles.size(), 20u);
  EXPECT_LE(makeTessellation({32, 32, 1}).triangles.size(), 70u);
}

// Returns the unit square as two triangles.
BaseMesh square() {
  return BaseMesh({{3, false, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}}}, {{0, 1, 2}, {0, 2, 3}});
}

// Warps the samples of a mesh.
template <class F>
std::vector<float> warpedSamples(const BaseMesh& base, F&& f) {
  std::vector<float> warped = Interpolation(base).samples()[0].values;
  for (std::size_t i = 0; i < warped.size(); i += 3) f(&warped[i]);
  return warped;
}

// Updates needs for `viewAlongX`, with all triangles. Returns true if any number changed.
bool update(Needs& needs, const BaseMesh& base, const std::vector<float>& warped,
            float tolerance = 1) {
  std::vector<std::uint32_t> triangles(base.triangles().size());
  std::iota(triangles.begin(), triangles.end(), 0);
  needs.update({base, {}, warped, {}, {}, triangles}, std::array{viewAlongX()}, tolerance);
  return needs.areChanged();
}

std::uint32_t piecesBetween(const BaseMesh& base, const Needs& needs, std::uint32_t a,
                            std::uint32_t b) {
  for (const auto& [ends, edge, triangle] : base.sides()) {
    if (std::set{ends[0], ends[1]} == std::set{a, b}) return needs.pieces()[edge];
  }
  ADD_FAILURE() << "there is no such side";
  return 0;
}

TEST(Detail, AFlatSurfaceNeedsNoPieces) {
  const BaseMesh base = square();
  Needs needs;
  const auto sheared = warpedSamples(base, [](float* p) { p[2] = 3 * p[0] - p[1]; });
  EXPECT_FALSE(update(needs, base, sheared));
  for (const std::uint32_t pieces : needs.pieces()) EXPECT_EQ(pieces, 1u);
}

// z = c x y is straight along x and along y. Its Hessian is ((0, c), (c, 0)), whose absolute value
// is c I. With 100 c pixels, an edge of length 1 needs the root of 100 c / 8 * 4 / 3 / 0.6 pieces
// for an error of 0.6 pixels: 5.27 for c = 1.
TEST(Detail, ASaddleNeedsPiecesAlongItsStraightLines) {
  const BaseMesh base = square();
  Needs needs;
  const auto saddle = warpedSamples(base, [](float* p) { p[2] = p[0] * p[1]; });
  EXPECT_TRUE(update(needs, base, saddle));
  EXPECT_EQ(piecesBetween(base, needs, 0, 1), 6u);
  // The diagonal is longer by a factor of sqrt(2): 7.45.
  EXPECT_EQ(piecesBetween(base, needs, 0, 2), 8u);
  // Four times the tolerance halves the need: 2.64 and 3.73.
  Needs fewer;
  update(fewer, base, saddle, 4);
  EXPECT_EQ(piecesBetween(base, fewer, 0, 1), 3u);
  EXPECT_EQ(piecesBetween(base, fewer, 0, 2), 4u);
}

// z = c x^2 / 2 bends along x only.
TEST(Detail, ABendNeedsNoPiecesAcross) {
  const BaseMesh base = square();
  Needs needs;
  update(needs, base, warpedSamples(base, [](float* p) { p[2] = p[0] * p[0] / 2; }));
  EXPECT_EQ(piecesBetween(base, needs, 0, 1), 6u);
  EXPECT_EQ(piecesBetween(base, needs, 1, 2), 1u);
}

// A wave of 0.2 pixels up and down, whose samples have second differences of 0.8 pixels. These
// alone would ask for the root of 16 * 0.8 / 6 / 0.6 pieces: 1.9.
TEST(Detail, ATriangleThatIsCloseToAllSamplesIsNotDivided) {
  const BaseMesh base = square();
  const auto ripple = [&](float height) {
    return warpedSamples(base, [height](float* p) {
      p[2] = height * std::cos(4 * std::numbers::pi_v<float> * p[0]);
    });
  };
  Needs needs;
  EXPECT_FALSE(update(needs, base, ripple(0.002f)));
  EXPECT_TRUE(update(needs, base, ripple(0.006f)));
}

TEST(Detail, ErrorsAlongTheLineOfSightNeedNoPieces) {
  const BaseMesh base = square();
  Needs needs;
  update(needs, base, warpedSamples(base, [](float* p) { p[0] += 5 * p[1] * p[1]; }));
  EXPECT_EQ(piecesBetween(base, needs, 1, 2), 1u);
}

TEST(Detail, PiecesStayWhileTheyAreNotMuchMoreThanNeeded) {
  const BaseMesh base = square();
  Needs needs;
  const auto bend = [&](float c) {
    return update(needs, base, warpedSamples(base, [c](float* p) { p[2] = c * p[0] * p[0] / 2; }));
  };
  EXPECT_TRUE(bend(1));       // needs 5.27, gets 6
  EXPECT_FALSE(bend(0.75f));  // needs 4.56; 5 would do, but not for 1.1 times as much
  EXPECT_TRUE(bend(0.4f));    // needs 3.33, and 3.67 with 1.1
  EXPECT_EQ(piecesBetween(base, needs, 0, 1), 4u);
}

TEST(Detail, SamplesThatAreNotFiniteNeedNothing) {
  const BaseMesh base = square();
  Needs needs;
  update(needs, base, warpedSamples(base, [](float* p) { p[2] = std::sqrt(-1 - p[0]); }));
  for (const std::uint32_t pieces : needs.pieces()) EXPECT_EQ(pieces, 1u);
}

// Returns a tetrahedron whose faces share no vertices, so that all its edges are seams.
Detail facettedTetrahedron() {
  const float corners[4][3]{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int faces[4][3]{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  Detail detail({{3, false, std::vector<float>(36)}}, 4, {0, 2});
  std::size_t vertex = 0;
  for (const auto& face : faces) {
    for (const int corner : face) {
      for (int i = 0; i < 3; ++i) detail.given(0)[3 * vertex + i] = corners[corner][i];
      detail.givenIndices()[vertex] = static_cast<std::uint32_t>(vertex);
      ++vertex;
    }
  }
  detail.begin();
  return detail;
}

TEST(Detail, DividedMeshesHaveNoCracksAtSeams) {
  Detail detail = facettedTetrahedron();
  const auto wave = [](float* p) { p[2] += 0.7f * std::sin(5 * p[0] + 3 * p[1]); };
  EXPECT_TRUE(divide(detail, wave));
  EXPECT_GT(detail.division().triangles.size(), 20u);
  expectClosed(detail);
  EXPECT_EQ(detail.groups()[0], 0u);
  EXPECT_GT(detail.groups()[1], 2u);
  EXPECT_FALSE(divide(detail, wave));
}

// Spheres of three.js have such seams: vertices are at z = 0 on one side, and at -2e-14 on the
// other.
TEST(Detail, SidesOfSeamsThatDifferByRoundingShareAnEdge) {
  const BaseMesh base(
      {{3, false, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -2e-14f, 0, 1, 1e-14f, -1, 0, 0}}},
      {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(base.edgeOf(0, 2), base.edgeOf(1, 0));
  EXPECT_EQ(base.edgeCount(), 5u);
  const BaseMesh close({{3, false, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1e-4f, 0, 0, 0, 1, 0, -1, 0, 0}}},
                       {{0, 1, 2}, {3, 4, 5}});
  EXPECT_NE(close.edgeOf(0, 2), close.edgeOf(1, 0));
}

// Returns the positions of samples.
std::set<std::array<float, 3>> placesOf(const Detail& detail,
                                        const std::vector<std::uint32_t>& samples) {
  std::set<std::array<float, 3>> places;
  for (const std::uint32_t i : samples) {
    const float* p = &detail.samples()[0].values[3 * std::size_t{i}];
    places.insert({p[0], p[1], p[2]});
  }
  return places;
}

// The face of the tetrahedron in the plane x = 0 faces away. Of its triangles, only those next to
// other faces may need samples.
TEST(Detail, TrianglesThatFaceAwayNeedNoSamples) {
  Detail detail = facettedTetrahedron();
  while (detail.cut(0.1f)) {
  }
  warpSamples(detail, [](float*) {});
  ScreenView front = viewAlongX();
  front.facing = 1;
  const auto shown = placesOf(detail, show(detail, front));
  for (const auto& [x, y, z] : shown)
    EXPECT_TRUE(x > 0 || y < 0.11f || z < 0.11f || y + z > 0.89f) << y << ", " << z;
  // The view from behind adds the samples that are missing.
  ScreenView back = viewAlongX();
  back.facing = -1;
  const auto added = placesOf(detail, show(detail, back));
  EXPECT_TRUE(show(detail, viewAlongX()).empty());
  const std::vector<float>& samples = detail.samples()[0].values;
  for (std::size_t i = 3 * detail.base().vertexCount(); i < samples.size(); i += 3) {
    const std::array place{samples[i], samples[i + 1], samples[i + 2]};
    EXPECT_TRUE(place[0] == 0 || shown.count(place));
    EXPECT_TRUE(shown.count(place) || added.count(place));
  }
  // When the surface has moved, all of these samples are needed again.
  detail.forgetSamples();
  EXPECT_EQ(placesOf(detail, show(detail, front)), shown);
}

// The view ends at y = 0.1, or at 0.15 with its margin.
TEST(Detail, TrianglesOutsideOfTheViewNeedNoSamples) {
  Detail detail = facettedTetrahedron();
  while (detail.cut(0.1f)) {
  }
  warpSamples(detail, [](float*) {});
  ScreenView view = viewAlongX();
  view.clip[1][0] = 10;
  const auto shown = placesOf(detail, show(detail, view));
  for (const auto& [x, y, z] : shown) EXPECT_LT(y, 0.15f + 2 * 0.11f);
  const std::vector<float>& samples = detail.samples()[0].values;
  for (std::size_t i = 3 * detail.base().vertexCount(); i < samples.size(); i += 3)
    EXPECT_TRUE(samples[i + 1] > 0.1f || shown.count({samples[i], samples[i + 1], samples[i + 2]}));
}

TEST(Detail, CutsSidesToAMaximumLengthWithoutCracks) {
  Detail detail = facettedTetrahedron();
  int passes = 0;
  while (detail.cut(0.2f) && ++passes < 5) {
  }
  EXPECT_TRUE(divide(detail, hill));
  const std::vector<float>& p = detail.division().attributes[0].values;
  for (const Corners& t : detail.division().triangles) {
    for (int i = 0; i < 3; ++i) {
      float square = 0;
      for (int k = 0; k < 3; ++k)
        square += std::pow(p[3 * t[i] + k] - p[3 * t[(i + 1) % 3] + k], 2.0f);
      EXPECT_LE(std::sqrt(square), 0.2f * 1.11f);
    }
  }
  expectClosed(detail);
}

// Along x a phase runs through six of its steps.
TEST(Detail, CutsSidesByTheStepsOfPhases) {
  Detail detail({{3, false, {0, 0, 0, 1, 0, 0, 0, 1, 0}}}, 1, {});
  detail.givenIndices() = {0, 1, 2};
  detail.begin();
  detail.setPhases({1}, {1});
  std::vector<float>& phases = detail.phases();
  for (std::size_t i = 0; i < phases.size(); ++i) phases[i] = 6 * detail.samples()[0].values[3 * i];
  EXPECT_TRUE(detail.cut(10));
  // Six pieces on two sides, one on the third.
  EXPECT_GE(detail.sampleCount(), 6u);
  std::vector<float>& again = detail.phases();
  for (std::size_t i = 0; i < again.size(); ++i) again[i] = 6 * detail.samples()[0].values[3 * i];
  EXPECT_FALSE(detail.cut(10));
}

// Divides a mesh for a wave, and expects that it changes.
void divideWave(Detail& detail) {
  EXPECT_TRUE(divide(detail, [](float* p) { p[2] += 0.7f * std::sin(5 * p[0]); }));
}

// Cuts the two triangles of `square` into pieces no longer than this length.
Detail cutSquare(float maxLength) {
  Detail detail({{3, false, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}}}, 2, {0, 1});
  detail.givenIndices() = {0, 1, 2, 0, 2, 3};
  detail.begin();
  while (detail.cut(maxLength)) {
  }
  return detail;
}

// With a second derivative of 90 pixels along x everywhere, pieces of length h along x err by
// 90 h^2 / 8, and so do the diagonals. For a pixel, there must be 3.4 pieces of each side, and half
// a piece is to spare.
TEST(Detail, ASurfaceThatBendsEquallyEverywhereIsDividedUniformly) {
  Detail detail = cutSquare(0.1f);
  const auto bend = [](float* p) { p[2] = 0.45f * p[0] * p[0]; };
  EXPECT_TRUE(divide(detail, bend));
  EXPECT_EQ(detail.division().triangles.size(), 2u * 16);
  EXPECT_EQ(detail.groups(), (std::vector<std::uint32_t>{0, 16}));
  std::vector<std::uint32_t> origins(16, 0);
  origins.resize(32, 1);
  EXPECT_EQ(detail.origins(), origins);
  EXPECT_EQ(detail.lines({0, 2})[0], 5u);
  EXPECT_FALSE(divide(detail, bend));
  EXPECT_TRUE(divide(detail, hill));
  EXPECT_GT(detail.division().triangles.size(), 200u);
  EXPECT_TRUE(divide(detail, [](float*) {}));
  EXPECT_EQ(detail.division().triangles.size(), 2u);
}

// Moves the vertices by a linear map, which cuts and divisions commute with.
TEST(Detail, APoseMovesTheVerticesOfTheCutMesh) {
  const auto map = [](float* p) { std::tie(p[0], p[1], p[2]) = std::tuple(p[1], 2 * p[2], -p[0]); };
  Detail detail = facettedTetrahedron();
  while (detail.cut(0.3f)) {
  }
  std::vector<float> expected = detail.samples()[0].values;
  const std::uint32_t count = detail.sampleCount();
  for (std::size_t i = 0; i < expected.size(); i += 3) map(&expected[i]);
  for (std::size_t i = 0; i < detail.given(0).size(); i += 3) map(&detail.given(0)[i]);
  divideWave(detail);
  detail.pose();
  ASSERT_EQ(detail.sampleCount(), count);
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(detail.samples()[0].values[i], expected[i], 1e-6);
  // The mesh changes even if the numbers of pieces are the same.
  divideWave(detail);
  expectClosed(detail);
}

TEST(Detail, KnowsTheGivenTriangleOfEachDividedOne) {
  Detail detail = facettedTetrahedron();
  const std::vector<float> given = detail.given(0);
  while (detail.cut(0.3f)) {
  }
  divideWave(detail);
  const std::vector<std::uint32_t> origins = detail.origins();
  const Division& division = detail.division();
  ASSERT_EQ(origins.size(), division.triangles.size());
  std::array<int, 4> counts{};
  for (std::size_t t = 0; t < origins.size(); ++t) {
    ++counts[origins[t]];
    // All corners are in the plane of the given triangle.
    const auto place = [](const std::vector<float>& p, std::size_t i) {
      return glm::vec3(p[3 * i], p[3 * i + 1], p[3 * i + 2]);
    };
    const std::size_t first = 3 * std::size_t{origins[t]};
    const glm::vec3 a = place(given, first);
    const glm::vec3 normal = cross(place(given, first + 1) - a, place(given, first + 2) - a);
    for (const std::uint32_t corner : division.triangles[t])
      EXPECT_NEAR(dot(place(division.attributes[0].values, corner) - a, normal), 0, 1e-5);
  }
  for (const int count : counts) EXPECT_GT(count, 4);
}

TEST(Detail, LinesFollowTheDividedSides) {
  Detail detail = facettedTetrahedron();
  while (detail.cut(0.3f)) {
  }
  divideWave(detail);
  // The first two lines are one side, from either end. Vertices 3 and 4 are the ends of another
  // side; vertices 0 and 11 are at the same place.
  const std::vector<std::uint32_t> lines = detail.lines({1, 2, 2, 1, 3, 4, 0, 11});
  const std::vector<float>& p = detail.division().attributes[0].values;
  std::vector<std::vector<std::uint32_t>> all;
  for (std::size_t i = 0; i < lines.size(); i += lines[i] + 1)
    all.emplace_back(lines.begin() + i + 1, lines.begin() + i + 1 + lines[i]);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_GT(all[0].size(), 5u);
  EXPECT_EQ(all[1], std::vector<std::uint32_t>(all[0].rbegin(), all[0].rend()));
  EXPECT_GT(all[2].size(), 2u);
  EXPECT_EQ(all[3], (std::vector<std::uint32_t>{0, 11}));
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const Corners& t : detail.division().triangles)
    for (int i = 0; i < 3; ++i) sides.insert(std::minmax(t[i], t[(i + 1) % 3]));
  // Vertices 1 and 2 are the ends (0, 1, 0) and (1, 0, 0) of a straight line.
  for (std::size_t i = 0; i + 1 < all[0].size(); ++i) {
    const std::uint32_t a = all[0][i], b = all[0][i + 1];
    EXPECT_TRUE(sides.count(std::minmax(a, b)));
    EXPECT_NEAR(p[3 * b] + p[3 * b + 1], 1, 1e-6);
    EXPECT_GT(p[3 * b], p[3 * a]);
  }
}

// A triangle with two equal corners is a line: p5 draws some lines that are no sides of triangles.
TEST(Detail, LinesWithoutTrianglesNeedPieces) {
  const BaseMesh base({{3, false, {0, 0, 0, 1, 0, 0}}}, {{0, 1, 1}});
  Needs needs;
  update(needs, base, warpedSamples(base, [](float* p) { p[2] = p[0] * p[0] / 2; }));
  EXPECT_EQ(piecesBetween(base, needs, 0, 1), 6u);
}

}  // namespace
}  // namespace warpjet
