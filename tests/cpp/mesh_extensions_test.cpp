// Effects of glTF extensions, morph targets and sparse accessors on the merged mesh. The expected
// numbers are computed by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "gltf_builder.hpp"
#include "mesh/check.hpp"
#include "mesh/load.hpp"

namespace warpjet {
namespace {

using Floats = std::vector<float>;
using Indices = std::vector<std::uint32_t>;
using Names = std::vector<std::string>;

Loaded load(const File& file, const Files& files = {}) {
  const File exact(file.begin(), file.end());
  Loaded loaded = loadMesh(exact, files);
  EXPECT_EQ(loaded.problem, "");
  EXPECT_EQ(problemOf(loaded.mesh.value_or(Mesh{})), "");
  return loaded;
}

Mesh meshOf(const File& file) { return load(file).mesh.value_or(Mesh{}); }

void expectNear(const Floats& actual, const Floats& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) EXPECT_NEAR(actual[i], expected[i], 1e-6f) << i;
}

json sparseJson(int count, int indices, int componentType, int values) {
  return {{"count", count},
          {"indices", {{"bufferView", indices}, {"componentType", componentType}}},
          {"values", {{"bufferView", values}}}};
}

TEST(GltfExtensions, ReadsSparseIndicesOverZeros) {
  GltfBuilder file;
  const int indices = file.view<std::uint8_t>({1, 2}), values = file.view<std::uint8_t>({3, 2});
  const int corners = file.add("accessors", {{"componentType", 5121},
                                             {"count", 3},
                                             {"type", "SCALAR"},
                                             {"sparse", sparseJson(2, indices, 5121, values)}});
  const int square = file.floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3");
  file.mesh({{"POSITION", square}}, {{"indices", corners}});
  file.node({{"mesh", 0}});
  EXPECT_EQ(meshOf(file.glb()).indices, (Indices{0, 3, 2}));
}

// Returns a triangle with one target, which lifts its third vertex by 2 and tilts its normal.
GltfBuilder morphFile(const json& meshWeights, const json& nodeWeights) {
  GltfBuilder file;
  const int normals = file.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  const int index = file.view<std::uint8_t>({2}), value = file.view<float>({0, 0, 2});
  const int lift = file.add("accessors", {{"componentType", 5126},
                                          {"count", 3},
                                          {"type", "VEC3"},
                                          {"sparse", sparseJson(1, index, 5121, value)}});
  const int tilt = file.floats({0, 0, 0, 0, 0, 0, 0, 1.5f, -0.5f}, "VEC3");
  const int uvs = file.floats({0, 0, 1, 0, 0, 1}, "VEC2");
  const int moved = file.floats({0.5f, 0.25f, 0, 0, 0, 0}, "VEC2");
  file.mesh({{"POSITION", file.floats(triangle, "VEC3")}, {"NORMAL", normals}, {"TEXCOORD_0", uvs}},
            {{"targets", {{{"POSITION", lift}, {"NORMAL", tilt}, {"TEXCOORD_0", moved}}}}});
  if (!meshWeights.is_null()) file.tree["meshes"][0]["weights"] = meshWeights;
  file.node({{"mesh", 0}});
  if (!nodeWeights.is_null()) file.tree["nodes"][0]["weights"] = nodeWeights;
  return file;
}

TEST(GltfExtensions, AppliesWeightsOfMorphTargets) {
  const Mesh mesh = meshOf(morphFile({0.5}, nullptr).glb());
  EXPECT_EQ(mesh.positions, (Floats{0, 0, 0, 1, 0, 0, 0, 1, 1}));
  // (0, 0.75, 0.75), normalized
  expectNear(mesh.normals, {0, 0, 1, 0, 0, 1, 0, std::sqrt(0.5f), std::sqrt(0.5f)});
  EXPECT_EQ(mesh.uvs, (Floats{0.25f, 0.125f, 1, 0, 0, 1}));
  // The weights of a node override those of its mesh.
  EXPECT_EQ(meshOf(morphFile({0.5}, {1}).glb()).positions[8], 2);
  EXPECT_EQ(meshOf(morphFile({0.5}, {0}).glb()).positions, triangle);
  EXPECT_EQ(meshOf(morphFile(nullptr, {-1}).glb()).positions[8], -2);
  EXPECT_EQ(meshOf(morphFile(nullptr, nullptr).glb()).positions, triangle);
  EXPECT_EQ(load(morphFile({1}, nullptr).glb()).warnings,
            Names{"The model has morph targets; it has the shape that their weights in the file "
                  "give it."});
  EXPECT_EQ(load(morphFile({0}, nullptr).glb()).warnings,
            Names{"The model has morph targets; they are ignored, and it keeps its base shape."});
}

TEST(GltfExtensions, ComputesNormalsOfTheMorphedShape) {
  GltfBuilder file = morphFile({0.5}, nullptr);
  file.tree["meshes"][0]["primitives"][0]["attributes"].erase("NORMAL");
  // The cross product of (1, 0, 0) and (0, 1, 1).
  const float half = std::sqrt(0.5f);
  expectNear(meshOf(file.glb()).normals, {0, -half, half, 0, -half, half, 0, -half, half});
}

TEST(GltfExtensions, RejectsInconsistentMorphTargets) {
  GltfBuilder file = morphFile({1}, nullptr);
  file.tree["accessors"][1]["count"] = 4;
  EXPECT_NE(loadMesh(file.glb()).problem.find("3 positions, but 4 of its morph target's POSITION"),
            std::string::npos);
  GltfBuilder many = morphFile({1}, nullptr);
  auto& mesh = many.tree["meshes"][0];
  mesh["weights"] = std::vector<int>(40, 1);
  mesh["primitives"][0]["targets"] = std::vector<json>(40, {{"POSITION", 1}});
  many.tree["accessors"][0] =
      many.tree["accessors"][1] = {{"componentType", 5126}, {"count", 4000000}, {"type", "VEC3"}};
  mesh["primitives"][0]["attributes"] = {{"POSITION", 1}};
  EXPECT_NE(loadMesh(many.glb()).problem.find("morph targets"), std::string::npos);
}

GltfBuilder instanceFile(const json& attributes, GltfBuilder file = triangleFile()) {
  file.tree["extensionsUsed"] = file.tree["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  file.tree["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = attributes;
  return file;
}

TEST(GltfExtensions, ExpandsInstancesToTriangles) {
  GltfBuilder file = triangleFile();
  const int translations = file.floats({0, 0, 0, 10, 0, 0, 20, 0, 0}, "VEC3");
  // The second instance is rotated by 90 degrees around z.
  const int rotations = file.accessor<std::int16_t>(
      {0, 0, 0, 32767, 0, 0, 23170, 23170, 0, 0, 0, 32767}, "VEC4", {{"normalized", true}});
  const int scales = file.floats({1, 1, 1, 1, 1, 1, 2, 3, -1}, "VEC3");
  file.tree["nodes"][0]["translation"] = {0, 0, 5};
  const Mesh mesh =
      meshOf(instanceFile(
                 {{"TRANSLATION", translations}, {"ROTATION", rotations}, {"SCALE", scales}}, file)
                 .glb());
  expectNear(mesh.positions, {0,  0, 5, 1,  0, 5, 0,  1, 5,  //
                              10, 0, 5, 10, 1, 5, 9,  0, 5,  //
                              20, 0, 5, 22, 0, 5, 20, 3, 5});
  // The third instance is mirrored.
  EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 3, 4, 5, 6, 8, 7}));

  EXPECT_EQ(
      meshOf(instanceFile({{"TRANSLATION", translations}, {"_ID", 99}}, file).glb()).vertexCount(),
      9u);
  EXPECT_EQ(meshOf(instanceFile({{"SCALE", scales}}, file).glb()).vertexCount(), 9u);
  EXPECT_EQ(meshOf(instanceFile(json::object(), file).glb()).vertexCount(), 3u);
}

