// The JSON and the container are written here, not by tinygltf: its writer holds the arrays three
// times (in its model, in the chunk, in the stream), prints through iostreams, and takes 60 KB of
// WebAssembly for what is 30 lines below.
#include "mesh/gltf/export.hpp"

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <string_view>

#include "mesh/gltf/container.hpp"
#include "mesh/gltf/unit.hpp"

namespace warpjet {

namespace {

using nlohmann::json;

// Constants of the glTF 2.0 specification, sections 3.6 and 3.11.
constexpr int unsignedShort = 5123, unsignedInt = 5125, floatType = 5126;
constexpr int arrayBuffer = 34962, elementArrayBuffer = 34963;
constexpr int clampedEdge = 33071;

// 65535, the largest 16-bit index, is the restart value, so it can't refer to a vertex.
constexpr std::size_t maxVerticesOf16Bits = 65535;

// A GLB file being written: the JSON document, and the bytes that its buffer views refer to.
class File {
 public:
  json document{{"asset", {{"version", "2.0"}, {"generator", "warpjet " WARPJET_VERSION}}}};

  template <class T>
  int addView(std::span<const T> values) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    const std::size_t offset = bytes_.size();
    const auto* first = reinterpret_cast<const std::uint8_t*>(values.data());
    bytes_.insert(bytes_.end(), first, first + values.size_bytes());
    json& views = document["bufferViews"];
    views.push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", values.size_bytes()}});
    return static_cast<int>(views.size()) - 1;
  }

  // `size` is the number of values per element.
  template <class T>
  int addAccessor(std::span<const T> values, int size, int componentType, int target) {
    const int view = addView(values);
    document["bufferViews"][view]["target"] = target;
    const char* type = size == 1 ? "SCALAR" : size == 2 ? "VEC2" : size == 3 ? "VEC3" : "VEC4";
    json& accessors = document["accessors"];
    accessors.push_back({{"bufferView", view},
                         {"componentType", componentType},
                         {"count", values.size() / size},
                         {"type", type}});
    addRange(accessors.back(), values, size);
    return static_cast<int>(accessors.size()) - 1;
  }

  std::vector<std::uint8_t> glb();

 private:
  template <class T>
  void addRange(json& accessor, std::span<const T> values, int size) {
    std::vector<T> low(values.begin(), values.begin() + size), high = low;
    for (std::size_t element = 0; element < values.size(); element += size) {
      for (int i = 0; i < size; ++i) {
        low[i] = std::min(low[i], values[element + i]);
        high[i] = std::max(high[i], values[element + i]);
      }
    }
    accessor["min"] = low;
    accessor["max"] = high;
  }

  std::vector<std::uint8_t> bytes_;
};

void put(std::vector<std::uint8_t>& bytes, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8)
    bytes.push_back(static_cast<std::uint8_t>(word >> shift));
}

// Appends a chunk, padded to a multiple of four bytes.
template <class Bytes>
void putChunk(std::vector<std::uint8_t>& file, std::uint32_t type, const Bytes& bytes,
              std::uint8_t padding) {
  put(file, static_cast<std::uint32_t>((bytes.size() + 3) / 4 * 4));
  put(file, type);
  file.insert(file.end(), bytes.begin(), bytes.end());
  file.resize((file.size() + 3) / 4 * 4, padding);
}

std::vector<std::uint8_t> File::glb() {
  document["buffers"] = json::array({{{"byteLength", bytes_.size()}}});
  const std::string text = document.dump();
  const std::uint64_t length = 12 + 8 + (text.size() + std::uint64_t{3}) / 4 * 4 + 8 +
                               (bytes_.size() + std::uint64_t{3}) / 4 * 4;
  if (length > UINT32_MAX) throw std::length_error("a GLB file holds at most 4 GB");

  std::vector<std::uint8_t> file;
  file.reserve(static_cast<std::size_t>(length));
  put(file, 0x46546C67);  // "glTF"
  put(file, 2);
  put(file, static_cast<std::uint32_t>(length));
  putChunk(file, jsonChunk, text, ' ');
  putChunk(file, binaryChunk, bytes_, 0);
  return file;
}

