// Material libraries of OBJ files (.mtl): colours and pictures of their materials, as far as a Mesh
// can carry them.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/files.hpp"

namespace warpjet {

struct ObjMaterial {
  std::optional<std::array<float, 3>> color;  // Kd, as the file has it: sRGB, maybe outside 0 to 1
  std::string picture;                        // the uri of map_Kd, or empty
};

// By name; of two materials of one name the later counts, as in p5.
using ObjMaterials = std::map<std::string, ObjMaterial, std::less<>>;

// Adds the materials of a library. Nothing in it is an error: what makes no sense is passed over.
// `uri` is that of the library.
void readMaterials(std::string_view text, const std::string& uri, ObjMaterials& materials);

}  // namespace warpjet