TEST(GltfExtensions, RejectsInconsistentInstances) {
  GltfBuilder file = triangleFile();
  const int three = file.floats({0, 0, 0, 1, 0, 0, 2, 0, 0}, "VEC3");
  const int two = file.floats({1, 1, 1, 1, 1, 1}, "VEC3");
  const auto problem = [&](const json& attributes) {
    return loadMesh(instanceFile(attributes, file).glb()).problem;
  };
  EXPECT_NE(problem({{"TRANSLATION", three}, {"SCALE", two}}).find("instances"), std::string::npos);
  EXPECT_NE(problem({{"TRANSLATION", 99}}).find("accessor 99"), std::string::npos);
  const int bomb =
      file.add("accessors", {{"componentType", 5126}, {"count", 4000000}, {"type", "VEC3"}});
  EXPECT_NE(problem({{"TRANSLATION", bomb}}).find("more than 1,048,576 parts"), std::string::npos);
}

TEST(GltfExtensions, HidesNodesAndTheirDescendants) {
  GltfBuilder file = triangleFile();
  file.tree["extensionsUsed"] = file.tree["extensionsRequired"] = {"KHR_node_visibility"};
  file.node(
      {{"children", {2, 3}}, {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}});
  file.node({{"mesh", 0}});
  file.node({{"mesh", 0}, {"extensions", {{"KHR_node_visibility", {{"visible", true}}}}}});
  EXPECT_EQ(meshOf(file.glb()).positions, triangle);
  file.tree["nodes"][1].erase("extensions");
  EXPECT_EQ(meshOf(file.glb()).vertexCount(), 9u);
  file.tree["nodes"][0]["extensions"]["KHR_node_visibility"]["visible"] = 1;
  EXPECT_NE(loadMesh(file.glb()).problem.find("visible must be true or false"), std::string::npos);
}

