// Loading materials and their images from glTF files.
#include <gtest/gtest.h>

#include "load_support.hpp"

namespace warpjet {
namespace {

TEST(LoadMesh, PreservesAMaterialThatAllPartsShare) {
  const json look = {{"baseColorFactor", {0.5, 0.25, 1, 0.1}},
                     {"baseColorTexture", {{"index", 0}}}};
  const Mesh mesh = loadValid(materialFile(look, look).glb());
  ASSERT_TRUE(mesh.material);
  EXPECT_EQ(mesh.material->baseColor, (std::array<float, 4>{0.5f, 0.25f, 1, 0.1f}));
  EXPECT_EQ(mesh.material->baseColorTexture, (Image{{0x89, 'P', 'N', 'G'}, "image/png"}));
  EXPECT_TRUE(mesh.colors.empty());
  EXPECT_TRUE(warningsOf(materialFile(look, look).glb()).empty());
}

TEST(LoadMesh, ConvertsDifferingBaseColorsToVertexColors) {
  GltfBuilder file = materialFile({{"baseColorFactor", {0.5, 0.25, 1, 1}}}, json::object());
  file.tree["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] =
      file.floats({1, 1, 1, 0.5f, 0, 0, 0, 0, 0.5f, 0.5f, 0.5f, 1}, "VEC4");
  const Mesh mesh = loadValid(file.glb());
  EXPECT_EQ(mesh.material, Material{});
  EXPECT_EQ(mesh.colors, (Floats{0.5f, 0.25f, 1, 0.5f, 0, 0, 0, 0, 0.25f, 0.125f, 0.5f, 1,  //
                                 1,    1,     1, 1,    1, 1, 1, 1, 1,     1,      1,    1}));
}

TEST(LoadMesh, UsesTheFirstOfSeveralTextures) {
  const File file = materialFile(texture(1), texture(0)).glb();
  EXPECT_EQ(loadValid(file).material->baseColorTexture,
            (Image{{0xFF, 0xD8, 0xFF, 0xE0}, "image/jpeg"}));
  EXPECT_EQ(warningsOf(file),
            std::vector<std::string>{
                "The parts have different base-colour textures; only the first one is used."});
}

TEST(LoadMesh, ReadsImagesFromTheCallersFiles) {
  const File file = materialFile(texture(2), texture(2)).glb();
  EXPECT_EQ(externalFiles(file), std::vector<std::string>{"my%20wood.webp"});
  const File image = bytesOf("RIFF1234WEBPVP8 ");
  EXPECT_EQ(loadValid(file, {{"my%20wood.webp", image}}).material->baseColorTexture,
            (Image{image, "image/webp"}));
  EXPECT_EQ(loadValid(file).material, Material{});
  EXPECT_EQ(warningsOf(file),
            std::vector<std::string>{"The base-colour texture (image 2, \"my%20wood.webp\") "
                                     "is missing or broken; it is ignored."});
}

TEST(LoadMesh, WarnsAboutWhatItIgnores) {
  json look = texture(0);
  look["baseColorTexture"]["texCoord"] = 1;
  look["baseColorTexture"]["extensions"]["KHR_texture_transform"]["scale"] = {2, 2};
  GltfBuilder file = materialFile(look, look);
  file.tree["animations"] = {{{"channels", json::array()}, {"samplers", json::array()}}};
  file.tree["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
  EXPECT_EQ(warningsOf(file.glb()),
            (std::vector<std::string>{
                "The model has animations; they are ignored.",
                "The model has morph targets; they are ignored, and it keeps its base shape.",
                "A texture is moved or scaled by KHR_texture_transform, which is ignored.",
                "A texture uses other uvs than TEXCOORD_0, the only ones that are read."}));
}

}  // namespace
}  // namespace warpjet
