#include "mesh/gltf/look.hpp"

#include <algorithm>
#include <utility>

#include "mesh/messages.hpp"
#include "mesh/picture.hpp"
#include "mesh/uri.hpp"

namespace warpjet {

namespace {

const tinygltf::Material& materialAt(const Gltf& gltf, int material) {
  const auto& materials = gltf.model.materials;
  return materials[checkIndex("material", material, materials.size())];
}

// Returns the base color and texture of a material, from either of its two surface models.
BaseColor baseColorOf(const Gltf& gltf, int material) {
  const tinygltf::Material& info = materialAt(gltf, material);
  const auto glossiness = gltf.extensions.glossiness.find(material);
  if (glossiness != gltf.extensions.glossiness.end()) return glossiness->second;
  const std::vector<double>& color = info.pbrMetallicRoughness.baseColorFactor;
  const tinygltf::TextureInfo& texture = info.pbrMetallicRoughness.baseColorTexture;
  BaseColor baseColor{
      {}, texture.index, texture.texCoord, texture.extensions.contains("KHR_texture_transform")};
  std::copy_n(color.begin(), 4, baseColor.color.begin());
  return baseColor;
}

// Returns the image of a texture, or noPlace if only an extension defines it.
int imageOfTexture(const Gltf& gltf, int texture) {
  if (texture == noPlace) return noPlace;
  const auto& textures = gltf.model.textures;
  return textures[checkIndex("texture", texture, textures.size())].source;
}

std::optional<Image> bytesOf(const Gltf& gltf, const tinygltf::Image& image, const Files& files) {
  if (image.bufferView != noPlace) {
    const Bytes bytes = bytesOfView(gltf, image.bufferView);
    return Image{{bytes.begin(), bytes.end()}, image.mimeType};
  }
  if (isDataUri(image.uri)) {
    auto data = decodeDataUri(image.uri);
    if (!data) return std::nullopt;
    return Image{std::move(data->bytes), image.mimeType.empty() ? data->mimeType : image.mimeType};
  }
  if (const auto* file = fileOf(image.uri, files)) return Image{*file, image.mimeType};
  return std::nullopt;
}

}  // namespace

Look lookOf(const Gltf& gltf, int material) {
  Look look;
  if (material == noPlace) return look;
  const BaseColor baseColor = baseColorOf(gltf, material);
  for (std::size_t i = 0; i < 4; ++i) look.baseColor[i] = std::clamp(baseColor.color[i], 0.0, 1.0);
  look.image = imageOfTexture(gltf, baseColor.texture);
  return look;
}

void warnOfLook(Gltf& gltf, int material) {
  if (material == noPlace) return;
  const BaseColor baseColor = baseColorOf(gltf, material);
  if (baseColor.color != lookOf(gltf, material).baseColor)
    gltf.warn("Base colours outside 0 to 1 are clamped.");
  if (baseColor.texture == noPlace) return;
  if (imageOfTexture(gltf, baseColor.texture) == noPlace)
    gltf.warn("A base-colour texture has no PNG or JPEG image; it is ignored.");
  if (baseColor.isTransformed)
    gltf.warn("A texture is moved or scaled by KHR_texture_transform, which is ignored.");
  if (baseColor.texCoord != 0)
    gltf.warn("A texture uses other uvs than TEXCOORD_0, the only ones that are read.");
}

std::optional<Image> readImage(Gltf& gltf, int number, const Files& files) {
  if (number == noPlace) return std::nullopt;
  const auto& images = gltf.model.images;
  const tinygltf::Image& image = images[checkIndex("image", number, images.size())];
  std::optional<Image> found = bytesOf(gltf, image, files);
  if (!found || found->bytes.empty()) {
    gltf.warn("The base-colour texture (image " + std::to_string(number) + ", " +
              quoteText(image.uri) + ") is missing or broken; it is ignored.");
    return std::nullopt;
  }
  if (found->mimeType.empty()) found->mimeType = sniffType(found->bytes);
  return found;
}

std::vector<std::string> imageUris(const Gltf& gltf) {
  std::vector<std::string> uris;
  const auto& images = gltf.model.images;
  for (std::size_t i = 0; i < gltf.model.materials.size(); ++i) {
    const int image = lookOf(gltf, static_cast<int>(i)).image;
    if (image != noPlace) uris.push_back(images[checkIndex("image", image, images.size())].uri);
  }
  return uris;
}

}  // namespace warpjet
