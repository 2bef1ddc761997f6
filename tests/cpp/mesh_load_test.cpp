// Loading glTF files, feature by feature; expected numbers are computed by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "gltf_builder.hpp"
#include "mesh/check.hpp"
#include "mesh/load.hpp"

namespace warpjet {
namespace {

using Floats = std::vector<float>;
using Indices = std::vector<std::uint32_t>;

Mesh loadValid(const File& file, const Files& files = {}) {
  Loaded result = loadMesh(file, files);
  EXPECT_EQ(result.problem, "");
  if (!result.mesh) return {};
  EXPECT_EQ(problemOf(*result.mesh), "");
  return *result.mesh;
}

std::vector<std::string> warningsOf(const File& file) { return loadMesh(file).warnings; }

void expectNear(const Floats& actual, const Floats& expected, float tolerance = 1e-6f) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i)
    EXPECT_NEAR(actual[i], expected[i], tolerance) << i;
}

TEST(LoadMesh, ReadsATriangleWithoutIndices) {
  const Mesh mesh = loadValid(triangleFile().glb());
  EXPECT_EQ(mesh.positions, triangle);
  EXPECT_EQ(mesh.normals, (Floats{0, 0, 1, 0, 0, 1, 0, 0, 1}));
  EXPECT_TRUE(mesh.indices.empty());
  EXPECT_TRUE(mesh.uvs.empty() && mesh.colors.empty() && mesh.tangents.empty());
  EXPECT_FALSE(mesh.material);
}

TEST(LoadMesh, ReadsEmbeddedAndExternalBuffers) {
  const GltfBuilder file = triangleFile();
  EXPECT_EQ(loadValid(file.embedded()).positions, triangle);
  EXPECT_EQ(loadValid(file.external("a.bin"), {{"a.bin", file.binary}}).positions, triangle);
  EXPECT_EQ(loadValid(file.external("a%20b.bin"), {{"a%20b.bin", file.binary}}).positions,
            triangle);
  EXPECT_EQ(loadValid(file.external("a%20b.bin"), {{"a b.bin", file.binary}}).positions, triangle);
  EXPECT_EQ(externalFiles(file.external("a%20b.bin")), std::vector<std::string>{"a%20b.bin"});
  EXPECT_TRUE(externalFiles(file.glb()).empty());
  EXPECT_EQ(loadMesh(file.external("a.bin")).problem,
            "loadMesh: the model needs the file \"a.bin\"; pass it with the model, or export "
            "the model as .glb.");
}

TEST(LoadMesh, ReadsDataUrisOfEveryKind) {
  const GltfBuilder file = triangleFile();
  const std::string text = base64(file.binary);
  EXPECT_EQ(loadValid(file.external("DATA:Application/octet-stream;BASE64," + text)).positions,
            triangle);
  EXPECT_EQ(loadValid(file.external("data:;base64," + text)).positions, triangle);
  EXPECT_TRUE(externalFiles(file.external("DATA:;base64," + text)).empty());
  std::string percents;
  for (const std::uint8_t byte : file.binary) {
    constexpr char digits[] = "0123456789abcdef";
    percents += {'%', digits[byte >> 4], digits[byte & 15]};
  }
  EXPECT_EQ(loadValid(file.external("data:," + percents)).positions, triangle);
}

TEST(LoadMesh, ReadsAllAttributesBitForBit) {
  GltfBuilder file;
  const Floats normals{0, 0, 1, 0.6f, 0, 0.8f, 0, 0.28f, 0.96f};
  const Floats tangents{1, 0, 0, 1, 0, 1, 0, -1, 1, 0, 0, 1};
  const Floats uvs{0, 0.25f, 1, 0, 0, 1};
  const Floats colors{1, 0, 0, 1, 0, 1, 0, 0.5f, 0, 0, 1, 0};
  file.mesh({{"POSITION", file.floats(triangle, "VEC3")},
             {"NORMAL", file.floats(normals, "VEC3")},
             {"TANGENT", file.floats(tangents, "VEC4")},
             {"TEXCOORD_0", file.floats(uvs, "VEC2")},
             {"COLOR_0", file.floats(colors, "VEC4")}},
            {{"indices", file.accessor<std::uint16_t>({2, 0, 1}, "SCALAR")}});
  file.node({{"mesh", 0}});
  const Mesh mesh = loadValid(file.glb());
  EXPECT_EQ(mesh.positions, triangle);
  EXPECT_EQ(mesh.normals, normals);
  EXPECT_EQ(mesh.tangents, tangents);
  EXPECT_EQ(mesh.uvs, uvs);
  EXPECT_EQ(mesh.colors, colors);
  EXPECT_EQ(mesh.indices, (Indices{2, 0, 1}));
}

