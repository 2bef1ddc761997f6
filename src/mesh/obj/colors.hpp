// The colors and the image that the materials of an OBJ file assign to its faces.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "graph/none.hpp"
#include "mesh/files.hpp"
#include "mesh/mesh.hpp"
#include "mesh/obj/mtl.hpp"

namespace warpjet {

// The libraries and materials that an OBJ refers to, in the order of the file.
struct ObjNames {
  std::vector<std::string> libraries;  // URIs of .mtl files, without duplicates
  std::vector<std::string> materials;  // without duplicates
};

ObjNames namesInObj(std::string_view text);

// Returns the materials of all libraries in `files`.
ObjMaterials materialsOf(const ObjNames& names, const Files& files);

// Returns the URIs of the .mtl files that an OBJ needs, and of the images that the available .mtl
// files refer to.
std::vector<std::string> filesOfObj(std::string_view text, const Files& files);

class ObjColors {
 public:
  ObjColors(std::string_view text, const Files& files);

  // Sets the material of all following faces.
  void useMaterial(std::string_view name);

  // Returns the index of the current material's color, without duplicates; `none` if it has none.
  // Call it for each face.
  std::uint32_t currentIndex();

  // Returns linear red, green and blue.
  const std::array<float, 3>& colorAt(std::uint32_t index) const { return colors_[index]; }

  // Returns true if all faces have the same color, or none has any.
  bool isUniform() const { return colors_.size() + (hasFacesWithoutColor_ ? 1 : 0) <= 1; }
  bool hasColors() const { return !colors_.empty(); }

  // Returns the color that all faces share, if they do, and the first image; nullopt if there are
  // no colors and no image.
  std::optional<Material> material(const Files& files, std::vector<std::string>& warnings) const;

  void warn(std::vector<std::string>& warnings) const;

 private:
  ObjNames names_;
  ObjMaterials materials_;
  std::string missing_;  // the first library, if all libraries are missing
  ObjMaterial current_;
  std::optional<std::uint32_t> index_;  // of the current material, once a face uses it
  std::vector<std::array<float, 3>> colors_;
  std::map<std::array<float, 3>, std::uint32_t> indices_;  // by color
  std::optional<std::string> image_;
  bool hasFacesWithoutColor_ = false, hasSeveralImages_ = false, isClamped_ = false,
       isUnknown_ = false, usesMaterials_ = false;
};

}  // namespace warpjet
