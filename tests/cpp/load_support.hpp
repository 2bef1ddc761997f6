// Loads models for tests, and compares their numbers.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "gltf_builder.hpp"
#include "mesh/check.hpp"
#include "mesh/load.hpp"

namespace warpjet {

using Floats = std::vector<float>;
using Indices = std::vector<std::uint32_t>;

inline Mesh loadValid(const File& file, const Files& files = {}) {
  Loaded result = loadMesh(file, files);
  EXPECT_EQ(result.problem, "");
  if (!result.mesh) return {};
  EXPECT_EQ(problemOf(*result.mesh), "");
  return *result.mesh;
}

inline std::vector<std::string> warningsOf(const File& file) { return loadMesh(file).warnings; }

inline void expectNear(const Floats& actual, const Floats& expected, float tolerance = 1e-6f) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i)
    EXPECT_NEAR(actual[i], expected[i], tolerance) << i;
}

// Returns a file of two triangles, each with a material, and with three textures: in the file, in a
// data URI, and in an external file.
inline GltfBuilder materialFile(const json& first, const json& second) {
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

inline json texture(int index) { return {{"baseColorTexture", {{"index", index}}}}; }

}  // namespace warpjet
