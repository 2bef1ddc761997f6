// Materials of OBJ files: the files they need, and their colors and images.
#include <gtest/gtest.h>

#include <cmath>

#include "gltf_builder.hpp"
#include "mesh/check.hpp"
#include "mesh/load.hpp"

namespace warpjet {
namespace {

using Floats = std::vector<float>;
using Names = std::vector<std::string>;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string twoParts =
    "mtllib a.mtl\n" + square + "usemtl red\nf 1 2 3\nusemtl half green\nf 1 3 4\n";
const std::string colors =
    "# two\nnewmtl red\nKa 0 0 0\nKd 1 0 0\n\nnewmtl half green\r\n\tKd 0 0.5 0\r\nd 0.5\n";

Loaded load(const std::string& text, const Files& files = {}) {
  Loaded loaded = loadMesh(bytesOf(text), files);
  EXPECT_EQ(loaded.problem, "");
  EXPECT_EQ(problemOf(loaded.mesh.value_or(Mesh{})), "");
  return loaded;
}

Files withMaterials(const std::string& text) { return {{"a.mtl", bytesOf(text)}}; }

Floats takeFirst(const Floats& numbers, std::size_t count) {
  return {numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count)};
}

TEST(Mtl, ColorsFacesByTheirMaterial) {
  for (const char* byteOrderMark : {"", "\xEF\xBB\xBF"}) {
    const Loaded loaded = load(twoParts, withMaterials(byteOrderMark + colors));
    const Mesh& mesh = *loaded.mesh;
    // Corners with two colors become two vertices.
    ASSERT_EQ(mesh.vertexCount(), 6u);
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ((Floats{&mesh.colors[4 * i], &mesh.colors[4 * i + 4]}), (Floats{1, 0, 0, 1}));
    EXPECT_NEAR(mesh.colors[13], 0.214041f, 1e-6f);  // ((0.5 + 0.055) / 1.055) ^ 2.4
    EXPECT_EQ(mesh.colors[12], 0);
    EXPECT_EQ(mesh.colors[15], 1);  // like p5, which doesn't read "d"
    EXPECT_TRUE(loaded.warnings.empty());
  }
}

TEST(Mtl, PreservesASingleColorAsTheMaterial) {
  const Loaded loaded =
      load("mtllib a.mtl\nusemtl red\n" + square + "f 1 2 3\nf 1 3 4", withMaterials(colors));
  EXPECT_TRUE(loaded.mesh->colors.empty());
  ASSERT_TRUE(loaded.mesh->material);
  EXPECT_EQ(loaded.mesh->material->baseColor, (std::array<float, 4>{1, 0, 0, 1}));
  EXPECT_EQ(loaded.mesh->vertexCount(), 4u);
}

TEST(Mtl, LeavesPartsWithoutMaterialWhiteAndMarksThemUnpainted) {
  const Loaded loaded =
      load("mtllib a.mtl\n" + square + "f 1 2 3\nusemtl red\nf 1 3 4", withMaterials(colors));
  EXPECT_EQ(takeFirst(loaded.mesh->colors, 4), (Floats{1, 1, 1, 1}));
  EXPECT_EQ((Floats{&loaded.mesh->colors[12], &loaded.mesh->colors[16]}), (Floats{1, 0, 0, 1}));
  EXPECT_EQ(loaded.mesh->painted, (std::vector<std::uint8_t>{0, 0, 0, 1, 1, 1}));
}

TEST(Mtl, MultipliesVertexColorsByTheMaterial) {
  const Loaded loaded =
      load("mtllib a.mtl\nusemtl red\nv 0 0 0 1 1 0\nv 1 0 0 0 1 1\nv 0 1 0\nf 1 2 3",
           withMaterials(colors));
  EXPECT_EQ(loaded.mesh->colors, (Floats{1, 1, 0, 1, 0, 1, 1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(loaded.mesh->material->baseColor, (std::array<float, 4>{1, 0, 0, 1}));
}

TEST(Mtl, ListsTheFilesThatItNeeds) {
  const File obj =
      bytesOf("mtllib sub\\my mat#1.mtl\nmtllib b.mtl\n" + square + "usemtl wood\nf 1 2 3\n");
  ModelFile model(obj);
  // The names after mtllib may be one name with spaces or several names, so both readings are
  // listed.
  const Names libraries{"sub/my%20mat%231.mtl", "sub/my", "mat%231.mtl", "b.mtl"};
  EXPECT_EQ(model.externalFiles(), libraries);
  Names all = libraries;
  all.push_back("sub/tex/oak%20100%25.png");
  EXPECT_EQ(
      model.externalFiles({{"sub/my%20mat%231.mtl",
                            bytesOf("newmtl wood\nmap_Kd -s 2 2 2 -clamp on tex\\oak 100%.png\n"
                                    "newmtl stone\nmap_Kd stone.png\n")}}),
      all);
  EXPECT_EQ(externalFiles(bytesOf("mtllib a.mtl\nv 0 0 0\nusemtl x\nmtllib a.mtl\n")),
            Names{"a.mtl"});
}

TEST(Mtl, ReadsTheColorTexture) {
  const File png = bytesOf("\x89PNG");
  Files files = withMaterials("newmtl red\nmap_Kd C:\\pictures\\a.png\n");
  files["a.png"] = png;
  const Loaded loaded =
      load("mtllib a.mtl\nusemtl red\n" + square + "vt 0 0\nf 1/1 2/1 3/1\n", files);
  ASSERT_TRUE(loaded.mesh->material && loaded.mesh->material->baseColorTexture);
  EXPECT_EQ(*loaded.mesh->material->baseColorTexture, (Image{png, "image/png"}));
  EXPECT_EQ(loaded.mesh->material->baseColor, (std::array<float, 4>{1, 1, 1, 1}));
  EXPECT_TRUE(loaded.warnings.empty());

  files.erase("a.png");
  EXPECT_EQ(load("mtllib a.mtl\nusemtl red\n" + square + "f 1 2 3\n", files).warnings,
            Names{"The texture \"a.png\" of the .mtl is missing or broken; it is ignored."});
  files = withMaterials("newmtl red\nmap_Kd a.png\nnewmtl blue\nmap_Kd b.png\n");
  files["a.png"] = files["b.png"] = png;
  EXPECT_EQ(
      load("mtllib a.mtl\nusemtl red\n" + square + "f 1 2 3\nusemtl blue\nf 1 3 4", files).warnings,
      Names{"The parts have different base-colour textures; only the first one is used."});
}

TEST(Mtl, WarnsAboutMissingMaterials) {
  EXPECT_EQ(load(twoParts).warnings,
            Names{"The materials of the .obj are ignored, since \"a.mtl\" is missing."});
  EXPECT_EQ(load("usemtl red\n" + square + "f 1 2 3").warnings,
            Names{"The materials of the .obj are ignored, since it names no .mtl file (mtllib)."});
  EXPECT_EQ(load(twoParts, withMaterials("newmtl red\nKd 1 0 0\n")).warnings,
            Names{"A material of the .obj is in none of its .mtl files; the faces that use it have "
                  "no colour."});
  // The mesh is the same as without materials.
  EXPECT_EQ(load(twoParts).mesh->vertexCount(), 4u);
  EXPECT_TRUE(load("mtllib a.mtl\n" + square + "f 1 2 3").warnings.empty());
}

TEST(Mtl, IgnoresInvalidColors) {
  for (const char* bad :
       {"Kd nan 0 0", "Kd", "Kd x", "Kd spectral a.rfl 1", "Kd xyz 1 1 1", "Kd 1 nan"})
    EXPECT_EQ(load("mtllib a.mtl\nusemtl red\n" + square + "f 1 2 3",
                   withMaterials("newmtl red\n" + std::string(bad)))
                  .mesh->painted.size(),
              0u)
        << bad;
  const Loaded grey = load("mtllib a.mtl\nusemtl red\n" + square + "f 1 2 3",
                           withMaterials("Kd 1 0 0\nnewmtl red\nKd 2"));
  EXPECT_EQ(grey.mesh->material->baseColor, (std::array<float, 4>{1, 1, 1, 1}));
  EXPECT_EQ(grey.warnings, Names{"Colours of the .mtl outside 0 to 1 are clamped."});
}

}  // namespace
}  // namespace warpjet
