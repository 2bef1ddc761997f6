// Wavefront OBJ: what its lines become, and what is said of broken ones.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "mesh/check.hpp"
#include "mesh/load.hpp"
#include "mesh/obj_text.hpp"

namespace warpjet {
namespace {

using Floats = std::vector<float>;
using Indices = std::vector<std::uint32_t>;

Loaded load(const std::string& text) {
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());  // no zero behind the end
  Loaded loaded = loadMesh(bytes);
  EXPECT_EQ(problemOf(loaded.mesh.value_or(Mesh{})), "");
  return loaded;
}

Mesh meshOf(const std::string& text) {
  const Loaded loaded = load(text);
  EXPECT_EQ(loaded.problem, "");
  return loaded.mesh.value_or(Mesh{});
}

std::string problemIn(const std::string& text) { return load(text).problem; }

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, MakesTrianglesOfPolygonsAsFans) {
  const Mesh mesh = meshOf(square + "f 1 2 3 4\n");
  EXPECT_EQ(mesh.positions, (Floats{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
  EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(mesh.normals, (Floats{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}));
  EXPECT_TRUE(mesh.uvs.empty() && mesh.colors.empty());
  EXPECT_EQ(meshOf(square + "v -1 0.5 0\nf 1 2 3 4 5").indices,
            (Indices{0, 1, 2, 0, 2, 3, 0, 3, 4}));
}

TEST(Obj, CountsNegativeIndicesFromTheEnd) {
  const Mesh mesh = meshOf("v 9 9 9\n" + square + "f -4 -3 -1\n");
  EXPECT_EQ(mesh.positions, (Floats{0, 0, 0, 1, 0, 0, 0, 1, 0}));
}

TEST(Obj, GivesEachCombinationItsVertex) {
  const Mesh mesh = meshOf(square +
                           "vt 0 0\nvt 1 0.25\nvn 0 0 2\nvn 0 1 0\n"
                           "f 1/1/1 2/2/1 3/1/1\nf 1/1/1 3/1/1 4/2/2\nf 1/2/1 3/1/1 4/2/2\n");
  EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 0, 2, 3, 4, 2, 3}));
  // v goes up in an OBJ and down in a Mesh.
  EXPECT_EQ(mesh.uvs, (Floats{0, 1, 1, 0.75f, 0, 1, 1, 0.75f, 1, 0.75f}));
  EXPECT_EQ(mesh.normals, (Floats{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 0, 1}));
}

