#include "mesh/gltf/packed.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "mesh/messages.hpp"

namespace warpjet {

namespace {

using nlohmann::json;

const tinygltf::Accessor& accessorAt(const Gltf& gltf, int accessor) {
  const auto& accessors = gltf.model.accessors;
  return accessors[checkIndex("accessor", accessor, accessors.size())];
}

template <typename Function>
void forAccessors(const tinygltf::Primitive& primitive, Function function) {
  for (const auto& [name, accessor] : primitive.attributes) function(accessor);
  for (const auto& target : primitive.targets)
    for (const auto& [name, accessor] : target) function(accessor);
  if (primitive.indices >= 0) function(primitive.indices);
}

// Returns the views whose bytes are needed for drawing; those of animations remain packed.
std::set<int> findNeededViews(const Gltf& gltf) {
  std::set<int> views;
  const auto need = [&](int accessor) {
    if (accessor < 0) return;
    const tinygltf::Accessor& info = accessorAt(gltf, accessor);
    views.insert(info.bufferView);
    if (!info.sparse.isSparse) return;
    views.insert(info.sparse.indices.bufferView);
    views.insert(info.sparse.values.bufferView);
  };
  for (const tinygltf::Mesh& mesh : gltf.model.meshes)
    for (const tinygltf::Primitive& primitive : mesh.primitives) forAccessors(primitive, need);
  for (const tinygltf::Skin& skin : gltf.model.skins) need(skin.inverseBindMatrices);
  for (const auto& [node, instancing] : gltf.extensions.instancing)
    for (const int accessor : {instancing.translation, instancing.rotation, instancing.scale})
      need(accessor);
  for (const tinygltf::Image& image : gltf.model.images) views.insert(image.bufferView);
  return views;
}

std::vector<PackedPlace> placesOf(const Gltf& gltf) {
  std::vector<PackedPlace> places;
  const std::set<int> needed = findNeededViews(gltf);
  for (const auto& [view, packed] : gltf.extensions.meshoptViews)
    if (needed.contains(view)) places.push_back({view, {}});
  for (const auto& [place, packed] : gltf.extensions.draco) places.push_back({-1, place});
  return places;
}

const tinygltf::Primitive& primitiveAt(const Gltf& gltf, std::pair<std::size_t, std::size_t> at) {
  return gltf.model.meshes[at.first].primitives[at.second];
}

[[noreturn]] void failPacked(const std::string& what, const std::string& problem) {
  throw FileProblem(what + ' ' + problem + "; export the model again.");
}

// Checks the requirements of the extension on a view (its section "JSON schema updates").
void checkMeshopt(int view, const MeshoptView& packed) {
  const std::string what = "the compressed bufferView " + std::to_string(view);
  const auto isOneOf = [](const std::string& word, std::initializer_list<const char*> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  const std::uint64_t stride = packed.byteStride;
  if (!isOneOf(packed.mode, {"ATTRIBUTES", "TRIANGLES", "INDICES"}))
    failPacked(what, "has the unknown mode " + quoteText(packed.mode));
  if (!isOneOf(packed.filter, {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"}))
    failPacked(what, "has the unknown filter " + quoteText(packed.filter));
  const bool isVertices = packed.mode == "ATTRIBUTES";
  bool isStrideValid = isVertices ? stride > 0 && stride % 4 == 0 && stride <= 256
                                  : (stride == 2 || stride == 4) && packed.filter == "NONE";
  if (isOneOf(packed.filter, {"OCTAHEDRAL", "COLOR"})) isStrideValid &= stride == 4 || stride == 8;
  if (packed.filter == "QUATERNION") isStrideValid &= stride == 8;
  if (!isStrideValid)
    failPacked(what, "has the byteStride " + groupDigits(stride) + ", which its mode " +
                         packed.mode + " and filter " + packed.filter + " do not allow");
  if (packed.mode == "TRIANGLES" && packed.count % 3 != 0)
    failPacked(what, "ends in the middle of a triangle");
}

bool hasBytes(const Gltf& gltf, int accessor) { return accessorAt(gltf, accessor).bufferView >= 0; }

bool isOptional(const Gltf& gltf, const PackedPlace& part) {
  if (part.view >= 0) {
    const int buffer = gltf.model.bufferViews[static_cast<std::size_t>(part.view)].buffer;
    return buffer >= 0 && static_cast<std::size_t>(buffer) < gltf.buffers.size() &&
           !gltf.buffers[static_cast<std::size_t>(buffer)].bytes.empty();
  }
  bool hasAll = true;
  forAccessors(primitiveAt(gltf, part.primitive),
               [&](int accessor) { hasAll &= hasBytes(gltf, accessor); });
  return hasAll;
}

std::string extensionOf(const Gltf& gltf, const PackedPlace& part) {
  return part.view < 0 ? dracoExtension : gltf.extensions.meshoptViews.at(part.view).extension;
}

// Returns the width of a decoded Draco attribute, which must be a vector.
std::size_t widthOf(const tinygltf::Accessor& info) {
  if (info.type > TINYGLTF_TYPE_VEC4 && info.type != TINYGLTF_TYPE_SCALAR)
    throw FileProblem("the model compresses matrices with Draco; export the model again.");
  return info.type == TINYGLTF_TYPE_SCALAR ? 1 : static_cast<std::size_t>(info.type);
}

// Returns the attributes of the extension that the primitive has: the name of each, and the
// accessor that declares its type.
std::vector<std::pair<std::string, int>> dracoAttributes(const Gltf& gltf,
                                                         const PackedPlace& part) {
  const auto& attributes = primitiveAt(gltf, part.primitive).attributes;
  std::vector<std::pair<std::string, int>> found;
  for (const auto& [name, id] : gltf.extensions.draco.at(part.primitive).attributes)
    if (const auto accessor = attributes.find(name); accessor != attributes.end())
      found.emplace_back(*accessor);
  return found;
}

PackedPart packedPartOf(const Gltf& gltf, const PackedPlace& part) {
  json plan{{"extension", extensionOf(gltf, part)}, {"isOptional", isOptional(gltf, part)}};
  if (part.view >= 0) {
    const MeshoptView& packed = gltf.extensions.meshoptViews.at(part.view);
    checkMeshopt(part.view, packed);
    plan.update({{"codec", "meshopt"},
                 {"count", packed.count},
                 {"byteStride", packed.byteStride},
                 {"mode", packed.mode},
                 {"filter", packed.filter}});
    return {bytesOfBuffer(gltf, "the compressed bufferView " + std::to_string(part.view),
                          packed.buffer, packed.byteOffset, packed.byteLength),
            plan.dump()};
  }
  const DracoPrimitive& packed = gltf.extensions.draco.at(part.primitive);
  plan["codec"] = "draco";
  plan["attributes"] = json::array();
  for (const auto& [name, accessor] : dracoAttributes(gltf, part)) {
    const tinygltf::Accessor& info = accessorAt(gltf, accessor);
    plan["attributes"].push_back({{"id", packed.attributes.at(name)},
                                  {"componentType", info.componentType},
                                  {"width", widthOf(info)}});
  }
  return {bytesOfView(gltf, packed.bufferView), plan.dump()};
}

// Adds a view, and an accessor that reads it.
int addAccessor(Gltf& gltf, tinygltf::Accessor info, std::size_t count,
                std::vector<std::uint8_t> bytes) {
  const int view = static_cast<int>(gltf.model.bufferViews.size());
  tinygltf::BufferView& added = gltf.model.bufferViews.emplace_back();
  added.byteLength = bytes.size();
  gltf.unpackedViews[view] = std::move(bytes);
  info.bufferView = view;
  info.byteOffset = 0;
  info.count = count;
  info.sparse = {};
  gltf.model.accessors.push_back(info);
  return static_cast<int>(gltf.model.accessors.size()) - 1;
}

void unpackDraco(Gltf& gltf, const PackedPlace& part, Pieces pieces) {
  const auto [mesh, place] = part.primitive;
  const std::string what = "the Draco data of mesh " + std::to_string(mesh);
  tinygltf::Primitive& primitive = gltf.model.meshes[mesh].primitives[place];
  const auto attributes = dracoAttributes(gltf, part);
  if (pieces.size() != attributes.size() + 1 || pieces[0].size() % (3 * sizeof(std::uint32_t)) != 0)
    failPacked(what, "has other attributes than the primitive");
  std::size_t vertices = 0;
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    const tinygltf::Accessor info = accessorAt(gltf, attributes[i].second);
    const auto size = static_cast<std::size_t>(std::max(
        tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(info.componentType)), 1));
    const std::size_t count = pieces[i + 1].size() / (size * widthOf(info));
    if (i > 0 && count != vertices) failPacked(what, "has attributes of different lengths");
    vertices = count;
    primitive.attributes[attributes[i].first] =
        addAccessor(gltf, info, count, std::move(pieces[i + 1]));
  }
  tinygltf::Accessor corners;
  corners.type = TINYGLTF_TYPE_SCALAR;
  corners.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  const std::size_t count = pieces[0].size() / sizeof(std::uint32_t);
  primitive.indices = addAccessor(gltf, corners, count, std::move(pieces[0]));
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
}

}  // namespace

std::vector<PackedPart> findPacked(Gltf& gltf) {
  gltf.packed = placesOf(gltf);
  std::vector<PackedPart> parts;
  std::uint64_t bytes = 0;
  for (const PackedPlace& place : gltf.packed) {
    parts.push_back(packedPartOf(gltf, place));
    if (place.view < 0) continue;
    const MeshoptView& view = gltf.extensions.meshoptViews.at(place.view);
    // At most 2^20 views of 2^40 bytes: no overflow.
    bytes += view.count * view.byteStride;
    if (bytes > maxMeshBytes)
      throw FileProblem("the model would take " + groupDigits(bytes) + " bytes, but at most " +
                        groupDigits(maxMeshBytes) +
                        " are read; export it with fewer triangles or in several files.");
  }
  return parts;
}

void unpack(Gltf& gltf, std::size_t index, Pieces pieces) {
  PackedPlace& part = gltf.packed.at(index);
  for (const auto& piece : pieces) gltf.unpackedBytes += piece.size();
  if (gltf.unpackedBytes > maxMeshBytes)
    throw FileProblem("the model is larger than " + groupDigits(maxMeshBytes) +
                      " bytes once it is unpacked; export it with fewer triangles.");
  if (part.isUnpacked) return;
  part.isUnpacked = true;
  if (part.view < 0) return unpackDraco(gltf, part, std::move(pieces));
  const MeshoptView& view = gltf.extensions.meshoptViews.at(part.view);
  if (pieces.size() != 1 || pieces[0].size() != view.count * view.byteStride)
    failPacked("the compressed bufferView " + std::to_string(part.view),
               "does not have the declared length");
  gltf.unpackedViews[part.view] = std::move(pieces[0]);
}

void rejectPacked(const Gltf& gltf) {
  for (const PackedPlace& part : gltf.packed)
    if (!part.isUnpacked && !isOptional(gltf, part))
      throw FileProblem("the model is compressed by " + extensionOf(gltf, part) +
                        ", for which there is no decoder here; export the model " +
                        adviceFor(extensionOf(gltf, part)) + '.');
}

}  // namespace warpjet
