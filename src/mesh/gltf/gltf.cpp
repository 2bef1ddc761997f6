#include "mesh/gltf/gltf.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "mesh/gltf/json_text.hpp"
#include "mesh/gltf/schema.hpp"
#include "mesh/sentences.hpp"
#include "mesh/uri.hpp"

namespace warpjet {

namespace {

using nlohmann::json;

constexpr const char* draco = "KHR_draco_mesh_compression";

// Those that move no vertex.
bool isHarmless(std::string_view extension) {
  constexpr std::array<std::string_view, 6> names{"KHR_mesh_quantization", "KHR_texture_transform",
                                                  "KHR_lights_punctual",   "KHR_animation_pointer",
                                                  "KHR_xmp_json_ld",       "KHR_xmp"};
  return extension.starts_with("KHR_materials_") ||
         std::find(names.begin(), names.end(), extension) != names.end();
}

std::string adviceFor(std::string_view extension) {
  if (extension == draco) return "without Draco compression";
  if (extension.ends_with("_meshopt_compression")) return "without meshopt compression";
  if (extension.find("_texture_") != extension.npos) return "with PNG or JPEG textures";
  return "without it";
}

[[noreturn]] void refuseExtension(const char* verb, const std::string& name) {
  throw FileProblem("the model " + std::string(verb) + " the extension " + quotedText(name) +
                    ", which is not read here; export the model " + adviceFor(name) + '.');
}

// Before anything else is looked at: a compressed model has accessors without bytes, for one.
void refuseExtensions(const json& tree) {
  const auto required = tree.find("extensionsRequired");
  if (required == tree.end()) return;
  for (const json& entry : *required) {
    const std::string name = entry;
    if (!isHarmless(name)) refuseExtension("requires", name);
  }
}

// Removes a member; an empty list where there is none.
json taken(json& tree, const char* name) {
  json list = json::array();
  if (const auto found = tree.find(name); found != tree.end()) {
    list = std::move(*found);
    tree.erase(found);
  }
  return list;
}

std::string textOr(const json& object, const char* name) {
  const auto found = object.find(name);
  return found == object.end() ? std::string() : found->get<std::string>();
}

// What tinygltf would look up and decode itself, if it saw it.
void keepBuffersAndImages(Gltf& gltf, json& tree) {
  for (const json& buffer : taken(tree, "buffers"))
    gltf.buffers.push_back({textOr(buffer, "uri"), buffer["byteLength"].get<std::uint64_t>(), {}});
  for (const json& image : taken(tree, "images")) {
    tinygltf::Image& kept = gltf.model.images.emplace_back();
    kept.uri = textOr(image, "uri");
    kept.mimeType = textOr(image, "mimeType");
    kept.bufferView = image.value("bufferView", -1);
  }
}

void warnOfMotion(Gltf& gltf, json& tree) {
  if (!taken(tree, "animations").empty())
    gltf.warn("The model has animations; they are ignored, and it stands still.");
}

// In a primitive that is compressed, although the model requires no extension for it, accessors may
// have no bytes of their own. Indices without any are right glTF where they are sparse, but
// tinygltf refuses them in words that help nobody.
void refuseAccessorsWithoutBytes(const json& tree) {
  const json noElements = json::array();
  const auto listOf = [&](const json& object, const char* name) -> const json& {
    const auto found = object.find(name);
    return found == object.end() ? noElements : *found;
  };
  const json& accessors = listOf(tree, "accessors");
  const auto hasBytes = [&](const json& accessor) {
    const auto place = accessor.get<std::uint64_t>();
    return place >= accessors.size() ||
           accessors[static_cast<std::size_t>(place)].contains("bufferView");
  };
  for (const json& mesh : listOf(tree, "meshes")) {
    for (const json& primitive : listOf(mesh, "primitives")) {
      const json& attributes = primitive["attributes"];
      const auto indices = primitive.find("indices");
      const bool hasIndices = indices == primitive.end() || hasBytes(*indices);
      if (listOf(primitive, "extensions").contains(draco) &&
          !(hasIndices && std::all_of(attributes.begin(), attributes.end(), hasBytes)))
        refuseExtension("uses", draco);
      if (!hasIndices)
        throw FileProblem("accessor " + indices->dump() +
                          " has indices without a bufferView, which are not read here; export the "
                          "model without sparse indices.");
    }
  }
}

// tinygltf writes several lines; the first says most.
[[noreturn]] void failAs(const std::string& error) {
  throw FileProblem("the file is not right glTF (" + quotedText(error.substr(0, error.find('\n'))) +
                    "); export the model again.");
}

// The bytes behind a buffer's uri, or of the chunk if it has none.
Bytes bytesOfBuffer(Gltf& gltf, std::size_t place, std::optional<Bytes> binary,
                    const Files& files) {
  const std::string& uri = gltf.buffers[place].uri;
  const std::string name = "buffer " + std::to_string(place);
  if (uri.empty()) {
    if (place == 0 && binary) return *binary;
    throw FileProblem(name + " has neither a uri nor a binary chunk; export the model as .glb.");
  }
  if (isDataUri(uri)) {
    std::optional<DataUri> data = decodedDataUri(uri);
    if (!data)
      throw FileProblem(name +
                        " is a data URI without right base64; export or download the file again.");
    return gltf.decoded.emplace_back(std::move(data->bytes));
  }
  if (const auto* file = fileOf(uri, files)) return *file;
  throw FileProblem("the model needs the file " + quotedText(uri) +
                    "; hand it over with the model, or export the model as .glb.");
}

}  // namespace

void Gltf::warn(const std::string& sentence) {
  if (std::find(warnings.begin(), warnings.end(), sentence) == warnings.end())
    warnings.push_back(sentence);
}

std::size_t checkedIndex(const char* what, int index, std::size_t count) {
  if (index >= 0 && static_cast<std::size_t>(index) < count) return static_cast<std::size_t>(index);
  throw FileProblem("the file speaks of " + std::string(what) + ' ' + std::to_string(index) +
                    ", but has only " + grouped(count) + " of them; export the model again.");
}

Gltf describedGltf(std::string_view text) {
  json tree = parseJson(text);
  reduceToSchema(tree);
  Gltf gltf;
  const std::string version = tree["asset"]["version"];
  if (!version.starts_with("2."))
    throw FileProblem("this is glTF " + quotedText(version) +
                      ", but only version 2 is read; export the model as glTF 2.0.");
  refuseExtensions(tree);
  warnOfMotion(gltf, tree);
  keepBuffersAndImages(gltf, tree);
  std::vector<tinygltf::Image> images = std::move(gltf.model.images);

  refuseAccessorsWithoutBytes(tree);
  const std::string checked = tree.dump();
  tree = nullptr;
  std::string error, warning;
  if (!tinygltf::TinyGLTF().LoadASCIIFromString(&gltf.model, &error, &warning, checked.data(),
                                                static_cast<unsigned>(checked.size()), ""))
    failAs(error);
  gltf.model.images = std::move(images);
  return gltf;
}

void findBuffers(Gltf& gltf, std::optional<Bytes> binary, const Files& files) {
  for (std::size_t i = 0; i < gltf.buffers.size(); ++i) {
    Buffer& buffer = gltf.buffers[i];
    const Bytes bytes = bytesOfBuffer(gltf, i, binary, files);
    if (buffer.length > bytes.size())
      throw FileProblem("the file ends in the middle of its data (buffer " + std::to_string(i) +
                        " says " + grouped(buffer.length) + " bytes, " + grouped(bytes.size()) +
                        " came); export or download it again.");
    buffer.bytes = bytes.first(static_cast<std::size_t>(buffer.length));
  }
}

Bytes bytesOfView(const Gltf& gltf, int bufferView) {
  const auto& views = gltf.model.bufferViews;
  const auto& view = views[checkedIndex("bufferView", bufferView, views.size())];
  const Buffer& buffer = gltf.buffers[checkedIndex("buffer", view.buffer, gltf.buffers.size())];
  // Offset and length are below 2^32 each, but their sum need not fit where size_t has 32 bits.
  if (std::uint64_t{view.byteOffset} + view.byteLength > buffer.bytes.size())
    throw FileProblem("bufferView " + std::to_string(bufferView) + " reads up to byte " +
                      grouped(std::uint64_t{view.byteOffset} + view.byteLength) + " of buffer " +
                      std::to_string(view.buffer) + ", which has only " +
                      grouped(buffer.bytes.size()) + "; export the model again.");
  return buffer.bytes.subspan(view.byteOffset, view.byteLength);
}

}  // namespace warpjet