TEST(Obj, FillsWhatCornersLeaveOut) {
  const Mesh mesh =
      meshOf(square + "vt 0.5 0.5\nvn 1 0 0\nf 1//1 2//1 3//1\nf 1/1 3/1 4/1\nf 1 3 4\n");
  EXPECT_EQ(mesh.vertexCount(), 9u);
  EXPECT_EQ(mesh.uvs,
            (Floats{0, 0, 0, 0, 0, 0, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(mesh.normals, (Floats{1, 0, 0, 1, 0, 0, 1, 0, 0,  //
                                  0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}));
}

TEST(Obj, ReadsColorsBehindPositions) {
  const Mesh mesh = meshOf("v 0 0 0 1 0 0.5\nv 1 0 0 1\nv 0 1 0 0 0.02 1 # six\nf 1 2 3\n");
  ASSERT_EQ(mesh.colors.size(), 12u);
  EXPECT_EQ(mesh.colors[0], 1);
  EXPECT_EQ(mesh.colors[1], 0);
  EXPECT_NEAR(mesh.colors[2], 0.214041f, 1e-6f);  // ((0.5 + 0.055) / 1.055) ^ 2.4
  EXPECT_EQ((Floats{mesh.colors.begin() + 3, mesh.colors.begin() + 9}), (Floats{1, 1, 1, 1, 1, 0}));
  EXPECT_NEAR(mesh.colors[9], 0.00154799f, 1e-8f);  // 0.02 / 12.92
}

TEST(Obj, PassesOverWhatItDoesNotKnow) {
  const Loaded loaded =
      load("# a comment\r\nmtllib a.mtl\r\no thing\r\ng part\r\ns off\r\n" + square +
           "\r\n  f 1 \\\r\n 2\t3 # a face\r\nl 1 2\r\nf 1 2\r\nusemtl wood");
  ASSERT_TRUE(loaded.mesh) << loaded.problem;
  EXPECT_EQ(loaded.mesh->indices, (Indices{0, 1, 2}));
  EXPECT_EQ(loaded.warnings,
            (std::vector<std::string>{"The materials of the .obj are ignored.",
                                      "Faces of fewer than three corners are left out."}));
}

TEST(Obj, NamesTheLineOfAFault) {
  const std::string again = "; export the model again.";
  EXPECT_EQ(problemIn(square + "f 1 2 5"),
            "loadMesh: line 5 of the .obj speaks of position 5, but only 4 came before it" + again);
  EXPECT_EQ(problemIn(square + "f 1 2 0"),
            "loadMesh: line 5 of the .obj speaks of position 0, but only 4 came before it" + again);
  EXPECT_EQ(problemIn(square + "f 1/1 2/1 3/1"),
            "loadMesh: line 5 of the .obj speaks of uv 1, but none came before it" + again);
  EXPECT_EQ(problemIn(square + "f 1 2 x"),
            "loadMesh: line 5 of the .obj has \"x\" where a face's corner belongs" + again);
  EXPECT_EQ(problemIn("v 0 \\\n0 0\nv 1 0,5 0"),
            "loadMesh: line 3 of the .obj has \"0,5\" where a number belongs" + again);
  EXPECT_EQ(problemIn("v 0 1e39 0"),
            "loadMesh: line 1 of the .obj has the number \"1e39\", which is too large" + again);
  EXPECT_EQ(problemIn("v 0 nan 0"),
            "loadMesh: line 1 of the .obj has \"nan\" where a number belongs" + again);
  EXPECT_EQ(problemIn("v 0 1"),
            "loadMesh: line 1 of the .obj has a position of fewer than 3 numbers" + again);
  EXPECT_EQ(problemIn(square),
            "loadMesh: there is nothing to draw: the .obj has no faces; export it with its faces.");
  for (const char* text : {"f", "hello", "f 99999999999999999999 1 1", "f -9223372036854775808 1 1",
                           "v 1 1 1\nf 1/ 1// 1/////", "v", "vt", "vn", "\\", "\\\n", "v 0 0 0 \\"})
    EXPECT_FALSE(load(text).problem.empty() && !load(text).mesh) << text;
}

TEST(Obj, ParsesNumbersLikeTheStandardLibrary) {
  for (const char* text :
       {"0", "-0", "1", "+1.5", ".5", "5.", "1e3", "1E+3", "1e-3", "0.1", "123456789",
        "3.4028234e38", "1.17549435e-38", "1e-45", "0.000000000000000000000001",
        "123456789012345678901234567890", "1e-400", "0e999999"})
    EXPECT_EQ(parsedFloat(text), std::strtof(text, nullptr)) << text;
  for (const char* text :
       {"", "-", ".", "e5", "1e", "1e+", "1e5x", "1.2.3", "0x10", "inf", "--1", "1-"})
    EXPECT_EQ(parsedFloat(text), std::nullopt) << text;
  std::mt19937 random(1);
  for (int i = 0; i < 100000; ++i) {
    const float number =
        std::ldexp(static_cast<float>(random()), static_cast<int>(random() % 60) - 60);
    char text[64];
    std::snprintf(text, sizeof text, i % 2 == 0 ? "%.9g" : "%.17f", static_cast<double>(number));
    const float expected = std::strtof(text, nullptr);
    const float came = parsedFloat(text).value_or(NAN);
    EXPECT_TRUE(came >= std::nextafter(expected, 0.0f) &&
                came <= std::nextafter(expected, INFINITY))
        << text;
  }
}

}  // namespace
}  // namespace warpjet
