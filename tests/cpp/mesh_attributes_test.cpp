// Loading the numbers of glTF files: buffers, attributes and indices. The expected numbers are
// computed by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "load_support.hpp"

namespace warpjet {
namespace {

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
  // Repeated corners join two strips: the triangles without area are removed, but still count when
  // every second triangle is reversed.
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
            std::vector<std::string>{"Points and lines are ignored; only triangles are read."});
}

template <typename T>
Floats positionsFrom(const std::vector<T>& numbers, bool isNormalized) {
  GltfBuilder file;
  file.tree["extensionsUsed"] = file.tree["extensionsRequired"] = {"KHR_mesh_quantization"};
  // Three elements of three numbers each, every fourth number: strides must be multiples of 4.
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
  const int indices = file.view<std::uint16_t>({0, 2});
  const int values = file.view<float>({5, 6, 7, 8, 9, 10});
  const json sparse = {{"count", 2},
                       {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
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
  const std::string materialWarning = "Base colours outside 0 to 1 are clamped.";
  EXPECT_EQ(loadValid(materialFile(odd, odd).glb()).material->baseColor,
            (std::array<float, 4>{1, 0, 1, 1}));
  EXPECT_EQ(warningsOf(materialFile(odd, odd).glb()), std::vector<std::string>{materialWarning});

  GltfBuilder file = materialFile(odd, json::object());
  file.tree["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] =
      file.floats({0.5f, 0.5f, 0.5f, 2, -1, 3, 0, 0.5f, -0.0f, 1, 1, 1}, "VEC4");
  const Mesh mesh = loadValid(file.glb());
  EXPECT_EQ((Floats{mesh.colors.begin(), mesh.colors.begin() + 12}),
            (Floats{0.5f, 0, 0.5f, 1, 0, 0, 0, 0.5f, 0, 0, 1, 1}));
  EXPECT_EQ(warningsOf(file.glb()),
            (std::vector<std::string>{"Colours of vertices outside 0 to 1 are clamped.",
                                      materialWarning}));
}

}  // namespace
}  // namespace warpjet