int addIndices(File& file, const Mesh& mesh) {
  if (mesh.vertexCount() > maxVerticesOf16Bits)
    return file.addAccessor<std::uint32_t>(mesh.indices, 1, unsignedInt, elementArrayBuffer);
  const std::vector<std::uint16_t> narrow(mesh.indices.begin(), mesh.indices.end());
  return file.addAccessor<std::uint16_t>(narrow, 1, unsignedShort, elementArrayBuffer);
}

json attributes(File& file, const Mesh& mesh) {
  json attributes = json::object();
  const auto add = [&](const char* name, const std::vector<float>& numbers, int size) {
    if (!numbers.empty())
      attributes[name] = file.addAccessor<float>(numbers, size, floatType, arrayBuffer);
  };
  const std::vector<float> normals = unitNormals(mesh);
  std::vector<float> colors = mesh.colors;
  for (float& number : colors) number = std::clamp(number, 0.0F, 1.0F);
  add("POSITION", mesh.positions, 3);
  add("NORMAL", normals, 3);
  if (!normals.empty()) add("TANGENT", unitTangents(mesh.tangents, normals), 4);
  add("TEXCOORD_0", mesh.uvs, 2);
  add("COLOR_0", colors, 4);
  return attributes;
}

// Sets metallic to 0, since glTF's default is 1 and the mesh doesn't define it.
json material(const Material& material) {
  std::array<float, 4> color = material.baseColor;
  for (float& number : color) number = std::clamp(number, 0.0F, 1.0F);
  json result{{"pbrMetallicRoughness", {{"baseColorFactor", color}, {"metallicFactor", 0}}}};
  if (color[3] < 1) result["alphaMode"] = "BLEND";
  return result;
}

// Adds an image, if there is one whose type glTF supports, as the texture `name` of `owner`.
void addTexture(File& file, json& owner, const char* name, const std::optional<Image>& image,
                const json& sampling = json::object()) {
  const char* type = image ? pictureType(image->bytes) : nullptr;
  if (!type) return;
  const int view = file.addView<std::uint8_t>(image->bytes);
  json& images = file.document["images"];
  json texture = sampling;
  texture["source"] = images.size();
  images.push_back({{"bufferView", view}, {"mimeType", type}});
  json& textures = file.document["textures"];
  owner[name] = {{"index", textures.size()}};
  textures.push_back(std::move(texture));
}

// Returns the sampling of a texture without repetition, so that opposite borders are not blended.
json clampToEdge(File& file) {
  file.document["samplers"] = json::array({{{"wrapS", clampedEdge}, {"wrapT", clampedEdge}}});
  return {{"sampler", 0}};
}

bool areInUnitSquare(const std::vector<float>& uvs) {
  return std::all_of(uvs.begin(), uvs.end(), [](float uv) { return uv >= 0 && uv <= 1; });
}

void addTextures(File& file, const Mesh& mesh, json& material) {
  if (mesh.uvs.empty()) return;
  addTexture(file, material["pbrMetallicRoughness"], "baseColorTexture",
             mesh.material->baseColorTexture);
  const auto& normals = mesh.material->normalTexture;
  if (normals && areInUnitSquare(mesh.uvs))
    addTexture(file, material, "normalTexture", normals, clampToEdge(file));
  else
    addTexture(file, material, "normalTexture", normals);
}

}  // namespace

const char* pictureType(const std::vector<std::uint8_t>& bytes) {
  const auto startsWith = [&](std::string_view start) {
    return bytes.size() > start.size() &&
           std::memcmp(bytes.data(), start.data(), start.size()) == 0;
  };
  if (startsWith("\x89PNG\r\n\x1a\n")) return "image/png";
  if (startsWith("\xff\xd8\xff")) return "image/jpeg";
  return nullptr;
}

std::vector<std::uint8_t> exportGlb(const Mesh& mesh) {
  File file;
  json primitive{{"attributes", attributes(file, mesh)}};
  if (!mesh.indices.empty()) primitive["indices"] = addIndices(file, mesh);
  if (mesh.material) {
    json written = material(*mesh.material);
    addTextures(file, mesh, written);
    file.document["materials"] = json::array({std::move(written)});
    primitive["material"] = 0;
  }
  file.document["meshes"] = json::array({{{"primitives", json::array({std::move(primitive)})}}});
  file.document["nodes"] = json::array({{{"mesh", 0}}});
  file.document["scenes"] = json::array({{{"nodes", json::array({0})}}});
  file.document["scene"] = 0;
  return file.glb();
}

}  // namespace warpjet
