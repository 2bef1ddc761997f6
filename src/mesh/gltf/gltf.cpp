#include "mesh/gltf/gltf.hpp"

#include <algorithm>
#include <utility>

#include "mesh/gltf/json_text.hpp"
#include "mesh/gltf/schema.hpp"
#include "mesh/messages.hpp"
#include "mesh/uri.hpp"

namespace warpjet {

namespace {

using nlohmann::json;

// Removes and returns a member; an empty list if it is missing.
json takeMember(json& tree, const char* name) {
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

// Returns true if the buffer's bytes are only a fallback for readers without the extensions for
// meshopt compression.
bool isFallback(const json& buffer) {
  const auto extensions = buffer.find("extensions");
  if (extensions == buffer.end()) return false;
  return std::any_of(extensions->begin(), extensions->end(),
                     [](const json& extension) { return extension.value("fallback", false); });
}

// Moves buffers and images out of the tree, since tinygltf would load and decode them by itself.
void takeBuffersAndImages(Gltf& gltf, json& tree) {
  for (const json& buffer : takeMember(tree, "buffers"))
    gltf.buffers.push_back(
        {textOr(buffer, "uri"), buffer["byteLength"].get<std::uint64_t>(), isFallback(buffer), {}});
  for (const json& image : takeMember(tree, "images")) {
    tinygltf::Image& added = gltf.model.images.emplace_back();
    added.uri = textOr(image, "uri");
    added.mimeType = textOr(image, "mimeType");
    added.bufferView = image.value("bufferView", -1);
  }
}

void warnOfMotion(Gltf& gltf, json& tree) {
  if (!takeMember(tree, "animations").empty())
    gltf.warn("The model has animations; they are ignored.");
}

// tinygltf rejects indices without a view, which are valid if they are sparse or compressed; so
// they are hidden from it.
class HiddenIndices {
 public:
  explicit HiddenIndices(json& tree) {
    const auto meshes = tree.find("meshes");
    if (meshes == tree.end()) return;
    for (json& mesh : *meshes)
      for (json& primitive : mesh["primitives"]) {
        indices_.push_back(primitive.value("indices", -1));
        primitive.erase("indices");
      }
  }

  void show(tinygltf::Model& model) const {
    auto next = indices_.begin();
    for (tinygltf::Mesh& mesh : model.meshes)
      for (tinygltf::Primitive& primitive : mesh.primitives) primitive.indices = *next++;
  }

 private:
  std::vector<int> indices_;
};

// Throws with the first line of tinygltf's message, which has the cause.
[[noreturn]] void failInvalid(const std::string& error) {
  throw FileProblem("the file is not valid glTF (" + quoteText(error.substr(0, error.find('\n'))) +
                    "); export the model again.");
}

// Returns the bytes at a buffer's URI, or of the binary chunk if the buffer has no URI; empty for a
// missing fallback.
Bytes findBytes(Gltf& gltf, std::size_t index, std::optional<Bytes> binary, const Files& files) {
  const auto& [uri, length, isFallback, bytes] = gltf.buffers[index];
  const std::string name = "buffer " + std::to_string(index);
  if (uri.empty()) {
    if (index == 0 && binary) return *binary;
    if (isFallback) return {};
    throw FileProblem(name + " has neither a uri nor a binary chunk; export the model as .glb.");
  }
  if (isDataUri(uri)) {
    std::optional<DataUri> data = decodeDataUri(uri);
    if (!data)
      throw FileProblem(name +
                        " is a data URI without valid base64; export or download the file again.");
    return gltf.decodedUris.emplace_back(std::move(data->bytes));
  }
  if (const auto* file = fileOf(uri, files)) return *file;
  if (isFallback) return {};
  throw FileProblem("the model needs the file " + quoteText(uri) +
                    "; pass it with the model, or export the model as .glb.");
}

}  // namespace

void Gltf::warn(const std::string& message) {
  if (std::find(warnings.begin(), warnings.end(), message) == warnings.end())
    warnings.push_back(message);
}

std::size_t checkIndex(const char* what, int index, std::size_t count) {
  if (index >= 0 && static_cast<std::size_t>(index) < count) return static_cast<std::size_t>(index);
  throw FileProblem("the file refers to " + std::string(what) + ' ' + std::to_string(index) +
                    ", but has only " + groupDigits(count) + " of them; export the model again.");
}

Gltf parseDescription(std::string_view text) {
  json tree = parseJson(text);
  reduceToSchema(tree);
  Gltf gltf;
  const std::string version = tree["asset"]["version"];
  if (!version.starts_with("2."))
    throw FileProblem("this is glTF " + quoteText(version) +
                      ", but only version 2 is supported; export the model as glTF 2.0.");
  rejectExtensions(tree);
  warnOfMotion(gltf, tree);
  takeBuffersAndImages(gltf, tree);
  std::vector<tinygltf::Image> images = std::move(gltf.model.images);

  gltf.extensions = takeExtensions(tree);
  const HiddenIndices indices(tree);
  const std::string checked = tree.dump();
  tree = nullptr;
  std::string error, warning;
  if (!tinygltf::TinyGLTF().LoadASCIIFromString(&gltf.model, &error, &warning, checked.data(),
                                                static_cast<unsigned>(checked.size()), ""))
    failInvalid(error);
  gltf.model.images = std::move(images);
  indices.show(gltf.model);
  return gltf;
}

void findBuffers(Gltf& gltf, std::optional<Bytes> binary, const Files& files) {
  for (std::size_t i = 0; i < gltf.buffers.size(); ++i) {
    Buffer& buffer = gltf.buffers[i];
    const Bytes bytes = findBytes(gltf, i, binary, files);
    if (buffer.isFallback && bytes.empty()) continue;
    if (buffer.length > bytes.size())
      throw FileProblem("the file ends in the middle of its data (buffer " + std::to_string(i) +
                        ": expected " + groupDigits(buffer.length) + " bytes, got " +
                        groupDigits(bytes.size()) + "); export or download it again.");
    buffer.bytes = bytes.first(static_cast<std::size_t>(buffer.length));
  }
}

Bytes bytesOfBuffer(const Gltf& gltf, const std::string& what, int index, std::uint64_t offset,
                    std::uint64_t length) {
  const Buffer& buffer = gltf.buffers[checkIndex("buffer", index, gltf.buffers.size())];
  // Offset and length are below 2^32 each, but their sum may overflow a 32-bit size_t.
  if (offset + length > buffer.bytes.size())
    throw FileProblem(what + " reads up to byte " + groupDigits(offset + length) + " of buffer " +
                      std::to_string(index) + ", which has only " +
                      groupDigits(buffer.bytes.size()) + "; export the model again.");
  return buffer.bytes.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
}

Bytes bytesOfView(const Gltf& gltf, int bufferView) {
  const auto unpacked = gltf.unpackedViews.find(bufferView);
  if (unpacked != gltf.unpackedViews.end()) return unpacked->second;
  const auto& views = gltf.model.bufferViews;
  const auto& view = views[checkIndex("bufferView", bufferView, views.size())];
  return bytesOfBuffer(gltf, "bufferView " + std::to_string(bufferView), view.buffer,
                       view.byteOffset, view.byteLength);
}

}  // namespace warpjet
