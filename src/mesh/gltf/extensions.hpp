// The glTF extensions that change a mesh, extracted from its description.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace warpjet {

// EXT_mesh_gpu_instancing: accessors, or -1.
struct Instancing {
  int translation = -1, rotation = -1, scale = -1;

  bool hasAttributes() const { return translation >= 0 || rotation >= 0 || scale >= 0; }
};

// The color of a material: from pbrMetallicRoughness, or from KHR_materials_pbrSpecularGlossiness
// if present.
struct BaseColor {
  std::array<double, 4> color{1, 1, 1, 1};
  int texture = -1, texCoord = 0;
  bool isTransformed = false;  // by KHR_texture_transform
};

// A bufferView compressed by EXT_meshopt_compression or KHR_meshopt_compression.
struct MeshoptView {
  std::string extension;
  int buffer = -1;
  std::uint64_t byteOffset = 0, byteLength = 0, byteStride = 0, count = 0;
  std::string mode, filter;
};

// A primitive compressed by KHR_draco_mesh_compression.
struct DracoPrimitive {
  int bufferView = -1;
  std::map<std::string, int> attributes;  // name to Draco's id
};

inline constexpr const char* dracoExtension = "KHR_draco_mesh_compression";

struct Extensions {
  std::map<int, Instancing> instancing;  // by node
  std::set<int> hiddenNodes;             // KHR_node_visibility; their descendants are hidden, too
  std::map<int, BaseColor> glossiness;   // by material
  std::map<int, MeshoptView> meshoptViews;
  std::map<std::pair<std::size_t, std::size_t>, DracoPrimitive> draco;  // by mesh and primitive
};

// Throws a FileProblem if a description requires an unsupported extension that would change the
// mesh. Extensions that only change textures disable those textures.
void rejectExtensions(const nlohmann::json& tree);

// Extracts the extensions from a description that has been reduced to the schema.
Extensions takeExtensions(nlohmann::json& tree);

// Returns advice on how to export a model instead, such as "without Draco compression".
std::string adviceFor(std::string_view extension);

}  // namespace warpjet