TEST(GltfExtensions, ReadsColorsFromSpecularGlossiness) {
  GltfBuilder file = triangleFile();
  file.tree["extensionsUsed"] =
      file.tree["extensionsRequired"] = {"KHR_materials_pbrSpecularGlossiness"};
  file.tree["images"] = {{{"uri", "a.png"}}};
  file.tree["textures"] = {{{"source", 0}}};
  file.tree["meshes"][0]["primitives"][0]["material"] = 0;
  file.tree["materials"] = {
      {{"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 1, 1}}}},
       {"extensions",
        {{"KHR_materials_pbrSpecularGlossiness",
          {{"diffuseFactor", {1, 0.5, 0, 1}},
           {"specularFactor", {1, 1, 1}},
           {"diffuseTexture",
            {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {2, 2}}}}}}}}}}}}}};
  EXPECT_EQ(externalFiles(file.glb()), Names{"a.png"});
  const Loaded loaded = load(file.glb(), {{"a.png", bytesOf("\x89PNG")}});
  EXPECT_EQ(loaded.mesh->material->baseColor, (std::array<float, 4>{1, 0.5f, 0, 1}));
  EXPECT_EQ(loaded.mesh->material->baseColorTexture->mimeType, "image/png");
  EXPECT_EQ(loaded.warnings,
            Names{"A texture is moved or scaled by KHR_texture_transform, which is ignored."});
  file.tree["materials"][0]["extensions"]["KHR_materials_pbrSpecularGlossiness"] = json::object();
  EXPECT_EQ(load(file.glb()).mesh->material->baseColor, (std::array<float, 4>{1, 1, 1, 1}));
}

TEST(GltfExtensions, SkipsOnlyTexturesInUnsupportedFormats) {
  for (const char* extension : {"EXT_texture_webp", "KHR_texture_basisu", "EXT_texture_avif",
                                "MSFT_texture_dds", "KHR_texture_procedurals"}) {
    GltfBuilder file = triangleFile();
    file.tree["extensionsUsed"] = file.tree["extensionsRequired"] = {extension};
    file.tree["images"] = {{{"uri", "a.bin"}, {"mimeType", "image/webp"}}};
    file.tree["textures"] = {{{"extensions", {{extension, {{"source", 0}}}}}}};
    file.tree["meshes"][0]["primitives"][0]["material"] = 0;
    file.tree["materials"] = {
        {{"pbrMetallicRoughness",
          {{"baseColorFactor", {1, 0, 0, 1}}, {"baseColorTexture", {{"index", 0}}}}}}};
    const Loaded loaded = load(file.glb());
    EXPECT_EQ(loaded.mesh->positions, triangle) << extension;
    EXPECT_EQ(loaded.mesh->material->baseColor, (std::array<float, 4>{1, 0, 0, 1}));
    EXPECT_FALSE(loaded.mesh->material->baseColorTexture);
    EXPECT_EQ(loaded.warnings,
              Names{"A base-colour texture has no PNG or JPEG image; it is ignored."});
  }
}

// Returns a triangle whose positions are in a view compressed by meshopt; its bytes are not
// meshopt's. `packed` adds or replaces members of the extension.
GltfBuilder compressedFile(const json& packed = json::object()) {
  GltfBuilder file = triangleFile();
  file.tree["extensionsUsed"] = file.tree["extensionsRequired"] = {"EXT_meshopt_compression"};
  json extension = {
      {"buffer", 0}, {"byteLength", 20}, {"byteStride", 12}, {"count", 3}, {"mode", "ATTRIBUTES"}};
  if (packed.is_object()) extension.update(packed);
  file.tree["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = extension;
  file.tree["bufferViews"][0]["buffer"] = 1;
  file.tree["buffers"] = {
      {{"byteLength", 36}},
      {{"byteLength", 36}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
  return file;
}

std::vector<std::uint8_t> rawBytes(const Floats& numbers) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(numbers.data());
  return {first, first + numbers.size() * sizeof(float)};
}

TEST(GltfExtensions, AcceptsDecompressedViews) {
  const File file = compressedFile().glb();
  ModelFile model(file);
  const std::vector<PackedPart> parts = model.packedParts({});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].bytes.size(), 20u);
  EXPECT_EQ(json::parse(parts[0].plan), (json{{"codec", "meshopt"},
                                              {"extension", "EXT_meshopt_compression"},
                                              {"isOptional", false},
                                              {"count", 3},
                                              {"byteStride", 12},
                                              {"mode", "ATTRIBUTES"},
                                              {"filter", "NONE"}}));
  model.unpack(0, {rawBytes(triangle)});
  EXPECT_EQ(model.load({}).mesh->positions, triangle);
  EXPECT_EQ(loadMesh(file).problem,
            "loadMesh: the model is compressed by EXT_meshopt_compression, for which there is no "
            "decoder here; export the model without meshopt compression.");
}