template <typename T>
Indices readIndices() {
  GltfBuilder file;
  const Floats square{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  file.mesh({{"POSITION", file.floats(square, "VEC3")}},
            {{"indices", file.accessor<T>({0, 1, 2, 0, 2, 3}, "SCALAR")}});
  file.node({{"mesh", 0}});
  return loadValid(file.glb()).indices;
}

TEST(LoadMesh, ReadsIndicesOfEveryType) {
  const Indices expected{0, 1, 2, 0, 2, 3};
  EXPECT_EQ(readIndices<std::uint8_t>(), expected);
  EXPECT_EQ(readIndices<std::uint16_t>(), expected);
  EXPECT_EQ(readIndices<std::uint32_t>(), expected);
}

Indices trianglesOf(int mode, const std::vector<std::uint8_t>& corners) {
  GltfBuilder file;
  const Floats five{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0};
  json more = {{"mode", mode}};
  if (!corners.empty()) more["indices"] = file.accessor(corners, "SCALAR");
  file.mesh({{"POSITION", file.floats(five, "VEC3")}}, more);
  file.node({{"mesh", 0}});
  return loadValid(file.glb()).indices;
}

TEST(LoadMesh, SplitsStripsAndFansIntoTriangles) {
  EXPECT_EQ(trianglesOf(5, {}), (Indices{0, 1, 2, 1, 3, 2, 2, 3, 4}));
  EXPECT_EQ(trianglesOf(5, {4, 3, 2, 1}), (Indices{4, 3, 2, 3, 1, 2}));
  EXPECT_EQ(trianglesOf(6, {}), (Indices{1, 2, 0, 2, 3, 0, 3, 4, 0}));
  // Repeated corners join strips: triangles without area are removed, and every second one is
  // reversed.
  EXPECT_EQ(trianglesOf(5, {0, 1, 2, 2, 1, 1, 1, 3, 4}), (Indices{0, 1, 2, 1, 3, 4}));
  EXPECT_EQ(trianglesOf(5, {0, 1, 2, 2, 1, 1, 3, 4}), (Indices{0, 1, 2, 1, 4, 3}));
}

TEST(LoadMesh, IgnoresSurplusCorners) {
  EXPECT_EQ(trianglesOf(4, {0, 1, 2, 3}), (Indices{0, 1, 2}));
  EXPECT_EQ(trianglesOf(4, {}), (Indices{0, 1, 2}));
}

TEST(LoadMesh, IgnoresPointsAndLines) {
  GltfBuilder file = triangleFile();
  file.tree["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 1}});
  EXPECT_EQ(loadValid(file.glb()).positions, triangle);
  EXPECT_EQ(warningsOf(file.glb()),
            std::vector<std::string>{"Points and lines are left out; only triangles are read."});
}

template <typename T>
Floats positionsFrom(const std::vector<T>& numbers, bool isNormalized) {
  GltfBuilder file;
  file.tree["extensionsUsed"] = file.tree["extensionsRequired"] = {"KHR_mesh_quantization"};
  // Three elements of three numbers at a distance of four: strides are multiples of 4.
  const int positions =
      file.accessor(numbers, "VEC3", {{"normalized", isNormalized}, {"count", 3}});
  file.tree["bufferViews"][0]["byteStride"] = 4 * sizeof(T);
  file.mesh({{"POSITION", positions}});
  file.node({{"mesh", 0}});
  return loadValid(file.glb()).positions;
}

TEST(LoadMesh, ReadsQuantizedPositions) {
  EXPECT_EQ(positionsFrom<std::int8_t>({-128, -127, 0, 9, 127, 1, 0, 9, 0, 64, 0, 9}, true),
            (Floats{-1, -1, 0, 1, 1 / 127.0f, 0, 0, 64 / 127.0f, 0}));
  EXPECT_EQ(positionsFrom<std::uint8_t>({0, 255, 0, 9, 51, 0, 0, 9, 0, 0, 102, 9}, true),
            (Floats{0, 1, 0, 0.2f, 0, 0, 0, 0, 0.4f}));
  EXPECT_EQ(positionsFrom<std::int16_t>({-32768, 32767, 0, 9, 1, 0, 0, 9, 0, 0, 2, 9}, true),
            (Floats{-1, 1, 0, 1 / 32767.0f, 0, 0, 0, 0, 2 / 32767.0f}));
  EXPECT_EQ(positionsFrom<std::uint16_t>({0, 65535, 0, 9, 13107, 0, 0, 9, 0, 0, 0, 9}, true),
            (Floats{0, 1, 0, 0.2f, 0, 0, 0, 0, 0}));
  EXPECT_EQ(positionsFrom<std::int8_t>({-128, 5, 0, 9, 127, 0, 0, 9, 0, 0, 3, 9}, false),
            (Floats{-128, 5, 0, 127, 0, 0, 0, 0, 3}));
  EXPECT_EQ(positionsFrom<std::uint16_t>({65535, 5, 0, 9, 127, 0, 0, 9, 0, 0, 3, 9}, false),
            (Floats{65535, 5, 0, 127, 0, 0, 0, 0, 3}));
}

TEST(LoadMesh, NormalizesQuantizedNormals) {
  GltfBuilder file;
  // The vector (90/127, 90/127) has a length of 1.002.
  const int normals = file.accessor<std::int8_t>({90, 90, 0, 0, 0, -128, 0, 0, 0, 127, 0, 0},
                                                 "VEC3", {{"normalized", true}, {"count", 3}});
  file.tree["bufferViews"][0]["byteStride"] = 4;
  file.mesh({{"POSITION", file.floats(triangle, "VEC3")}, {"NORMAL", normals}});
  file.node({{"mesh", 0}});
  const float half = std::sqrt(0.5f);
  expectNear(loadValid(file.glb()).normals, {half, half, 0, 0, -1, 0, 0, 1, 0});
}

TEST(LoadMesh, ReadsInterleavedAttributes) {
  GltfBuilder file;
  const int view = file.view<float>({-1,                   // not part of the view's first element
                                     0, 0, 0, 0.1f, 0.2f,  // position, uv
                                     1, 0, 0, 0.3f, 0.4f,  //
                                     0, 1, 0, 0.5f, 0.6f});
  file.tree["bufferViews"][view]["byteStride"] = 20;
  const auto accessor = [&](int offset, const char* type) {
    return file.add("accessors", {{"bufferView", view},
                                  {"byteOffset", offset},
                                  {"componentType", 5126},
                                  {"count", 3},
                                  {"type", type}});
  };
  file.mesh({{"POSITION", accessor(4, "VEC3")}, {"TEXCOORD_0", accessor(16, "VEC2")}});
  file.node({{"mesh", 0}});
  const Mesh mesh = loadValid(file.glb());
  EXPECT_EQ(mesh.positions, triangle);
  EXPECT_EQ(mesh.uvs, (Floats{0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f}));
}

TEST(LoadMesh, ReadsRgbAndRgbaColors) {
  GltfBuilder file;
  const int three = file.accessor<std::uint8_t>({255, 0, 51, 0, 0, 255, 0, 0, 0, 0, 255, 0}, "VEC3",
                                                {{"normalized", true}, {"count", 3}});
  file.tree["bufferViews"][0]["byteStride"] = 4;
  const int four = file.accessor<std::uint16_t>({65535, 0, 0, 13107, 0, 0, 0, 0, 0, 0, 0, 65535},
                                                "VEC4", {{"normalized", true}});
  const int positions = file.floats(triangle, "VEC3");
  file.mesh({{"POSITION", positions}, {"COLOR_0", three}});
  file.mesh({{"POSITION", positions}, {"COLOR_0", four}});
  file.node({{"mesh", 0}});
  file.node({{"mesh", 1}});
  EXPECT_EQ(loadValid(file.glb()).colors,
            (Floats{1, 0, 0.2f, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 0, 0, 0.2f, 0, 0, 0, 0, 0, 0, 0, 1}));
}

TEST(LoadMesh, ReadsSparseAccessors) {
  GltfBuilder file;
  const int places = file.view<std::uint16_t>({0, 2});
  const int values = file.view<float>({5, 6, 7, 8, 9, 10});
  const json sparse = {{"count", 2},
                       {"indices", {{"bufferView", places}, {"componentType", 5123}}},
                       {"values", {{"bufferView", values}}}};
  const int positions = file.accessor(triangle, "VEC3", {{"sparse", sparse}});
  const int zeros = file.add(
      "accessors", {{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}, {"sparse", sparse}});
  file.mesh({{"POSITION", positions}});
  file.mesh({{"POSITION", zeros}});
  file.node({{"mesh", 0}});
  file.node({{"mesh", 1}});
  EXPECT_EQ(loadValid(file.glb()).positions,
            (Floats{5, 6, 7, 1, 0, 0, 8, 9, 10, 5, 6, 7, 0, 0, 0, 8, 9, 10}));
}

TEST(LoadMesh, ReadsSparseIndices) {
  GltfBuilder file;
  const json sparse = {
      {"count", 1},
      {"indices", {{"bufferView", file.view<std::uint8_t>({1})}, {"componentType", 5121}}},
      {"values", {{"bufferView", file.view<std::uint8_t>({3})}}}};
  const Floats square{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  file.mesh({{"POSITION", file.floats(square, "VEC3")}},
            {{"indices", file.accessor<std::uint8_t>({0, 1, 2}, "SCALAR", {{"sparse", sparse}})}});
  file.node({{"mesh", 0}});
  EXPECT_EQ(loadValid(file.glb()).indices, (Indices{0, 3, 2}));
}

// A file whose only node has this transform, with a normal and a tangent per corner.
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
  // Inverse transpose: (0.3, 0.8, 0) of length sqrt(0.73), rotated. Zero remains zero.
  const float length = std::sqrt(0.73f);
  expectNear(mesh.normals, {-0.8f / length, 0.3f / length, 0, 0, 0, 1, 0, 0, 0});
  // Matrix: (1.6, -0.6, 0) of length sqrt(2.92), rotated.
  const float along = std::sqrt(2.92f);
  expectNear(mesh.tangents, {0.6f / along, 1.6f / along, 0, 1, 0, 1, 0, -1, -1, 0, 0, 1});
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
  // z is scaled to zero: the inverse doesn't exist, but the normals of the plane do.
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
                "Only some parts have tangents and normals; the tangents are left out."});
}

