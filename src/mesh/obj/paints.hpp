// What the materials of an OBJ file give its faces: colours and one picture.
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

// The libraries and materials that an OBJ names, in the order of the file.
struct ObjNames {
  std::vector<std::string> libraries;  // uris of .mtl files, each once
  std::vector<std::string> materials;  // each once
};

ObjNames namesInObj(std::string_view text);

// The materials of all libraries that are among the files.
ObjMaterials materialsOf(const ObjNames& names, const Files& files);

// The uris of the files that it needs, as far as those that are there name them.
std::vector<std::string> filesOfObj(std::string_view text, const Files& files);

class Paints {
 public:
  Paints(std::string_view text, const Files& files);

  // From the next face on.
  void use(std::string_view material);

  // The place of the current material's colour, each colour once; `none` if it has none. To be
  // called for each face.
  std::uint32_t current();

  // Linear red, green and blue.
  const std::array<float, 3>& colorAt(std::uint32_t paint) const { return colors_[paint]; }

  // Whether all faces have the same colour, or none has any.
  bool isEqual() const { return colors_.size() + (hasUnpainted_ ? 1 : 0) <= 1; }
  bool hasColors() const { return !colors_.empty(); }

  // Colour and picture that all faces have; nothing if they have neither.
  std::optional<Material> material(const Files& files, std::vector<std::string>& warnings) const;

  void warn(std::vector<std::string>& warnings) const;

 private:
  ObjNames names_;
  ObjMaterials materials_;
  std::string missing_;  // the first library, if there is none of them
  ObjMaterial current_;
  std::optional<std::uint32_t> paint_;  // of the current material, once a face has it
  std::vector<std::array<float, 3>> colors_;
  std::map<std::array<float, 3>, std::uint32_t> places_;  // of the colours
  std::optional<std::string> picture_;
  bool hasUnpainted_ = false, hasPictures_ = false, isClamped_ = false, isUnknown_ = false,
       usesMaterials_ = false;
};

}  // namespace warpjet
