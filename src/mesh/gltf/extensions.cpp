#include "mesh/gltf/extensions.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "mesh/messages.hpp"

namespace warpjet {

namespace {

using nlohmann::json;

constexpr std::array<const char*, 2> meshoptExtensions{"EXT_meshopt_compression",
                                                       "KHR_meshopt_compression"};

bool contains(std::string_view text, std::string_view part) { return text.find(part) != text.npos; }

// Returns true for extensions that are read, and for those that move no vertex. Texture extensions
// disable only textures that have no other source.
bool isAccepted(std::string_view extension) {
  constexpr std::array<std::string_view, 9> names{
      "KHR_mesh_quantization",   "EXT_mesh_gpu_instancing", "KHR_node_visibility",
      "EXT_meshopt_compression", "KHR_meshopt_compression", dracoExtension,
      "KHR_animation_pointer",   "KHR_xmp_json_ld",         "KHR_xmp"};
  constexpr std::array<std::string_view, 3> surfacePrefixes{"_materials_", "_texture_", "_lights_"};
  const auto isPart = [&](std::string_view part) { return contains(extension, part); };
  return std::any_of(surfacePrefixes.begin(), surfacePrefixes.end(), isPart) ||
         std::find(names.begin(), names.end(), extension) != names.end();
}

// Removes and returns the extensions of an element.
json takeExtensionsOf(json& element) {
  const auto found = element.find("extensions");
  if (found == element.end()) return json::object();
  json extensions = std::move(*found);
  element.erase(found);
  return extensions;
}

// Calls `function` with each element of a list and its index.
template <typename Function>
void forEach(json& tree, const char* list, Function function) {
  const auto found = tree.find(list);
  if (found == tree.end()) return;
  for (std::size_t i = 0; i < found->size(); ++i) function((*found)[i], static_cast<int>(i));
}

Instancing instancingOf(const json& extension) {
  const json& attributes = extension["attributes"];
  return {attributes.value("TRANSLATION", -1), attributes.value("ROTATION", -1),
          attributes.value("SCALE", -1)};
}

BaseColor glossinessOf(const json& extension) {
  BaseColor look;
  if (const auto color = extension.find("diffuseFactor"); color != extension.end())
    look.color = color->get<std::array<double, 4>>();
  if (const auto texture = extension.find("diffuseTexture"); texture != extension.end()) {
    look.texture = (*texture)["index"];
    look.texCoord = texture->value("texCoord", 0);
    const auto extensions = texture->find("extensions");
    look.isTransformed =
        extensions != texture->end() && extensions->contains("KHR_texture_transform");
  }
  return look;
}

MeshoptView meshoptViewOf(const char* name, const json& extension) {
  return {name,
          extension["buffer"],
          extension.value("byteOffset", std::uint64_t{0}),
          extension["byteLength"],
          extension["byteStride"],
          extension["count"],
          extension["mode"],
          extension.value("filter", std::string("NONE"))};
}

DracoPrimitive dracoPrimitiveOf(const json& extension) {
  DracoPrimitive primitive{extension["bufferView"], {}};
  if (const auto attributes = extension.find("attributes"); attributes != extension.end())
    primitive.attributes = attributes->get<std::map<std::string, int>>();
  return primitive;
}

}  // namespace

std::string adviceFor(std::string_view extension) {
  if (extension == dracoExtension) return "without Draco compression";
  if (extension.ends_with("_meshopt_compression")) return "without meshopt compression";
  return "without it";
}

void rejectExtensions(const json& tree) {
  const auto required = tree.find("extensionsRequired");
  if (required == tree.end()) return;
  for (const json& entry : *required) {
    const std::string name = entry;
    if (!isAccepted(name))
      throw FileProblem("the model requires the extension " + quoteText(name) +
                        ", which is not supported; export the model " + adviceFor(name) + '.');
  }
}

Extensions takeExtensions(json& tree) {
  Extensions found;
  forEach(tree, "nodes", [&](json& node, int index) {
    const json extensions = takeExtensionsOf(node);
    if (const auto it = extensions.find("EXT_mesh_gpu_instancing"); it != extensions.end())
      found.instancing[index] = instancingOf(*it);
    if (const auto it = extensions.find("KHR_node_visibility"); it != extensions.end())
      if (!it->value("visible", true)) found.hiddenNodes.insert(index);
  });
  forEach(tree, "materials", [&](json& material, int index) {
    const json extensions = takeExtensionsOf(material);
    if (const auto it = extensions.find("KHR_materials_pbrSpecularGlossiness");
        it != extensions.end())
      found.glossiness[index] = glossinessOf(*it);
  });
  forEach(tree, "bufferViews", [&](json& view, int index) {
    const json extensions = takeExtensionsOf(view);
    for (const char* name : meshoptExtensions)
      if (const auto it = extensions.find(name); it != extensions.end())
        found.meshoptViews[index] = meshoptViewOf(name, *it);
  });
  forEach(tree, "meshes", [&](json& mesh, int meshIndex) {
    forEach(mesh, "primitives", [&](json& primitive, int index) {
      const json extensions = takeExtensionsOf(primitive);
      if (const auto it = extensions.find(dracoExtension); it != extensions.end())
        found.draco[{meshIndex, index}] = dracoPrimitiveOf(*it);
    });
  });
  return found;
}

}  // namespace warpjet
