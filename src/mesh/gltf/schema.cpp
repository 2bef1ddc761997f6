#include "mesh/gltf/schema.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <string>

#include "mesh/messages.hpp"

namespace warpjet {

namespace {

using nlohmann::json;

enum class Kind {
  Index,    // the index of an element of one of the lists
  Size,     // a count, an offset or an enumeration
  Flag,     // true or false
  Text,     //
  Numbers,  // `length` numbers; any number of them if `length` is 0
  Indices,  // any number of indices
  Names,    // any number of strings
  Keys,     // an object of which only the keys are needed
  Some,     // a list; only whether it is empty matters
  Object,   //
  Objects   // a list of objects
};

struct Member {
  const char* name;
  Kind kind;
  bool isRequired = false;
  std::size_t length = 0;             // of Numbers
  std::span<const Member> members{};  // of Object and Objects
};

constexpr bool required = true;

// glTF 2.0, chapter 5 (properties reference).
constexpr Member asset[] = {{"version", Kind::Text, required}};
constexpr Member scene[] = {{"nodes", Kind::Indices}};
constexpr Member instanceAttributes[] = {
    {"TRANSLATION", Kind::Index}, {"ROTATION", Kind::Index}, {"SCALE", Kind::Index}};
constexpr Member instancing[] = {{"attributes", Kind::Object, required, 0, instanceAttributes}};
constexpr Member visibility[] = {{"visible", Kind::Flag}};
constexpr Member nodeExtensions[] = {
    {"EXT_mesh_gpu_instancing", Kind::Object, false, 0, instancing},
    {"KHR_node_visibility", Kind::Object, false, 0, visibility}};
constexpr Member node[] = {{"mesh", Kind::Index},
                           {"skin", Kind::Index},
                           {"children", Kind::Indices},
                           {"matrix", Kind::Numbers, false, 16},
                           {"translation", Kind::Numbers, false, 3},
                           {"rotation", Kind::Numbers, false, 4},
                           {"scale", Kind::Numbers, false, 3},
                           {"weights", Kind::Numbers},
                           {"extensions", Kind::Object, false, 0, nodeExtensions}};
constexpr Member attributes[] = {{"POSITION", Kind::Index}, {"NORMAL", Kind::Index},
                                 {"TANGENT", Kind::Index},  {"TEXCOORD_0", Kind::Index},
                                 {"COLOR_0", Kind::Index},  {"JOINTS_0", Kind::Index},
                                 {"JOINTS_1", Kind::Index}, {"WEIGHTS_0", Kind::Index}};
constexpr Member draco[] = {{"bufferView", Kind::Index, required},
                            {"attributes", Kind::Object, false, 0, attributes}};
constexpr Member primitiveExtensions[] = {
    {"KHR_draco_mesh_compression", Kind::Object, false, 0, draco}};
constexpr Member primitive[] = {{"attributes", Kind::Object, required, 0, attributes},
                                {"indices", Kind::Index},
                                {"material", Kind::Index},
                                {"mode", Kind::Size},
                                {"targets", Kind::Objects, false, 0, attributes},
                                {"extensions", Kind::Object, false, 0, primitiveExtensions}};
constexpr Member mesh[] = {{"primitives", Kind::Objects, required, 0, primitive},
                           {"weights", Kind::Numbers}};
constexpr Member sparseIndices[] = {{"bufferView", Kind::Index, required},
                                    {"byteOffset", Kind::Index},
                                    {"componentType", Kind::Size, required}};
constexpr Member sparseValues[] = {{"bufferView", Kind::Index, required},
                                   {"byteOffset", Kind::Index}};
constexpr Member sparse[] = {{"count", Kind::Index, required},
                             {"indices", Kind::Object, required, 0, sparseIndices},
                             {"values", Kind::Object, required, 0, sparseValues}};
constexpr Member accessor[] = {{"bufferView", Kind::Index},
                               {"byteOffset", Kind::Size},
                               {"componentType", Kind::Size, required},
                               {"normalized", Kind::Flag},
                               {"count", Kind::Size, required},
                               {"type", Kind::Text, required},
                               {"sparse", Kind::Object, false, 0, sparse}};
constexpr Member meshopt[] = {{"buffer", Kind::Index, required},
                              {"byteOffset", Kind::Size},
                              {"byteLength", Kind::Size, required},
                              {"byteStride", Kind::Size, required},
                              {"count", Kind::Size, required},
                              {"mode", Kind::Text, required},
                              {"filter", Kind::Text}};
constexpr Member viewExtensions[] = {{"EXT_meshopt_compression", Kind::Object, false, 0, meshopt},
                                     {"KHR_meshopt_compression", Kind::Object, false, 0, meshopt}};
constexpr Member bufferView[] = {{"buffer", Kind::Index, required},
                                 {"byteOffset", Kind::Size},
                                 {"byteLength", Kind::Size, required},
                                 {"byteStride", Kind::Size},
                                 {"extensions", Kind::Object, false, 0, viewExtensions}};
constexpr Member fallback[] = {{"fallback", Kind::Flag}};
constexpr Member bufferExtensions[] = {
    {"EXT_meshopt_compression", Kind::Object, false, 0, fallback},
    {"KHR_meshopt_compression", Kind::Object, false, 0, fallback}};
constexpr Member buffer[] = {{"uri", Kind::Text},
                             {"byteLength", Kind::Size, required},
                             {"extensions", Kind::Object, false, 0, bufferExtensions}};
constexpr Member image[] = {
    {"uri", Kind::Text}, {"mimeType", Kind::Text}, {"bufferView", Kind::Index}};
constexpr Member texture[] = {{"source", Kind::Index}};
constexpr Member textureInfo[] = {
    {"index", Kind::Index, required}, {"texCoord", Kind::Index}, {"extensions", Kind::Keys}};
constexpr Member metallicRoughness[] = {{"baseColorFactor", Kind::Numbers, false, 4},
                                        {"baseColorTexture", Kind::Object, false, 0, textureInfo}};
constexpr Member specularGlossiness[] = {{"diffuseFactor", Kind::Numbers, false, 4},
                                         {"diffuseTexture", Kind::Object, false, 0, textureInfo}};
constexpr Member materialExtensions[] = {
    {"KHR_materials_pbrSpecularGlossiness", Kind::Object, false, 0, specularGlossiness}};
constexpr Member material[] = {{"pbrMetallicRoughness", Kind::Object, false, 0, metallicRoughness},
                               {"extensions", Kind::Object, false, 0, materialExtensions}};
constexpr Member skin[] = {{"joints", Kind::Indices, required},
                           {"inverseBindMatrices", Kind::Index}};
constexpr Member root[] = {{"asset", Kind::Object, required, 0, asset},
                           {"extensionsUsed", Kind::Names},
                           {"extensionsRequired", Kind::Names},
                           {"scene", Kind::Index},
                           {"scenes", Kind::Objects, false, 0, scene},
                           {"nodes", Kind::Objects, false, 0, node},
                           {"meshes", Kind::Objects, false, 0, mesh},
                           {"accessors", Kind::Objects, false, 0, accessor},
                           {"bufferViews", Kind::Objects, false, 0, bufferView},
                           {"buffers", Kind::Objects, false, 0, buffer},
                           {"images", Kind::Objects, false, 0, image},
                           {"textures", Kind::Objects, false, 0, texture},
                           {"materials", Kind::Objects, false, 0, material},
                           {"skins", Kind::Objects, false, 0, skin},
                           {"animations", Kind::Some}};

// The location of a value. It is converted to text only for messages.
struct Place {
  const Place* parent = nullptr;
  const char* name = nullptr;  // the name of a member of an object
  std::size_t element = 0;     // the index in a list, if there is no name

