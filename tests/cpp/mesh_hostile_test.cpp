// Files that are broken or malicious: each must result in one message or in a valid mesh. The
// sanitizers also find any read past the end of a file, since its bytes are copied to a buffer of
// their exact size.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "gltf_builder.hpp"
#include "mesh/check.hpp"
#include "mesh/load.hpp"

namespace warpjet {
namespace {

// Returns the problem, after checking that there is either one message or a valid mesh.
std::string problemOfFile(const File& file) {
  const File exact(file.begin(), file.end());
  const Loaded loaded = loadMesh(exact);
  EXPECT_EQ(loaded.mesh.has_value(), loaded.problem.empty());
  if (loaded.mesh) {
    EXPECT_EQ(problemOf(*loaded.mesh), "");
    return {};
  }
  EXPECT_TRUE(loaded.problem.starts_with("loadMesh: ")) << loaded.problem;
  EXPECT_TRUE(loaded.problem.ends_with('.')) << loaded.problem;
  EXPECT_EQ(loaded.problem.find('\n'), std::string::npos) << loaded.problem;
  externalFiles(exact);
  return loaded.problem;
}

// Returns a file with every feature: two parts, indices, a stride, sparse values, materials, an
// image and nodes.
GltfBuilder richFile() {
  GltfBuilder file;
  const int positions = file.floats(triangle, "VEC3");
  file.tree["bufferViews"][0]["byteStride"] = 12;
  const json sparse = {
      {"count", 1},
      {"indices", {{"bufferView", file.view<std::uint8_t>({2})}, {"componentType", 5121}}},
      {"values", {{"bufferView", file.view<float>({7, 8, 9})}}}};
  const int moved = file.accessor(triangle, "VEC3", {{"sparse", sparse}});
  const int uvs = file.accessor<std::uint8_t>({0, 1, 2, 3, 4, 5}, "VEC2", {{"normalized", true}});
  const int indices = file.accessor<std::uint16_t>({0, 1, 2, 1}, "SCALAR");
  file.mesh({{"POSITION", positions}, {"TEXCOORD_0", uvs}},
            {{"indices", indices}, {"mode", 5}, {"material", 0}});
  file.mesh({{"POSITION", moved}, {"NORMAL", positions}}, {{"material", 1}});
  file.node({{"children", {1}}, {"scale", {1, 2, 3}}});
  file.node({{"mesh", 0}, {"rotation", {0, 0, 0, 1}}});
  file.node({{"mesh", 1}});
  file.tree["scenes"] = {{{"nodes", {0, 2}}}};
  file.tree["scene"] = 0;
  file.tree["images"] = {{{"uri", "data:image/png;base64,iVBORw=="}}};
  file.tree["textures"] = {{{"source", 0}}};
  file.tree["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}},
                            {{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 1}}}}}};
  return file;
}

TEST(HostileMesh, TheUnmodifiedFileIsValid) {
  EXPECT_EQ(problemOfFile(richFile().glb()), "");
  EXPECT_EQ(problemOfFile(richFile().embedded()), "");
}

TEST(HostileMesh, ReportsEveryTruncationOfAGlb) {
  const File file = richFile().glb();
  for (std::size_t length = 0; length < file.size(); ++length)
    EXPECT_NE(problemOfFile({file.begin(), file.begin() + length}), "") << length;
  EXPECT_EQ(problemOfFile({file.begin(), file.begin() + 1000}),
            "loadMesh: the file ends in the middle of its data (expected " + std::string("1,") +
                std::to_string(file.size()).substr(1) +
                " bytes, got 1,000); export or download it again.");
}

TEST(HostileMesh, ReportsEveryTruncationOfAGltf) {
  const File file = richFile().embedded();
  for (std::size_t length = 0; length < file.size(); ++length)
    EXPECT_NE(problemOfFile({file.begin(), file.begin() + length}), "") << length;
}