// Two triangles with one material each; the source of a texture is an image.
GltfBuilder materialFile(const json& first, const json& second) {
  GltfBuilder file;
  const int positions = file.floats(triangle, "VEC3");
  for (const json& look : {first, second}) {
    const json more = {{"material", file.add("materials", {{"pbrMetallicRoughness", look}})}};
    file.node({{"mesh", file.mesh({{"POSITION", positions}}, more)}});
  }
  const int view = file.view<std::uint8_t>({0x89, 'P', 'N', 'G'});
  file.tree["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}},
                         {{"uri", "data:image/jpeg;base64,/9j/4A=="}},
                         {{"uri", "my%20wood.webp"}}};
  file.tree["textures"] = {{{"source", 0}}, {{"source", 1}}, {{"source", 2}}};
  return file;
}

json texture(int index) { return {{"baseColorTexture", {{"index", index}}}}; }

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
  const File picture = bytesOf("RIFF1234WEBPVP8 ");
  EXPECT_EQ(loadValid(file, {{"my%20wood.webp", picture}}).material->baseColorTexture,
            (Image{picture, "image/webp"}));
  EXPECT_EQ(loadValid(file).material, Material{});
  EXPECT_EQ(warningsOf(file),
            std::vector<std::string>{"The picture of the base colour (image 2, \"my%20wood.webp\") "
                                     "is missing or broken; it is left out."});
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