TEST(GltfExtensions, ReadsTheFallbackOfACompressedView) {
  GltfBuilder file = compressedFile();
  file.tree["buffers"][1]["uri"] = "plain.bin";
  EXPECT_EQ(load(file.glb(), {{"plain.bin", rawBytes(triangle)}}).mesh->positions, triangle);
  EXPECT_NE(loadMesh(file.glb()).problem.find("no decoder here"), std::string::npos);
}

TEST(GltfExtensions, RejectsInconsistentCompressedViews) {
  const auto problem = [](const json& packed, std::vector<std::uint8_t> bytes = {}) {
    const File file = compressedFile(packed).glb();
    ModelFile model(file);
    try {
      model.packedParts({});
      model.unpack(0, {std::move(bytes)});
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
    return model.load({}).problem;
  };
  EXPECT_NE(problem({{"mode", "POINTS"}}).find("unknown mode \"POINTS\""), std::string::npos);
  EXPECT_NE(problem({{"filter", "BLUR"}}).find("unknown filter \"BLUR\""), std::string::npos);
  EXPECT_NE(problem({{"byteStride", 6}}).find("byteStride 6"), std::string::npos);
  EXPECT_NE(problem({{"filter", "QUATERNION"}}).find("byteStride 12"), std::string::npos);
  EXPECT_NE(problem({{"mode", "TRIANGLES"}, {"byteStride", 2}, {"count", 4}}).find("triangle"),
            std::string::npos);
  EXPECT_NE(problem({{"count", 4000000000u}}).find("would take 48,000,000,000"), std::string::npos);
  EXPECT_NE(problem({{"byteLength", 99}}).find("reads up to byte 99 of buffer 0"),
            std::string::npos);
  EXPECT_NE(problem({{"buffer", 7}}).find("buffer 7"), std::string::npos);
  EXPECT_NE(problem({}, std::vector<std::uint8_t>(35)).find("does not have the declared length"),
            std::string::npos);
}

// Returns a primitive compressed by Draco; its bytes are not Draco's.
GltfBuilder dracoFile() {
  GltfBuilder file;
  const int view = file.view<std::uint8_t>({1, 2, 3});
  for (const char* type : {"VEC3", "VEC2"})
    file.add("accessors", {{"componentType", 5126}, {"count", 3}, {"type", type}});
  file.add("accessors", {{"componentType", 5123}, {"count", 3}, {"type", "SCALAR"}});
  file.mesh({{"POSITION", 0}, {"TEXCOORD_0", 1}},
            {{"indices", 2},
             {"mode", 5},
             {"extensions",
              {{"KHR_draco_mesh_compression",
                {{"bufferView", view}, {"attributes", {{"POSITION", 4}, {"TEXCOORD_0", 2}}}}}}}});
  file.node({{"mesh", 0}});
  return file;
}

TEST(GltfExtensions, AcceptsDecompressedPrimitives) {
  const File file = dracoFile().glb();
  ModelFile model(file);
  const std::vector<PackedPart> parts = model.packedParts({});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].bytes.size(), 3u);
  EXPECT_EQ(json::parse(parts[0].plan)["attributes"],
            (json{{{"id", 4}, {"componentType", 5126}, {"width", 3}},
                  {{"id", 2}, {"componentType", 5126}, {"width", 2}}}));
  const Indices corners{0, 2, 1};
  const auto* first = reinterpret_cast<const std::uint8_t*>(corners.data());
  model.unpack(0, {{first, first + 12}, rawBytes(triangle), rawBytes({0, 0, 1, 0, 0, 1})});
  const Loaded loaded = model.load({});
  ASSERT_TRUE(loaded.mesh) << loaded.problem;
  EXPECT_EQ(loaded.mesh->positions, triangle);
  EXPECT_EQ(loaded.mesh->indices, corners);
  EXPECT_EQ(loaded.mesh->uvs, (Floats{0, 0, 1, 0, 0, 1}));

  ModelFile broken(file);
  broken.packedParts({});
  EXPECT_THROW(broken.unpack(0, {{first, first + 12}, rawBytes(triangle), rawBytes({0, 0})}),
               std::runtime_error);
  ModelFile other(file);
  other.packedParts({});
  EXPECT_THROW(other.unpack(0, {{first, first + 12}}), std::runtime_error);
}

}  // namespace
}  // namespace warpjet
