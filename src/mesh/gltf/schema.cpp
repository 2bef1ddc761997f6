#include "mesh/gltf/schema.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "mesh/sentences.hpp"

namespace warpjet {

namespace {

using nlohmann::json;

enum class Kind {
  Index,    // of an element of one of the lists
  Size,     // a count, an offset or an enumeration
  Flag,     // true or false
  Text,     //
  Numbers,  // so many
  Indices,  // any number
  Names,    // any number of texts
  Keys,     // an object of which only the keys matter
  Some,     // whether a list has elements
  Object,   //
  Objects   // a list of them
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
constexpr Member node[] = {{"mesh", Kind::Index},
                           {"skin", Kind::Index},
                           {"children", Kind::Indices},
                           {"matrix", Kind::Numbers, false, 16},
                           {"translation", Kind::Numbers, false, 3},
                           {"rotation", Kind::Numbers, false, 4},
                           {"scale", Kind::Numbers, false, 3}};
constexpr Member attributes[] = {{"POSITION", Kind::Index}, {"NORMAL", Kind::Index},
                                 {"TANGENT", Kind::Index},  {"TEXCOORD_0", Kind::Index},
                                 {"COLOR_0", Kind::Index},  {"JOINTS_0", Kind::Index},
                                 {"JOINTS_1", Kind::Index}, {"WEIGHTS_0", Kind::Index}};
constexpr Member primitive[] = {{"attributes", Kind::Object, required, 0, attributes},
                                {"indices", Kind::Index},
                                {"material", Kind::Index},
                                {"mode", Kind::Size},
                                {"targets", Kind::Some},
                                {"extensions", Kind::Keys}};
constexpr Member mesh[] = {{"primitives", Kind::Objects, required, 0, primitive}};
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
constexpr Member bufferView[] = {{"buffer", Kind::Index, required},
                                 {"byteOffset", Kind::Size},
                                 {"byteLength", Kind::Size, required},
                                 {"byteStride", Kind::Size}};
constexpr Member buffer[] = {{"uri", Kind::Text}, {"byteLength", Kind::Size, required}};
constexpr Member image[] = {
    {"uri", Kind::Text}, {"mimeType", Kind::Text}, {"bufferView", Kind::Index}};
constexpr Member texture[] = {{"source", Kind::Index}};
constexpr Member textureInfo[] = {
    {"index", Kind::Index, required}, {"texCoord", Kind::Index}, {"extensions", Kind::Keys}};
constexpr Member metallicRoughness[] = {{"baseColorFactor", Kind::Numbers, false, 4},
                                        {"baseColorTexture", Kind::Object, false, 0, textureInfo}};
constexpr Member material[] = {{"pbrMetallicRoughness", Kind::Object, false, 0, metallicRoughness}};
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

[[noreturn]] void fail(const std::string& place, const std::string& expected, const json& came) {
  std::string shown = came.type_name();
  if (came.is_number()) shown = came.dump();
  throw FileProblem("the file is not right glTF: " + place + " must be " + expected + ", not " +
                    shown + "; export the model again.");
}

json wholeNumber(const json& value, const std::string& place, std::uint64_t most) {
  std::optional<std::uint64_t> number;
  if (value.is_number_unsigned()) number = value.get<std::uint64_t>();
  // Some exporters write 3.0.
  if (value.is_number_float()) {
    const double real = value.get<double>();
    if (real >= 0 && real <= static_cast<double>(most) && real == std::floor(real))
      number = static_cast<std::uint64_t>(real);
  }
  if (!number || *number > most) fail(place, "a whole number from 0 to " + grouped(most), value);
  return *number;
}

json index(const json& value, const std::string& place) {
  return wholeNumber(value, place, (std::uint64_t{1} << 31) - 1);
}

const json& list(const json& value, const std::string& place) {
  if (!value.is_array()) fail(place, "a list", value);
  return value;
}

const json& text(const json& value, const std::string& place) {
  if (!value.is_string()) fail(place, "a text", value);
  return value;
}

json numbers(const json& value, const std::string& place, std::size_t length) {
  if (list(value, place).size() != length)
    fail(place, "a list of " + std::to_string(length) + " numbers", value);
  for (const json& number : value)
    if (!number.is_number()) fail(place, "a list of numbers", number);
  return value;
}

template <typename Check>
json eachOf(const json& value, const std::string& place, Check check) {
  json checked = json::array();
  for (const json& element : list(value, place))
    checked.push_back(check(element, place + '[' + std::to_string(checked.size()) + ']'));
  return checked;
}

json keys(const json& value, const std::string& place) {
  if (!value.is_object()) fail(place, "an object", value);
  json checked = json::object();
  for (const auto& item : value.items()) checked[item.key()] = json::object();
  return checked;
}

// As deep as the tables nest.
json object(const json& value, const std::string& place, std::span<const Member> members);

json checkedMember(const json& value, const std::string& place, const Member& member) {
  switch (member.kind) {
    case Kind::Index:
      return index(value, place);
    case Kind::Size:
      return wholeNumber(value, place, (std::uint64_t{1} << 32) - 1);
    case Kind::Flag:
      if (!value.is_boolean()) fail(place, "true or false", value);
      return value;
    case Kind::Text:
      return text(value, place);
    case Kind::Numbers:
      return numbers(value, place, member.length);
    case Kind::Indices:
      return eachOf(value, place, index);
    case Kind::Names:
      return eachOf(value, place, text);
    case Kind::Keys:
      return keys(value, place);
    case Kind::Some:
      return list(value, place).empty() ? json::array() : json::array({json::object()});
    case Kind::Object:
      return object(value, place, member.members);
    case Kind::Objects:
      return eachOf(value, place, [&](const json& element, const std::string& at) {
        return object(element, at, member.members);
      });
  }
  return {};
}

json object(const json& value, const std::string& place, std::span<const Member> members) {
  if (!value.is_object()) fail(place.empty() ? "its JSON" : place, "an object", value);
  json checked = json::object();
  for (const Member& member : members) {
    const std::string at = place.empty() ? member.name : place + '.' + member.name;
    if (const auto found = value.find(member.name); found != value.end())
      checked[member.name] = checkedMember(*found, at, member);
    else if (member.isRequired)
      throw FileProblem("the file is not right glTF: " + at +
                        " is missing; export the model again.");
  }
  return checked;
}

}  // namespace

json checkedGltf(const json& tree) { return object(tree, "", root); }

}  // namespace warpjet
