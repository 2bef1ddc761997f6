// Loading the scene of a glTF file: transforms, parts, file names and extensions. The expected
// numbers are computed by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "load_support.hpp"

namespace warpjet {
namespace {

// Returns a file whose only node has this transform, with a normal and a tangent per corner.
GltfBuilder transformFile(const json& transform) {
  GltfBuilder file;
  file.mesh({{"POSITION", file.floats({1, 0, 0, 0, 2, 0, 0, 0, 3}, "VEC3")},
             {"NORMAL", file.floats({0.6f, 0.8f, 0, 0, 0, 1, 0, 0, 0}, "VEC3")},
             {"TANGENT", file.floats({0.8f, -0.6f, 0, 1, 1, 0, 0, -1, 0, 1, 0, 1}, "VEC4")}});
  json node = {{"mesh", 0}};
  node.update(transform);
  file.node(node);
  return file;
}

TEST(LoadMesh, AppliesTranslationRotationAndScale) {
  // Scaled by (2, 1, 1), then rotated by 90 degrees around z: x to y, y to -x. Then translated.
  const float half = std::sqrt(0.5f);
  const Mesh mesh = loadValid(
      transformFile(
          {{"translation", {10, 20, 30}}, {"rotation", {0, 0, half, half}}, {"scale", {2, 1, 1}}})
          .glb());
  expectNear(mesh.positions, {10, 22, 30, 8, 20, 30, 10, 20, 33}, 1e-5f);
  // Normals, by the inverse transpose: (0.3, 0.8, 0) of length sqrt(0.73), rotated. The zero normal
  // remains zero.
  const float length = std::sqrt(0.73f);
  expectNear(mesh.normals, {-0.8f / length, 0.3f / length, 0, 0, 0, 1, 0, 0, 0});
  // Tangents, by the matrix itself: (1.6, -0.6, 0) of length sqrt(2.92), rotated.
  const float tangentLength = std::sqrt(2.92f);
  expectNear(mesh.tangents,
             {0.6f / tangentLength, 1.6f / tangentLength, 0, 1, 0, 1, 0, -1, -1, 0, 0, 1});
  EXPECT_TRUE(mesh.indices.empty());
}

TEST(LoadMesh, ReadsMatricesInColumnMajorOrder) {
  const Mesh mesh = loadValid(
      transformFile({{"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}}).glb());
  EXPECT_EQ(mesh.positions, (Floats{5, 7, 7, 3, 6, 7, 5, 6, 10}));
}

TEST(LoadMesh, ReversesTrianglesUnderAMirroringTransform) {
  const Mesh mesh = loadValid(transformFile({{"scale", {-1, 1, 1}}}).glb());
  EXPECT_EQ(mesh.positions, (Floats{-1, 0, 0, 0, 2, 0, 0, 0, 3}));
  expectNear(mesh.normals, {-0.6f, 0.8f, 0, 0, 0, 1, 0, 0, 0});
  expectNear(mesh.tangents, {-0.8f, -0.6f, 0, -1, -1, 0, 0, 1, 0, 1, 0, -1});
  EXPECT_EQ(mesh.indices, (Indices{0, 2, 1}));
}

TEST(LoadMesh, PreservesTheNormalsOfAFlattenedMesh) {
  // z is scaled to zero: the matrix has no inverse, but the plane has a normal.
  const Mesh mesh = loadValid(transformFile({{"scale", {1, 1, 0}}}).glb());
  expectNear(mesh.normals, {0, 0, 0, 0, 0, 1, 0, 0, 0});
}

TEST(LoadMesh, MultipliesTransformsDownTheTree) {
  GltfBuilder file;
  file.mesh({{"POSITION", file.floats(triangle, "VEC3")}});
  file.node({{"children", {1, 2}}, {"translation", {10, 0, 0}}});
  file.node({{"mesh", 0}, {"scale", {2, 2, 2}}, {"children", {3}}});
  file.node({{"mesh", 0}});
  file.node({{"mesh", 0}, {"translation", {0, 0, 1}}});
  EXPECT_EQ(loadValid(file.glb()).positions,
            (Floats{10, 0, 0, 12, 0, 0, 10, 2, 0,     // node 1
                    10, 0, 2, 12, 0, 2, 10, 2, 2,     // node 3, its child
                    10, 0, 0, 11, 0, 0, 10, 1, 0}));  // node 2
}

TEST(LoadMesh, LoadsOnlyTheDefaultScene) {
  GltfBuilder file;
  file.mesh({{"POSITION", file.floats(triangle, "VEC3")}});
  for (const int x : {1, 2, 3}) file.node({{"mesh", 0}, {"translation", {x, 0, 0}}});
  EXPECT_EQ(loadValid(file.glb()).vertexCount(), 9u);  // no scenes: every node
  file.tree["scenes"] = {{{"nodes", {1}}}, {{"nodes", {2, 0}}}};
  EXPECT_EQ(loadValid(file.glb()).positions, (Floats{2, 0, 0, 3, 0, 0, 2, 1, 0}));
  file.tree["scene"] = 1;
  EXPECT_EQ(loadValid(file.glb()).positions,
            (Floats{3, 0, 0, 4, 0, 0, 3, 1, 0, 1, 0, 0, 2, 0, 0, 1, 1, 0}));
}

TEST(LoadMesh, FillsAttributesThatOnlySomePartsHave) {
  GltfBuilder file;
  const int positions = file.floats(triangle, "VEC3");
  file.mesh({{"POSITION", positions},
             {"NORMAL", file.floats({1, 0, 0, 1, 0, 0, 1, 0, 0}, "VEC3")},
             {"TANGENT", file.floats({0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1}, "VEC4")},
             {"TEXCOORD_0", file.floats({1, 2, 3, 4, 5, 6}, "VEC2")}});
  file.mesh(
      {{"POSITION", positions}, {"COLOR_0", file.floats({0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3")}},
      {{"indices", file.accessor<std::uint8_t>({2, 1, 0}, "SCALAR")}});
  file.node({{"mesh", 0}});
  file.node({{"mesh", 1}, {"translation", {5, 0, 0}}});
  const Mesh mesh = loadValid(file.glb());
  EXPECT_EQ(mesh.uvs, (Floats{1, 2, 3, 4, 5, 6, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(mesh.colors, (Floats{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,  //
                                 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}));
  EXPECT_EQ(mesh.normals, (Floats{1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, -1, 0, 0, -1}));
  EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 5, 4, 3}));
  EXPECT_TRUE(mesh.tangents.empty());
  EXPECT_EQ(warningsOf(file.glb()),
            std::vector<std::string>{
                "Only some parts have tangents and normals; the tangents are ignored."});
}

TEST(LoadMesh, AcceptsJsonPaddedWithZeroBytes) {
  File file = triangleFile().embedded();
  file.resize(file.size() + 3);
  EXPECT_EQ(loadValid(file).positions, triangle);
}

TEST(LoadMesh, NamesEachFileOnceAndWarnsOnce) {
  GltfBuilder file = triangleFile();
  std::vector<std::string> names;
  for (int i = 0; i < 1000; ++i) {
    names.push_back("part " + std::to_string(i));
    for (int twice = 0; twice < 2; ++twice)
      file.add("buffers", {{"byteLength", 1}, {"uri", names.back()}});
  }
  EXPECT_EQ(externalFiles(file.glb()), names);

  json first = texture(0), second = texture(0);
  first["baseColorTexture"]["texCoord"] = 1;
  second["baseColorTexture"]["texCoord"] = 2;
  EXPECT_EQ(warningsOf(materialFile(first, second).glb()).size(), 1u);
}

TEST(LoadMesh, RejectsUnsupportedRequiredExtensionsByName) {
  const auto problemWith = [](const char* extension) {
    GltfBuilder file = triangleFile();
    file.tree["extensionsUsed"] = file.tree["extensionsRequired"] = {extension};
    return loadMesh(file.glb()).problem;
  };
  // The extension is required, but nothing uses it.
  EXPECT_EQ(problemWith("EXT_meshopt_compression"), "");
  GltfBuilder optional = triangleFile();  // uses an extension that is not required
  auto& primitive = optional.tree["meshes"][0]["primitives"][0];
  primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
  optional.tree["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  EXPECT_EQ(loadValid(optional.glb()).positions, triangle);
  for (const char* part : {"indices", "attributes"}) {
    GltfBuilder bare = optional;
    const int accessor =
        bare.add("accessors", {{"componentType", 5125}, {"count", 3}, {"type", "SCALAR"}});
    if (part == std::string("indices"))
      bare.tree["meshes"][0]["primitives"][0]["indices"] = accessor;
    else
      bare.tree["accessors"][0].erase("bufferView");
    EXPECT_EQ(
        loadMesh(bare.glb()).problem,
        "loadMesh: the model is compressed by KHR_draco_mesh_compression, for which there is no "
        "decoder here; export the model without Draco compression.");
  }
  EXPECT_EQ(problemWith("KHR_texture_basisu"), "");
  EXPECT_NE(problemWith("ACME_teapots").find("ACME_teapots"), std::string::npos);
  EXPECT_EQ(problemWith("KHR_materials_unlit"), "");
  EXPECT_EQ(problemWith("KHR_mesh_quantization"), "");
}

}  // namespace
}  // namespace warpjet