TEST(HostileMesh, SurvivesEveryFlippedBit) {
  File file = richFile().glb();
  for (std::size_t bit = 0; bit < file.size() * 8; ++bit) {
    file[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
    problemOfFile(file);
    file[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
  }
}

TEST(HostileMesh, SurvivesMembersOfTheWrongType) {
  const GltfBuilder file = richFile();
  const json whole = file.withBuffer(nullptr);
  const std::vector<json> wrongValues = {nullptr,
                                         true,
                                         -1,
                                         0,
                                         1,
                                         7,
                                         4294967295u,
                                         4294967296u,
                                         2147483648u,
                                         18446744073709551615u,
                                         0.5,
                                         1e300,
                                         "",
                                         "text",
                                         json::array(),
                                         json::object(),
                                         {1, 2, 3},
                                         {{1}},
                                         {{"a", 1}}};
  const json flat = whole.flatten();
  std::set<std::string> visited;
  for (const auto& member : flat.items()) {
    // Replaces the member itself and everything that contains it.
    for (json::json_pointer path(member.key()); !path.empty(); path.pop_back()) {
      if (!visited.insert(path.to_string()).second) continue;
      for (const json& value : wrongValues) {
        GltfBuilder broken = file;
        broken.tree = whole;
        broken.tree[path] = value;
        problemOfFile(broken.glb());
      }
    }
  }
}

struct Inconsistency {
  const char* what;
  std::function<void(json&)> apply;
  const char* messagePart;
};

TEST(HostileMesh, ReportsEachInconsistencyWithItsOwnMessage) {
  const json draw = {{"attributes", {{"POSITION", 0}}}};
  const std::vector<Inconsistency> inconsistencies = {
      {"count past the buffer", [](json& t) { t["accessors"][0]["count"] = 4; },
       "reads up to byte 48"},
      {"4 GB of vertices", [](json& t) { t["accessors"][0]["count"] = 4294967295u; },
       "reads up to byte 51,539,607,540 of bufferView 0"},
      {"a gigabyte of indices", [](json& t) { t["accessors"][3]["count"] = 268435456; },
       "reads up to byte 536,870,912 of bufferView"},
      {"an accessor without bytes, drawn by 16 nodes",
       [](json& t) {
         t["accessors"][0] = {{"componentType", 5126}, {"count", 4194303}, {"type", "VEC3"}};
         t["nodes"] = std::vector<json>(16, {{"mesh", 0}});
         t.erase("scenes");
         t.erase("scene");
       },
       "at most 1,073,741,824"},
      {"more than 32 bits", [](json& t) { t["accessors"][0]["count"] = 4294967299u; },
       "whole number"},
      {"offset past the view", [](json& t) { t["accessors"][0]["byteOffset"] = 4; },
       "reads up to byte"},
      {"offset that overflows", [](json& t) { t["accessors"][0]["byteOffset"] = 4294967288u; },
       "reads up to byte"},
      {"stride past the view", [](json& t) { t["bufferViews"][0]["byteStride"] = 252; },
       "reads up to byte"},
      {"invalid stride", [](json& t) { t["bufferViews"][0]["byteStride"] = 5; }, "byteStride"},
      {"view past the buffer", [](json& t) { t["bufferViews"][0]["byteLength"] = 100000; },
       "bufferView 0 reads up to byte 100,000"},
      {"view that overflows", [](json& t) { t["bufferViews"][0]["byteOffset"] = 4294967295u; },
       "bufferView 0 reads"},
      {"buffer past the file",
       [](json& t) {
         t["buffers"] = {{{"byteLength", 4000000000u}}};
       },
       "buffer 0: expected 4,000,000,000 bytes"},
      {"missing buffer", [](json& t) { t["bufferViews"][0]["buffer"] = 1; }, "buffer 1"},
      {"buffer without bytes",
       [](json& t) {
         t["buffers"] = {{{"byteLength", 100}}, {{"byteLength", 1}}};
       },
       "buffer 1 has neither"},
      {"broken base64",
       [](json& t) {
         t["buffers"] = {{{"byteLength", 1}, {"uri", "data:;base64,@@@@"}}};
       },
       "without valid base64"},
      {"base64 cut off",
       [](json& t) {
         t["buffers"] = {{{"byteLength", 9}, {"uri", "data:;base64,AAAA"}}};
       },
       "expected 9 bytes, got 3"},
      {"data uri without data",
       [](json& t) {
         t["buffers"] = {{{"byteLength", 1}, {"uri", "data:"}}};
       },
       "data URI without valid base64"},
      {"missing accessor",
       [](json& t) { t["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 99; },
       "accessor 99"},
      {"the mesh -1", [](json& t) { t["nodes"][1]["mesh"] = -1; }, "not -1"},
      {"index past the vertices",
       [](json& t) {
         t["accessors"][0]["count"] = 2;
         t["meshes"][0]["primitives"][0]["attributes"].erase("TEXCOORD_0");
       },
       "uses vertex 2"},
      {"counts that differ", [](json& t) { t["accessors"][2]["count"] = 2; },
       "3 positions, but 2 of TEXCOORD_0"},
      {"floats as indices", [](json& t) { t["meshes"][0]["primitives"][0]["indices"] = 0; },
       "single numbers"},
      {"indices as positions",
       [](json& t) { t["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 3; },
       "vectors of 3"},
      {"matrices as positions", [](json& t) { t["accessors"][0]["type"] = "MAT4"; },
       "vectors of 3"},
      {"an unknown type", [](json& t) { t["accessors"][0]["type"] = "VEC5"; }, "VEC5"},
      {"an unknown component type", [](json& t) { t["accessors"][0]["componentType"] = 5124; },
       "component type 5124"},
      {"an unknown mode", [](json& t) { t["meshes"][0]["primitives"][0]["mode"] = 7; }, "mode 7"},
      {"missing material", [](json& t) { t["meshes"][0]["primitives"][0]["material"] = 9; },
       "material 9"},
      {"missing texture",
       [](json& t) { t["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 3; },
       "texture 3"},
      {"missing image", [](json& t) { t["textures"][0]["source"] = 5; }, "image 5"},
      {"missing mesh", [](json& t) { t["nodes"][1]["mesh"] = 2; }, "mesh 2"},
      {"missing node", [](json& t) { t["nodes"][0]["children"] = {77}; }, "node 77"},
      {"missing scene", [](json& t) { t["scene"] = 1; }, "scene 1"},
      {"a node that is its own child", [](json& t) { t["nodes"][1]["children"] = {1}; },
       "node 1 is its own ancestor"},
      {"a circle of nodes", [](json& t) { t["nodes"][1]["children"] = {0}; },
       "node 0 is its own ancestor"},
      {"a node with two parents",
       [](json& t) {
         t["nodes"][0]["children"] = {1, 2};
       },
       "node 2 is its own ancestor or has two parents"},
      {"nodes in a circle, without a root",
       [](json& t) {
         t.erase("scenes");
         t.erase("scene");
         t["nodes"] = {{{"mesh", 0}, {"children", {0}}}};
       },
       "nothing to draw"},
      {"a short matrix",
       [](json& t) {
         t["nodes"][0]["matrix"] = {1, 2, 3};
       },
       "nodes[0].matrix must be a list of 16 numbers"},
      {"a transform beyond the range of floats",
       [](json& t) {
         t["nodes"][0]["scale"] = {1e300, 1e300, 1};
       },
       "positions must be finite"},
      {"too many zeros without bytes",
       [](json& t) {
         t["accessors"][0] = {{"componentType", 5126}, {"count", 4194305}, {"type", "VEC3"}};
       },
       "without any bytes"},
      {"sparse index past the end",
       [](json& t) {
         t["accessors"][1]["sparse"]["indices"] = {
             {"bufferView", 4}, {"byteOffset", 5}, {"componentType", 5121}};
       },
       "replaces its element 5"},
      {"more sparse values than elements",
       [](json& t) { t["accessors"][1]["sparse"]["count"] = 2147483647; },
       "replaces 2,147,483,647"},
      {"sparse without values", [](json& t) { t["accessors"][1]["sparse"].erase("values"); },
       "sparse.values is missing"},
      {"sparse offset past the view",
       [](json& t) { t["accessors"][1]["sparse"]["values"]["byteOffset"] = 2147483647; },
       "reads up to byte"},
      {"sparse indices of floats",
       [](json& t) { t["accessors"][1]["sparse"]["indices"]["componentType"] = 5126; },
       "reads up to byte"},
      {"nothing to draw",
       [](json& t) {
         t["nodes"] = json::array({json::object()});
         t["scenes"] = {{{"nodes", {0}}}};
       },
       "nothing to draw"},
      {"version 1", [](json& t) { t["asset"]["version"] = "1.0"; }, "only version 2"},
      {"missing asset", [](json& t) { t.erase("asset"); }, "asset is missing"},
      {"meshes that are not a list", [](json& t) { t["meshes"] = "cube"; },
       "meshes must be a list, not string"},
      {"a million parts",
       [&](json& t) {
         t["nodes"] = json::array();
         for (int i = 0; i < 2000; ++i) t["nodes"].push_back({{"mesh", 0}});
         t.erase("scenes");
         t.erase("scene");
         t["meshes"][0]["primitives"] = std::vector<json>(2000, draw);
       },
       "more than 1,048,576 parts"},
  };
  for (const Inconsistency& inconsistency : inconsistencies) {
    GltfBuilder file = richFile();
    inconsistency.apply(file.tree);
    const std::string problem = problemOfFile(file.glb());
    EXPECT_NE(problem.find(inconsistency.messagePart), std::string::npos)
        << inconsistency.what << ": " << problem;
  }
}

TEST(HostileMesh, ReportsNaNAndInfinity) {
  for (const float bad : {NAN, INFINITY, -INFINITY}) {
    GltfBuilder file;
    file.mesh({{"POSITION", file.floats({0, 0, 0, 1, bad, 0, 0, 1, 0}, "VEC3")}});
    file.node({{"mesh", 0}});
    EXPECT_NE(problemOfFile(file.glb()).find("positions must be finite numbers, but vertex 1"),
              std::string::npos);
  }
}

TEST(HostileMesh, AcceptsDeepChainsOfNodes) {
  GltfBuilder file = triangleFile();
  file.tree["nodes"] = json::array();
  for (int i = 0; i < 100000; ++i) file.node({{"children", {i + 1}}, {"translation", {1, 0, 0}}});
  file.node({{"mesh", 0}});
  EXPECT_EQ(loadMesh(file.glb()).mesh->positions[0], 100000);
}

TEST(HostileMesh, RejectsMalformedAndExcessiveJson) {
  const auto problem = [](const std::string& text) { return problemOfFile(bytesOf(text)); };
  const std::string deep = "is nested more than 64 deep";
  EXPECT_NE(problem("{\"a\":" + std::string(100000, '[')).find(deep), std::string::npos);
  EXPECT_NE(
      problem("{\"a\":" + std::string(100000, '[') + std::string(100000, ']') + "}").find(deep),
      std::string::npos);
  std::string objects = "{\"extras\":";
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  EXPECT_NE(problem(objects).find(deep), std::string::npos);
  std::string many = "{\"nodes\":[{}";
  for (int i = 0; i < 1100000; ++i) many += ",{}";
  EXPECT_NE(problem(many + "]}").find("1,048,576 objects"), std::string::npos);
  EXPECT_NE(problem("{\"a\":\"" + std::string(100000, '[') + "\"}").find("asset is missing"),
            std::string::npos);
  for (const char* text :
       {"{", "{}", "{\"a\"", "{\"\\", "{\"\\u", "{\"a\":1e999}", "{\"a\":\"\xFF\"}",
        "{\"asset\":{}}", "{\"asset\":{\"version\":\"2.0\"}}",
        "{\"asset\":{\"version\":\"2.0\\u0000\"}}"})
    EXPECT_NE(problem(text), "") << text;
}

TEST(HostileMesh, ReportsBrokenContainers) {
  const auto glb = [](std::initializer_list<std::uint64_t> words) {
    File file = bytesOf("glTF");
    for (const std::uint64_t word : words) append32(file, word);
    return problemOfFile(file);
  };
  constexpr std::uint64_t jsonChunk = 0x4E4F534A, binaryChunk = 0x004E4942, braces = 0x20207D7B;
  EXPECT_NE(glb({}).find("middle of its data"), std::string::npos);
  EXPECT_NE(glb({1, 20, 0, 0}).find("version 1"), std::string::npos);
  EXPECT_NE(glb({2, 20, 0, jsonChunk}).find("broken JSON"), std::string::npos);
  EXPECT_NE(glb({2, 12, 0, jsonChunk}).find("JSON chunk"), std::string::npos);
  EXPECT_NE(glb({2, 20, 0, binaryChunk}).find("JSON chunk"), std::string::npos);
  EXPECT_NE(glb({2, 24, 4294967295u, jsonChunk, braces}).find("middle of its data"),
            std::string::npos);
  EXPECT_NE(glb({2, 4294967295u, 4, jsonChunk, braces}).find("middle of its data"),
            std::string::npos);
  EXPECT_NE(glb({2, 24, 4, jsonChunk, braces}).find("asset is missing"), std::string::npos);
  EXPECT_NE(glb({2, 32, 4, jsonChunk, braces, 0, binaryChunk}).find("asset is missing"),
            std::string::npos);
  EXPECT_NE(glb({2, 32, 4, jsonChunk, braces, 4, binaryChunk}).find("middle of its data"),
            std::string::npos);
}

TEST(HostileMesh, ReportsOtherFileFormats) {
  const auto problem = [](const std::string& text) { return problemOfFile(bytesOf(text)); };
  EXPECT_EQ(problem(""), "loadMesh: the file is empty; export or download it again.");
  EXPECT_NE(problem("<!doctype html><title>404</title>").find("web page"), std::string::npos);
  EXPECT_NE(problem("Kaydara FBX Binary  " + std::string(1, '\0'))
                .find("not a .glb, .gltf, .obj or .stl"),
            std::string::npos);
  EXPECT_NE(problem("v 0 zero 0").find("line 1 of the .obj"), std::string::npos);
}

}  // namespace
}  // namespace warpjet
