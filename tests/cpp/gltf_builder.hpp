// Builds small glTF files for tests: numbers become views of one buffer, and tests can modify the
// JSON freely.
#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <vector>

namespace warpjet {

using nlohmann::json;
using File = std::vector<std::uint8_t>;

template <typename T>
constexpr int componentTypeOf() {
  if constexpr (std::is_same_v<T, std::int8_t>) return 5120;
  if constexpr (std::is_same_v<T, std::uint8_t>) return 5121;
  if constexpr (std::is_same_v<T, std::int16_t>) return 5122;
  if constexpr (std::is_same_v<T, std::uint16_t>) return 5123;
  if constexpr (std::is_same_v<T, std::uint32_t>) return 5125;
  return 5126;
}

inline File bytesOf(const std::string& text) { return {text.begin(), text.end()}; }

inline void append32(File& file, std::uint64_t number) {
  for (int shift = 0; shift < 32; shift += 8)
    file.push_back(static_cast<std::uint8_t>(number >> shift));
}

inline std::string base64(const File& bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

struct GltfBuilder {
  json tree = {{"asset", {{"version", "2.0"}}}};
  File binary;

  int add(const char* list, json element) {
    tree[list].push_back(std::move(element));
    return static_cast<int>(tree[list].size()) - 1;
  }

  // Appends the bytes of these numbers, aligned for any type.
  template <typename T>
  int view(const std::vector<T>& numbers) {
    binary.resize((binary.size() + 3) / 4 * 4);
    const std::size_t offset = binary.size(), length = numbers.size() * sizeof(T);
    binary.resize(offset + length);
    if (length > 0) std::memcpy(&binary[offset], numbers.data(), length);
    return add("bufferViews", {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}});
  }

  // Adds an accessor of tightly packed numbers; `more` adds or replaces members.
  template <typename T>
  int accessor(const std::vector<T>& numbers, const std::string& type, const json& more = {}) {
    const std::size_t width = type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');
    json element = {{"bufferView", view(numbers)},
                    {"componentType", componentTypeOf<T>()},
                    {"count", numbers.size() / width},
                    {"type", type}};
    if (more.is_object()) element.update(more);
    return add("accessors", element);
  }

  int floats(const std::vector<float>& numbers, const std::string& type) {
    return accessor(numbers, type);
  }

  // Adds a mesh with one primitive; `more` has indices, mode, material …
  int mesh(const json& attributes, const json& more = {}) {
    json primitive = {{"attributes", attributes}};
    if (more.is_object()) primitive.update(more);
    return add("meshes", {{"primitives", json::array({primitive})}});
  }

  int node(const json& node) { return add("nodes", node); }

  json withBuffer(const json& uri) const {
    json whole = tree;
    if (!binary.empty()) {
      json buffer = {{"byteLength", binary.size()}};
      if (!uri.is_null()) buffer["uri"] = uri;
      if (!whole.contains("buffers")) whole["buffers"] = json::array({buffer});
    }
    return whole;
  }

  File glb() const {
    std::string text = withBuffer(nullptr).dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    File padded = binary;
    padded.resize((padded.size() + 3) / 4 * 4);
    File file = bytesOf("glTF");
    append32(file, 2);
    append32(file, 12 + 8 + text.size() + (padded.empty() ? 0 : 8 + padded.size()));
    append32(file, text.size());
    append32(file, 0x4E4F534A);
    file.insert(file.end(), text.begin(), text.end());
    if (padded.empty()) return file;
    append32(file, padded.size());
    append32(file, 0x004E4942);
    file.insert(file.end(), padded.begin(), padded.end());
    return file;
  }

  File embedded() const {
    return bytesOf(withBuffer("data:application/octet-stream;base64," + base64(binary)).dump());
  }

  File external(const std::string& uri) const { return bytesOf(withBuffer(uri).dump()); }
};

// One triangle in the plane z = 0, in the order of its vertices, shown by one node.
inline const std::vector<float> triangle{0, 0, 0, 1, 0, 0, 0, 1, 0};

inline GltfBuilder triangleFile() {
  GltfBuilder file;
  file.mesh({{"POSITION", file.floats(triangle, "VEC3")}});
  file.node({{"mesh", 0}});
  return file;
}

}  // namespace warpjet