TEST(LoadMesh, NormalizesNormalsAndTangents) {
  GltfBuilder file;
  file.mesh({{"POSITION", file.floats(triangle, "VEC3")},
             {"NORMAL", file.floats({3, 0, 4, 0, 1e-22f, 0, 0, 0, 0}, "VEC3")},
             {"TANGENT", file.floats({0, 2, 0, 1, 1, 0, 0, 1, 0, -1e-40f, 0, 1}, "VEC4")}});
  file.node({{"mesh", 0}});
  const Mesh mesh = loadValid(file.glb());
  expectNear(mesh.normals, {0.6f, 0, 0.8f, 0, 1, 0, 0, 0, 0});
  expectNear(mesh.tangents, {0, 1, 0, 1, 1, 0, 0, 1, 0, -1, 0, 1});
  EXPECT_EQ(warningsOf(file.glb()),
            (std::vector<std::string>{"Normals that are not of length 1 are scaled to it.",
                                      "Tangents that are not of length 1 are scaled to it."}));
}

TEST(LoadMesh, ClampsColorsToTheUnitRange) {
  const json odd = {{"baseColorFactor", {5, -1, 1e308, 2}}};
  const std::string ofMaterials = "Base colours outside 0 to 1 are clamped.";
  EXPECT_EQ(loadValid(materialFile(odd, odd).glb()).material->baseColor,
            (std::array<float, 4>{1, 0, 1, 1}));
  EXPECT_EQ(warningsOf(materialFile(odd, odd).glb()), std::vector<std::string>{ofMaterials});

  GltfBuilder file = materialFile(odd, json::object());
  file.tree["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] =
      file.floats({0.5f, 0.5f, 0.5f, 2, -1, 3, 0, 0.5f, -0.0f, 1, 1, 1}, "VEC4");
  const Mesh mesh = loadValid(file.glb());
  EXPECT_EQ((Floats{mesh.colors.begin(), mesh.colors.begin() + 12}),
            (Floats{0.5f, 0, 0.5f, 1, 0, 0, 0, 0.5f, 0, 0, 1, 1}));
  EXPECT_EQ(
      warningsOf(file.glb()),
      (std::vector<std::string>{"Colours of vertices outside 0 to 1 are clamped.", ofMaterials}));
}

// Node 0 shows the mesh at another place, which has no effect. Joint 1 is at x = 1, as it was
// bound; joint 2, bound 2 above it, is rotated by 90 degrees around z: x to y, y to -x.
GltfBuilder skinFile() {
  const auto moved = [](float x, float y) {
    return Floats{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, 0, 1};
  };
  Floats inverses = moved(-1, 0);
  const Floats second = moved(-1, -2);
  inverses.insert(inverses.end(), second.begin(), second.end());
  const double half = std::sqrt(0.5);
  GltfBuilder file;
  file.mesh(
      {{"POSITION", file.floats({0, 0, 0, 2, 2, 0, 2, 2, 3}, "VEC3")},
       {"NORMAL", file.floats({0, 0, 1, 1, 0, 0, 1, 0, 0}, "VEC3")},
       {"TANGENT", file.floats({1, 0, 0, 1, 0, 0, 1, -1, 0, 1, 0, 1}, "VEC4")},
       {"JOINTS_0", file.accessor<std::uint8_t>({0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 9, 0}, "VEC4")},
       {"WEIGHTS_0", file.floats({1, 0, 0, 0, 0, 1, 0, 0, 0.5f, 0.5f, 0, 0}, "VEC4")}});
  file.node({{"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}, {"scale", {-1, 1, 1}}});
  file.node({{"translation", {1, 0, 0}}, {"children", {2}}});
  file.node({{"translation", {0, 2, 0}}, {"rotation", {0, 0, half, half}}});
  const int matrices = file.accessor<float>(inverses, "VEC4", {{"type", "MAT4"}, {"count", 2}});
  file.tree["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", matrices}}};
  return file;
}

TEST(LoadMesh, PosesSkinsByTheirJoints) {
  const Mesh mesh = loadValid(skinFile().glb());
  // The last vertex follows both: half of (2, 2, 3), its original position, and half of (1, 3, 3).
  expectNear(mesh.positions, {0, 0, 0, 1, 3, 0, 1.5f, 2.5f, 3});
  const float half = std::sqrt(0.5f);
  expectNear(mesh.normals, {0, 0, 1, 0, 1, 0, half, half, 0});
  expectNear(mesh.tangents, {1, 0, 0, 1, 0, 0, 1, -1, -half, half, 0, 1});
  EXPECT_TRUE(mesh.indices.empty());
  EXPECT_TRUE(warningsOf(skinFile().glb()).empty());
}

TEST(LoadMesh, PosesSkinsOfUnusualFiles) {
  GltfBuilder unbound = skinFile();
  unbound.tree["skins"][0].erase("inverseBindMatrices");
  // The same as if bound at the origin: (2, 2) rotated and translated by (1, 2), blended with half
  // of (3, 2, 3).
  expectNear(loadValid(unbound.glb()).positions, {1, 0, 0, -1, 4, 0, 1, 3, 3});

  GltfBuilder mirrored = skinFile();
  mirrored.tree["nodes"][1]["scale"] = {1, 1, -1};
  EXPECT_EQ(loadValid(mirrored.glb()).indices, (Indices{0, 2, 1}));
  expectNear(loadValid(mirrored.glb()).positions, {0, 0, 0, 1, 3, 0, 1.5f, 2.5f, -3});
  expectNear(loadValid(mirrored.glb()).normals,
             {0, 0, -1, 0, 1, 0, std::sqrt(0.5f), std::sqrt(0.5f), 0});

  GltfBuilder scenes = skinFile();  // another scene shows its joints
  scenes.tree["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
  EXPECT_EQ(loadValid(scenes.glb()).positions, loadValid(skinFile().glb()).positions);

  GltfBuilder boneless = skinFile();
  boneless.tree["meshes"][0]["primitives"][0]["attributes"].erase("WEIGHTS_0");
  expectNear(loadValid(boneless.glb()).positions, {100, 0, 0, 98, 2, 0, 98, 2, 3});

  GltfBuilder heavy = skinFile();
  heavy.tree["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] =
      heavy.floats({0, 0, 0, 0, 0, 7, 0, 0, 3, 3, 0, 0}, "VEC4");
  expectNear(loadValid(heavy.glb()).positions, {0, 0, 0, 1, 3, 0, 1.5f, 2.5f, 3});

  GltfBuilder many = skinFile();
  many.tree["meshes"][0]["primitives"][0]["attributes"]["JOINTS_1"] = 3;
  EXPECT_EQ(warningsOf(many.glb()),
            std::vector<std::string>{
                "Vertices that follow more than four bones follow only the first four."});
}

TEST(LoadMesh, RejectsInconsistentSkins) {
  const auto problemWith = [](auto change) {
    GltfBuilder file = skinFile();
    change(file.tree);
    return loadMesh(file.glb()).problem;
  };
  const auto contains = [](const std::string& problem, const char* part) {
    EXPECT_NE(problem.find(part), std::string::npos) << problem;
  };
  contains(problemWith([](json& t) { t["skins"][0]["joints"] = {1}; }),
           "a vertex follows a joint that its skin, of 1, does not have");
  contains(problemWith([](json& t) { t["skins"][0]["joints"] = {1, 7}; }), "node 7");
  contains(problemWith([](json& t) {
             t["skins"][0]["joints"] = {1, 2, 2};
           }),
           "3 joints, but 2 inverse bind matrices");
  contains(problemWith([](json& t) { t["skins"][0]["inverseBindMatrices"] = 0; }),
           "4 by 4 matrices");
  contains(problemWith([](json& t) { t["accessors"][5]["count"] = 9; }), "reads up to byte 576");
  contains(problemWith([](json& t) { t["nodes"][0]["skin"] = 3; }), "skin 3");
  contains(problemWith([](json& t) { t["skins"][0].erase("joints"); }), "joints is missing");
  contains(problemWith([](json& t) { t["nodes"][2]["children"] = {1}; }), "");
  contains(problemWith([](json& t) {
             const std::vector<int> all(1000000, 1);
             t["skins"] = {{{"joints", all}}, {{"joints", all}}};
           }),
           "more than 1,048,576 joints");
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
  // Required, but unused.
  EXPECT_EQ(problemWith("EXT_meshopt_compression"), "");
  GltfBuilder optional = triangleFile();  // used, but not declared as used
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