  std::string text() const {
    if (!parent) return "";
    const std::string before = parent->text();
    if (!name) return before + '[' + std::to_string(element) + ']';
    return before.empty() ? name : before + '.' + name;
  }
};

[[noreturn]] void fail(const Place& place, const std::string& expected, const json& got) {
  std::string shown = got.type_name();
  if (got.is_number()) shown = got.dump();
  const std::string text = place.text();
  throw FileProblem("the file is not valid glTF: " + (text.empty() ? "its JSON" : text) +
                    " must be " + expected + ", not " + shown + "; export the model again.");
}

void checkWholeNumber(json& value, const Place& place, std::uint64_t max) {
  std::optional<std::uint64_t> number;
  if (value.is_number_unsigned()) number = value.get<std::uint64_t>();
  // Some exporters write 3.0.
  if (value.is_number_float()) {
    const double real = value.get<double>();
    if (real >= 0 && real <= static_cast<double>(max) && real == std::floor(real))
      number = static_cast<std::uint64_t>(real);
  }
  if (!number || *number > max) fail(place, "a whole number from 0 to " + groupDigits(max), value);
  value = *number;
}

void checkIndex(json& value, const Place& place) {
  checkWholeNumber(value, place, (std::uint64_t{1} << 31) - 1);
}

void checkList(const json& value, const Place& place) {
  if (!value.is_array()) fail(place, "a list", value);
}

void checkObject(const json& value, const Place& place) {
  if (!value.is_object()) fail(place, "an object", value);
}

void checkText(const json& value, const Place& place) {
  if (!value.is_string()) fail(place, "a text", value);
}

void checkNumbers(const json& value, const Place& place, std::size_t length) {
  checkList(value, place);
  if (length > 0 && value.size() != length)
    fail(place, "a list of " + std::to_string(length) + " numbers", value);
  for (const json& number : value)
    if (!number.is_number()) fail(place, "a list of numbers", number);
}

template <typename Check>
void checkEach(json& value, const Place& place, Check check) {
  checkList(value, place);
  for (std::size_t i = 0; i < value.size(); ++i) check(value[i], Place{&place, nullptr, i});
}

void removeOthers(json& object, std::span<const Member> members) {
  for (auto it = object.begin(); it != object.end();) {
    const auto hasName = [&](const Member& member) { return it.key() == member.name; };
    it = std::any_of(members.begin(), members.end(), hasName) ? std::next(it) : object.erase(it);
  }
}

// Recurses as deep as the tables nest.
void checkMembers(json& value, const Place& place, std::span<const Member> members);

void checkMember(json& value, const Place& place, const Member& member) {
  switch (member.kind) {
    case Kind::Index:
      return checkIndex(value, place);
    case Kind::Size:
      return checkWholeNumber(value, place, (std::uint64_t{1} << 32) - 1);
    case Kind::Flag:
      if (!value.is_boolean()) fail(place, "true or false", value);
      return;
    case Kind::Text:
      return checkText(value, place);
    case Kind::Numbers:
      return checkNumbers(value, place, member.length);
    case Kind::Indices:
      return checkEach(value, place, checkIndex);
    case Kind::Names:
      return checkEach(value, place, checkText);
    case Kind::Keys:
      checkObject(value, place);
      for (json& element : value) element = json::object();
      return;
    case Kind::Some:
      checkList(value, place);
      value = value.empty() ? json::array() : json::array({json::object()});
      return;
    case Kind::Object:
      return checkMembers(value, place, member.members);
    case Kind::Objects:
      return checkEach(value, place, [&](json& element, const Place& at) {
        checkMembers(element, at, member.members);
      });
  }
}

void checkMembers(json& value, const Place& place, std::span<const Member> members) {
  checkObject(value, place);
  std::size_t known = 0;
  for (const Member& member : members) {
    const Place at{&place, member.name};
    if (const auto found = value.find(member.name); found != value.end()) {
      checkMember(*found, at, member);
      ++known;
    } else if (member.isRequired) {
      throw FileProblem("the file is not valid glTF: " + at.text() +
                        " is missing; export the model again.");
    }
  }
  if (known < value.size()) removeOthers(value, members);
}

}  // namespace

void reduceToSchema(json& tree) { checkMembers(tree, {}, root); }

}  // namespace warpjet
