#include "mesh/obj/colors.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "mesh/messages.hpp"
#include "mesh/obj/srgb.hpp"
#include "mesh/picture.hpp"
#include "mesh/text/encoding.hpp"
#include "mesh/text/lines.hpp"
#include "mesh/uri.hpp"

namespace warpjet {

namespace {

// Adds the libraries that a line names. It may be a list of names, or one name with spaces; since
// these can't be distinguished, adds both.
void addLibraries(TextLine line, std::vector<std::string>& uris, std::set<std::string>& known) {
  const auto add = [&](std::string_view name) {
    if (name.empty()) return;
    std::string uri = uriOfName(name);
    if (known.insert(uri).second) uris.push_back(std::move(uri));
  };
  add(line.rest());
  for (std::string_view name = line.word(); !name.empty(); name = line.word()) add(name);
}

}  // namespace

ObjNames namesInObj(std::string_view text) {
  ObjNames names;
  if (text.find("mtllib") == text.npos) return names;
  std::set<std::string> libraries;
  std::set<std::string, std::less<>> materials;
  for (TextLines lines(text, "obj"); std::optional<TextLine> line = lines.next();) {
    const std::string_view word = line->word();
    if (word == "mtllib") addLibraries(*line, names.libraries, libraries);
    if (word != "usemtl" || materials.contains(line->rest())) continue;
    names.materials.emplace_back(line->rest());
    materials.emplace(line->rest());
  }
  return names;
}

ObjMaterials materialsOf(const ObjNames& names, const Files& files) {
  ObjMaterials materials;
  for (const std::string& uri : names.libraries) {
    const auto* file = fileOf(uri, files);
    if (!file) continue;
    const std::optional<std::string> converted = utf8OfUtf16(*file);
    readMaterials(converted ? *converted : textOf(*file), uri, materials);
  }
  return materials;
}

std::vector<std::string> filesOfObj(std::string_view text, const Files& files) {
  const ObjNames names = namesInObj(text);
  const ObjMaterials materials = materialsOf(names, files);
  std::vector<std::string> uris = names.libraries;
  std::set<std::string> known(uris.begin(), uris.end());
  for (const std::string& name : names.materials) {
    const auto material = materials.find(name);
    if (material == materials.end() || material->second.picture.empty()) continue;
    if (known.insert(material->second.picture).second) uris.push_back(material->second.picture);
  }
  return uris;
}

ObjColors::ObjColors(std::string_view text, const Files& files)
    : names_(namesInObj(text)), materials_(materialsOf(names_, files)) {
  const auto isAvailable = [&](const std::string& uri) { return fileOf(uri, files) != nullptr; };
  if (!names_.libraries.empty() &&
      std::none_of(names_.libraries.begin(), names_.libraries.end(), isAvailable))
    missing_ = names_.libraries.front();
}

void ObjColors::useMaterial(std::string_view name) {
  usesMaterials_ = true;
  const auto material = materials_.find(name);
  isUnknown_ |= material == materials_.end() && !name.empty();
  current_ = material == materials_.end() ? ObjMaterial{} : material->second;
  index_ = std::nullopt;
}

std::uint32_t ObjColors::currentIndex() {
  if (index_) return *index_;
  if (!image_) image_ = current_.picture;
  hasSeveralImages_ |= *image_ != current_.picture;
  if (image_->empty()) image_ = current_.picture;
  hasFacesWithoutColor_ |= !current_.color;
  index_ = none;
  if (!current_.color) return none;
  std::array<float, 3> color = *current_.color;
  for (float& channel : color) {
    isClamped_ |= !(channel >= 0 && channel <= 1);
    channel = linearOf(std::clamp(channel, 0.0f, 1.0f));
  }
  const auto [entry, isNew] = indices_.emplace(color, static_cast<std::uint32_t>(colors_.size()));
  if (isNew) colors_.push_back(color);
  return *(index_ = entry->second);
}

std::optional<Material> ObjColors::material(const Files& files,
                                            std::vector<std::string>& warnings) const {
  Material material;
  const bool hasImage = image_ && !image_->empty();
  if (!hasColors() && !hasImage) return std::nullopt;
  if (hasSeveralImages_)
    warnings.push_back(
        "The parts have different base-colour textures; only the first one is used.");
  if (hasColors() && isUniform()) std::copy_n(colors_[0].begin(), 3, material.baseColor.begin());
  if (!hasImage) return material;
  const auto* file = fileOf(*image_, files);
  if (file && !file->empty())
    material.baseColorTexture = Image{*file, sniffType(*file)};
  else
    warnings.push_back("The texture " + quoteText(*image_) +
                       " of the .mtl is missing or broken; it is ignored.");
  return material;
}

void ObjColors::warn(std::vector<std::string>& warnings) const {
  if (!usesMaterials_) return;
  const std::string ignored = "The materials of the .obj are ignored, since ";
  if (names_.libraries.empty())
    warnings.push_back(ignored + "it names no .mtl file (mtllib).");
  else if (!missing_.empty())
    warnings.push_back(ignored + quoteText(missing_) + " is missing.");
  else if (isUnknown_)
    warnings.push_back(
        "A material of the .obj is in none of its .mtl files; the faces that use it have no "
        "colour.");
  if (isClamped_) warnings.push_back("Colours of the .mtl outside 0 to 1 are clamped.");
}

}  // namespace warpjet
