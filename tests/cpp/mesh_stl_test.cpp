// STL: the meshes of text and binary files, and messages about broken ones.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "gltf_builder.hpp"
#include "mesh/check.hpp"
#include "mesh/load.hpp"

namespace warpjet {
namespace {

using Floats = std::vector<float>;

Loaded load(const File& file) {
  const File exact(file.begin(), file.end());
  Loaded loaded = loadMesh(exact);
  EXPECT_EQ(problemOf(loaded.mesh.value_or(Mesh{})), "");
  return loaded;
}

Mesh meshOf(const File& file) {
  const Loaded loaded = load(file);
  EXPECT_EQ(loaded.problem, "");
  return loaded.mesh.value_or(Mesh{});
}

std::string facet(const std::string& normal) {
  return "  facet normal " + normal +
         "\n    outer loop\n      vertex 0 0 0\n      vertex 1 0 0\n      vertex 0 1 0\n"
         "    endloop\n  endfacet\n";
}

std::string solid(const std::string& facets) {
  return "solid thing\n" + facets + "endsolid thing\n";
}

// Returns a binary file. A facet is twelve numbers: its normal and three corners.
File binary(const std::vector<Floats>& facets, const std::string& header = "made by a test") {
  File file = bytesOf(header);
  file.resize(80);
  append32(file, facets.size());
  for (const Floats& facet : facets) {
    for (const float number : facet) {
      std::uint32_t bits;
      std::memcpy(&bits, &number, 4);
      append32(file, bits);
    }
    file.resize(file.size() + 2);
  }
  return file;
}

const Floats corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
const Floats tilted{0.6f, 0, 0.8f};
Floats facetWith(Floats normal) {
  normal.insert(normal.end(), corners.begin(), corners.end());
  return normal;
}
const Floats tiltedThrice{0.6f, 0, 0.8f, 0.6f, 0, 0.8f, 0.6f, 0, 0.8f};
const Floats upThrice{0, 0, 1, 0, 0, 1, 0, 0, 1};

TEST(Stl, ReadsTextFiles) {
  const Mesh mesh = meshOf(bytesOf(solid(facet("0.6 0 0.8"))));
  EXPECT_EQ(mesh.positions, corners);
  EXPECT_EQ(mesh.normals, tiltedThrice);
  EXPECT_TRUE(mesh.indices.empty() && mesh.uvs.empty() && mesh.colors.empty());
}

TEST(Stl, ReadsTextFilesWithUnusualFormatting) {
  const std::string facets = facet("0 0 1");
  std::string upper = solid(facets);
  for (char& c : upper) c = static_cast<char>(std::toupper(c));
  std::string windows, old;
  for (const char c : solid(facets)) {
    windows += c == '\n' ? "\r\n" : std::string(1, c);
    old += c == '\n' ? '\r' : c;
  }
  for (const std::string& text :
       {solid(facets), upper, windows, old, "\xEF\xBB\xBF" + solid(facets), "\n \t" + solid(facets),
        "solid\n" + facets + "endsolid", "solid facet normal\n" + facets + "endsolid",
        "solid a name of many words, 1e3\n" + facets,
        "solid thing\n" + facets + "end solid thing\n"})
    EXPECT_EQ(meshOf(bytesOf(text)).positions, corners) << text;
  EXPECT_EQ(meshOf(bytesOf(solid(facets) + solid(facets))).vertexCount(), 6u);
}

TEST(Stl, ReadsBinaryFiles) {
  const Mesh mesh = meshOf(binary({facetWith(tilted), facetWith({0, 0, 1})}));
  EXPECT_EQ(mesh.vertexCount(), 6u);
  EXPECT_EQ((Floats{mesh.positions.begin() + 9, mesh.positions.end()}), corners);
  EXPECT_EQ((Floats{mesh.normals.begin(), mesh.normals.begin() + 9}), tiltedThrice);
  EXPECT_EQ((Floats{mesh.normals.begin() + 9, mesh.normals.end()}), upThrice);
}

TEST(Stl, ReadsBinaryFilesWhoseHeaderLooksLikeText) {
  EXPECT_EQ(meshOf(binary({facetWith(tilted)}, "solid made by SolidWorks")).normals, tiltedThrice);
  EXPECT_EQ(
      meshOf(binary({facetWith(tilted)}, "solid\nfacet normal 0 0 1\nouter loop\n")).positions,
      corners);
  EXPECT_EQ(meshOf(binary({facetWith(tilted)}, "")).positions, corners);
  File longer = binary({facetWith(tilted)}, "solid made by SolidWorks");
  longer.resize(longer.size() + 7);
  EXPECT_EQ(meshOf(longer).positions, corners);
}

TEST(Stl, ReplacesMissingAndInvalidNormals) {
  const std::vector<std::string> warning{
      "The .stl has invalid normals, which were replaced by normals of the triangles."};
  for (const float bad : {NAN, INFINITY}) {
    const Loaded loaded = load(binary({facetWith({bad, 0, 0})}));
    EXPECT_EQ(loaded.mesh->normals, upThrice);
    EXPECT_EQ(loaded.warnings, warning);
  }
  // Many programs write zeros and leave the normal to the reader.
  const Loaded zeros = load(binary({facetWith({0, 0, 0})}));
  EXPECT_EQ(zeros.mesh->normals, upThrice);
  EXPECT_TRUE(zeros.warnings.empty());
  EXPECT_EQ(load(bytesOf(solid(facet("nan nan -nan(ind)")))).mesh->normals, upThrice);
  EXPECT_EQ(meshOf(binary({facetWith({0, 3, 0})})).normals, (Floats{0, 1, 0, 0, 1, 0, 0, 1, 0}));
}

TEST(Stl, SkipsFacetsWithInvalidPositions) {
  Floats broken = facetWith({0, 0, 1});
  broken[4] = NAN;
  const Loaded loaded = load(binary({broken, facetWith(tilted)}));
  EXPECT_EQ(loaded.mesh->positions, corners);
  EXPECT_EQ(loaded.warnings,
            std::vector<std::string>{"Triangles with invalid positions are left out."});
  EXPECT_NE(load(binary({broken})).problem.find("nothing to draw"), std::string::npos);
}

TEST(Stl, IgnoresColors) {
  // p5 doesn't show the colors either.
  const Loaded loaded = load(binary({facetWith(tilted)}, "COLOR=abcd,MATERIAL="));
  EXPECT_TRUE(loaded.mesh->colors.empty());
  EXPECT_EQ(loaded.warnings, std::vector<std::string>{"The colours of the .stl are left out."});
}

TEST(Stl, ReportsBrokenFiles) {
  const auto problem = [](const File& file) { return load(file).problem; };
  const auto problemOfText = [&](const std::string& text) { return problem(bytesOf(text)); };
  const std::string again = "; export the model again.";
  EXPECT_EQ(problemOfText("solid a\nendsolid a\n"),
            "loadMesh: there is nothing to draw: the .stl has no triangles" + again);
  EXPECT_EQ(problemOfText("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"),
            "loadMesh: the .stl ends in the middle of a facet; export or download it again.");
  EXPECT_EQ(problemOfText("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 x 0\n"),
            "loadMesh: line 4 of the .stl has \"x\" where a number belongs" + again);
  EXPECT_EQ(problemOfText("solid a\nfacet normal 0 0 1\nvertex 0 0 0\n"),
            "loadMesh: line 3 of the .stl has \"vertex\" where \"outer\" belongs" + again);
  EXPECT_EQ(problemOfText("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 "
                          "0\nendloop\nendfacet\n"),
            "loadMesh: line 6 of the .stl has \"endloop\" where \"vertex\" belongs" + again);
  EXPECT_EQ(problemOfText("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 "
                          "0\nvertex 0 1 0\nvertex 1 1 0\nendloop\nendfacet\n"),
            "loadMesh: line 7 of the .stl has \"vertex\" where \"endloop\" belongs" + again);
  EXPECT_EQ(problemOfText("solid a\nhello\n"),
            "loadMesh: line 2 of the .stl has \"hello\" where \"facet\" belongs" + again);
  File file = binary({facetWith(tilted), facetWith(tilted)});
  file.resize(file.size() - 1);
  EXPECT_EQ(problem(file),
            "loadMesh: the file ends in the middle of its data (expected 184 bytes, got 183); "
            "export or download it again.");
  File solidHeader = binary({facetWith(tilted), facetWith(tilted)}, "solid work");
  solidHeader.resize(150);
  EXPECT_NE(problem(solidHeader).find("184 bytes, got 150"), std::string::npos);
  EXPECT_NE(problem(binary({})).find("nothing to draw"), std::string::npos);
  for (std::size_t size = 1; size < file.size(); ++size)
    EXPECT_NE(problem({file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size)}), "");
  const std::string text = solid(facet("0 0 1"));
  for (std::size_t size = 1; size < text.find("endfacet"); ++size)
    EXPECT_NE(problemOfText(text.substr(0, size)), "") << size;
}

}  // namespace
}  // namespace warpjet
