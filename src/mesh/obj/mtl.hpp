// Material libraries of OBJ files (.mtl): the colors and images of their materials, as far as a
// Mesh supports them.
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
  std::optional<std::array<float, 3>> color;  // Kd as in the file: sRGB, possibly outside 0 to 1
  std::string picture;                        // the URI of map_Kd, or empty
};

// Materials by name; if several have the same name, the last one wins, as in p5.
using ObjMaterials = std::map<std::string, ObjMaterial, std::less<>>;

// Adds the materials of a library. Nothing in it is an error: invalid lines are ignored. `uri` is
// that of the library.
void readMaterials(std::string_view text, const std::string& uri, ObjMaterials& materials);

}  // namespace warpjet
