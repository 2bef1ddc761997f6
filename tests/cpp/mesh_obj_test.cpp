// Wavefront OBJ: the meshes of valid files, and messages about broken lines.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "mesh/check.hpp"
#include "mesh/load.hpp"
#include "mesh/text/number.hpp"

namespace warpjet {
namespace {

using Floats = std::vector<float>;
using Indices = std::vector<std::uint32_t>;

Loaded load(const std::string& text) {
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());  // without a terminating zero
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

TEST(Obj, TriangulatesConvexPolygonsAsFans) {
  const Mesh mesh = meshOf(square + "f 1 2 3 4\n");
  EXPECT_EQ(mesh.positions, (Floats{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
  EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(mesh.normals, (Floats{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}));
  EXPECT_TRUE(mesh.uvs.empty() && mesh.colors.empty());
  EXPECT_EQ(meshOf(square + "v -1 0.5 0\nf 1 2 3 4 5").indices,
            (Indices{0, 1, 2, 0, 2, 3, 0, 3, 4}));
}

TEST(Obj, TriangulatesConcavePolygonsInsideTheirOutline) {
  // The area of the dart is 6. A fan around its first corner would not be inside it.
  const Mesh mesh = meshOf("v 0 0 0\nv 4 1 0\nv 0 4 0\nv 1 1 0\nf 1 2 3 4\n");
  double area = 0;
  for (std::size_t i = 0; i < mesh.triangleCount(); ++i) {
    const auto [a, b, c] = mesh.corners(i);
    const auto at = [&](std::uint32_t vertex, int k) { return mesh.positions[vertex * 3 + k]; };
    const float twice = (at(b, 0) - at(a, 0)) * (at(c, 1) - at(a, 1)) -
                        (at(b, 1) - at(a, 1)) * (at(c, 0) - at(a, 0));
    EXPECT_GT(twice, 0);
    area += twice / 2;
  }
  // Shoelace formula: (0 + 16 - 4 + 0) / 2.
  EXPECT_EQ(area, 6);
  EXPECT_EQ(mesh.normals, (Floats{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}));

  std::string circle, face = "f";
  for (int i = 1; i <= 5000; ++i) {
    const double angle = i / 5000.0 * 6.283185307179586;
    circle +=
        "v " + std::to_string(std::cos(angle)) + ' ' + std::to_string(std::sin(angle)) + " 0\n";
    face += ' ' + std::to_string(i);
  }
  EXPECT_EQ(load(circle + face).warnings,
            std::vector<std::string>{"Faces of more than 4,096 corners are treated as convex."});
}

TEST(Obj, IgnoresReferencesToMissingUvsAndNormals) {
  const std::vector<std::string> warning{
      "Faces refer to uvs or normals that do not exist; these are ignored."};
  for (const char* face : {"f 1/1/1 2/1/1 3/1/1", "f 1//1 2//2 3//3", "f 1/-1 2/0 3/7"}) {
    const Loaded loaded = load(square + face);
    ASSERT_TRUE(loaded.mesh) << loaded.problem;
    EXPECT_EQ(loaded.mesh->positions, (Floats{0, 0, 0, 1, 0, 0, 1, 1, 0}));
    EXPECT_EQ(loaded.mesh->normals, (Floats{0, 0, 1, 0, 0, 1, 0, 0, 1}));
    EXPECT_TRUE(loaded.mesh->uvs.empty());
    EXPECT_EQ(loaded.warnings, warning);
  }
  const Loaded partly = load(square + "vn 1 0 0\nf 1//1 2//2 3//1");
  EXPECT_EQ(partly.mesh->normals, (Floats{1, 0, 0, 0, 0, 1, 1, 0, 0}));
  EXPECT_EQ(partly.warnings, warning);
}

TEST(Obj, ReadsLinesThatEndInCarriageReturnsOnly) {
  const Mesh mesh = meshOf("# old\rv 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 \\\r2 3\r");
  EXPECT_EQ(mesh.positions, (Floats{0, 0, 0, 1, 0, 0, 0, 1, 0}));
  EXPECT_EQ(
      problemIn("v 0 0 0\rv 1 0 x\r"),
      "loadMesh: line 2 of the .obj has \"x\" where a number belongs; export the model again.");
}

std::string utf16(const std::string& text, bool isBigEndian, bool hasMark) {
  std::string wide;
  const auto put = [&](unsigned unit) {
    const char low = static_cast<char>(unit), high = static_cast<char>(unit >> 8);
    wide += isBigEndian ? high : low;
    wide += isBigEndian ? low : high;
  };
  if (hasMark) put(0xFEFF);
  for (const char c : text) put(static_cast<unsigned char>(c));
  return wide;
}

TEST(Obj, ReadsFilesWithAByteOrderMark) {
  const std::string mark = "\xEF\xBB\xBF";
  // If the mark makes a line unreadable, its vertex is missing and every face has wrong corners.
  const std::string spare = "v 7 7 7\nf 1 2 3\n";
  for (const std::string& text :
       {mark + square + spare, mark + "# made by\n" + square + spare,
        "# joined\n" + mark + square + spare, mark + mark + square + spare})
    EXPECT_EQ(meshOf(text).positions, (Floats{0, 0, 0, 1, 0, 0, 1, 1, 0})) << text;
  std::string old = mark + square + spare;
  for (char& c : old) c = c == '\n' ? '\r' : c;
  EXPECT_EQ(meshOf(old).positions, (Floats{0, 0, 0, 1, 0, 0, 1, 1, 0}));
}

TEST(Obj, ReadsUtf16) {
  for (const bool isBigEndian : {false, true})
    for (const bool hasMark : {false, true})
      for (const std::string& text :
           {square + "f 1 2 3\n",
            square + "# long enough for the header of a binary .stl\nf 1 2 3\n",
            "# \xE4\n" + square + "f 1 2 3\r\n"})
        EXPECT_EQ(meshOf(utf16(text, isBigEndian, hasMark)).positions,
                  (Floats{0, 0, 0, 1, 0, 0, 1, 1, 0}))
            << isBigEndian << hasMark;
}

TEST(Obj, ReadsUtf16ThatEndsWithinACharacter) {
  // A high surrogate, whose low surrogate is missing.
  const std::string text = utf16(square + "f 1 2 3\n# ", false, true) + std::string("\x00\xD8", 2);
  EXPECT_EQ(meshOf(text).positions, (Floats{0, 0, 0, 1, 0, 0, 1, 1, 0}));
}

TEST(Obj, IgnoresInvalidNumbersThatNoFaceUses) {
  for (const char* bad : {"nan", "NaN", "-nan", "nan(ind)", "-nan(ind)", "-1.#IND", "1.#QNAN0",
                          "inf", "-Infinity", "1e99"}) {
    const std::string element = std::string(bad) + " 0 0\n";
    const Loaded loaded = load(square + "v " + element + "vn " + element + "vt " + element +
                               "vn 1 0 0\nvt 0 1\nf 1/2/2 2/2/2 3/2/2\n");
    ASSERT_TRUE(loaded.mesh) << bad << loaded.problem;
    EXPECT_EQ(loaded.mesh->positions, (Floats{0, 0, 0, 1, 0, 0, 1, 1, 0}));
    EXPECT_EQ(loaded.mesh->normals, (Floats{1, 0, 0, 1, 0, 0, 1, 0, 0}));
    EXPECT_TRUE(loaded.warnings.empty());
  }
}

TEST(Obj, ReplacesOnlyTheInvalidNormals) {
  const Loaded loaded =
      load(square + "vn nan 0 nan\nvn 1 0 0\nvt 0.5 nan\nvt 0.5 1\nf 1/2/2 2/1/1 3/2/2\n");
  ASSERT_TRUE(loaded.mesh) << loaded.problem;
  EXPECT_EQ(loaded.mesh->normals, (Floats{1, 0, 0, 0, 0, 1, 1, 0, 0}));
  EXPECT_EQ(loaded.mesh->uvs, (Floats{0.5f, 0, 0, 0, 0.5f, 0}));
  EXPECT_EQ(loaded.warnings,
            (std::vector<std::string>{
                "The .obj has invalid normals, which were replaced by computed ones.",
                "Invalid uvs of the .obj are set to 0."}));
}

TEST(Obj, SkipsFacesWithInvalidPositions) {
  const Loaded loaded = load(square + "v nan 0 0\nf 1 2 5\nf 1 2 3\n");
  ASSERT_TRUE(loaded.mesh) << loaded.problem;
  EXPECT_EQ(loaded.mesh->positions, (Floats{0, 0, 0, 1, 0, 0, 1, 1, 0}));
  EXPECT_EQ(loaded.warnings,
            std::vector<std::string>{"Triangles with invalid positions are left out."});
  EXPECT_EQ(
      problemIn(square + "v nan 0 0\nf 1 2 5\n"),
      "loadMesh: line 5 of the .obj has \"nan\" where a number belongs; export the model again.");
  const Loaded colored = load("v 0 0 0 nan 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3");
  ASSERT_TRUE(colored.mesh) << colored.problem;
  EXPECT_EQ((Floats{colored.mesh->colors.begin(), colored.mesh->colors.begin() + 8}),
            (Floats{1, 1, 1, 1, 0, 1, 0, 1}));
}

TEST(Obj, CountsNegativeIndicesFromTheEnd) {
  const Mesh mesh = meshOf("v 9 9 9\n" + square + "f -4 -3 -1\n");
  EXPECT_EQ(mesh.positions, (Floats{0, 0, 0, 1, 0, 0, 0, 1, 0}));
}

TEST(Obj, MakesOneVertexPerCombinationOfIndices) {
  const Mesh mesh = meshOf(square +
                           "vt 0 0\nvt 1 0.25\nvn 0 0 2\nvn 0 1 0\n"
                           "f 1/1/1 2/2/1 3/1/1\nf 1/1/1 3/1/1 4/2/2\nf 1/2/1 3/1/1 4/2/2\n");
  EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 0, 2, 3, 4, 2, 3}));
  // v grows upwards in an OBJ file and downwards in a Mesh.
  EXPECT_EQ(mesh.uvs, (Floats{0, 1, 1, 0.75f, 0, 1, 1, 0.75f, 1, 0.75f}));
  EXPECT_EQ(mesh.normals, (Floats{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 0, 1}));
}

TEST(Obj, FillsAttributesThatCornersOmit) {
  const Mesh mesh =
      meshOf(square + "vt 0.5 0.5\nvn 1 0 0\nf 1//1 2//1 3//1\nf 1/1 3/1 4/1\nf 1 3 4\n");
  EXPECT_EQ(mesh.vertexCount(), 9u);
  EXPECT_EQ(mesh.uvs,
            (Floats{0, 0, 0, 0, 0, 0, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(mesh.normals, (Floats{1, 0, 0, 1, 0, 0, 1, 0, 0,  //
                                  0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}));
}

TEST(Obj, ReadsColorsAfterPositions) {
  const Mesh mesh = meshOf("v 0 0 0 1 0 0.5\nv 1 0 0 1\nv 0 1 0 0 0.02 1 # six\nf 1 2 3\n");
  ASSERT_EQ(mesh.colors.size(), 12u);
  EXPECT_EQ(mesh.colors[0], 1);
  EXPECT_EQ(mesh.colors[1], 0);
  EXPECT_NEAR(mesh.colors[2], 0.214041f, 1e-6f);  // ((0.5 + 0.055) / 1.055) ^ 2.4
  EXPECT_EQ((Floats{mesh.colors.begin() + 3, mesh.colors.begin() + 9}), (Floats{1, 1, 1, 1, 1, 0}));
  EXPECT_NEAR(mesh.colors[9], 0.00154799f, 1e-8f);  // 0.02 / 12.92
}

TEST(Obj, ReadsColorsGivenAsBytes) {
  const Loaded bytes = load("v 0 0 0 255 0 51\nv 1 0 0\nv 0 1 0 1 255 128\nf 1 2 3");
  const Floats& colors = bytes.mesh->colors;
  ASSERT_EQ(colors.size(), 12u);
  EXPECT_EQ((Floats{colors.begin(), colors.begin() + 2}), (Floats{1, 0}));
  EXPECT_NEAR(colors[2], 0.0331048f, 1e-6f);  // ((0.2 + 0.055) / 1.055) ^ 2.4
  EXPECT_EQ((Floats{colors.begin() + 3, colors.begin() + 8}), (Floats{1, 1, 1, 1, 1}));
  EXPECT_NEAR(colors[8], 0.000303527f, 1e-9f);  // 1 / 255 / 12.92
  EXPECT_EQ(
      bytes.warnings,
      std::vector<std::string>{"The colours of the .obj are read as whole numbers from 0 to 255."});
}

TEST(Obj, ClampsColorsToTheUnitRange) {
  for (const char* text : {"1.5 -1 0", "256 -0.5 0", "3e38 -3e38 -0"}) {
    const Loaded clamped = load("v 0 0 0 " + std::string(text) + "\nv 1 0 0\nv 0 1 0\nf 1 2 3");
    EXPECT_EQ((Floats{clamped.mesh->colors.begin(), clamped.mesh->colors.begin() + 4}),
              (Floats{1, 0, 0, 1}));
    EXPECT_EQ(clamped.warnings,
              std::vector<std::string>{"Colours of the .obj outside 0 to 1 are clamped."});
  }
}

TEST(Obj, IgnoresUnknownStatements) {
  const Loaded loaded =
      load("# a comment\r\nmtllib a.mtl\r\no thing\r\ng part\r\ns off\r\n" + square +
           "\r\n  f 1 \\\r\n 2\t3 # a face\r\nl 1 2\r\nf 1 2\r\nusemtl wood");
  ASSERT_TRUE(loaded.mesh) << loaded.problem;
  EXPECT_EQ(loaded.mesh->indices, (Indices{0, 1, 2}));
  EXPECT_EQ(loaded.warnings,
            (std::vector<std::string>{
                "The materials of the .obj are left out, since \"a.mtl\" is missing.",
                "Faces of fewer than three corners are left out."}));
}

TEST(Obj, ReportsTheLineOfAnError) {
  const std::string again = "; export the model again.";
  EXPECT_EQ(
      problemIn(square + "f 1 2 5"),
      "loadMesh: line 5 of the .obj refers to position 5, but there are only 4 before it" + again);
  EXPECT_EQ(
      problemIn(square + "f 1 2 0"),
      "loadMesh: line 5 of the .obj refers to position 0, but there are only 4 before it" + again);
  EXPECT_EQ(
      problemIn("f 1 2 3"),
      "loadMesh: line 1 of the .obj refers to position 1, but there is none before it" + again);
  EXPECT_EQ(problemIn(square + "f 1/a 2/1 3/1"),
            "loadMesh: line 5 of the .obj has \"a\" where a face's corner belongs" + again);
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
    EXPECT_EQ(parseFloat(text), std::strtof(text, nullptr)) << text;
  for (const char* text :
       {"", "-", ".", "e5", "1e", "1e+", "1e5x", "1.2.3", "0x10", "inf", "--1", "1-"})
    EXPECT_EQ(parseFloat(text), std::nullopt) << text;
  std::mt19937 random(1);
  for (int i = 0; i < 100000; ++i) {
    const float number =
        std::ldexp(static_cast<float>(random()), static_cast<int>(random() % 60) - 60);
    char text[64];
    std::snprintf(text, sizeof text, i % 2 == 0 ? "%.9g" : "%.17f", static_cast<double>(number));
    const float expected = std::strtof(text, nullptr);
    const float parsed = parseFloat(text).value_or(NAN);
    EXPECT_TRUE(parsed >= std::nextafter(expected, 0.0f) &&
                parsed <= std::nextafter(expected, INFINITY))
        << text;
  }
}

}  // namespace
}  // namespace warpjet
