// Wavefront OBJ, as text (B1, "Object Files", in the Advanced Visualizer manual).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh/files.hpp"
#include "mesh/mesh.hpp"

namespace warpjet {

// Reads v, vt, vn and f; negative indices count from the end, polygons become triangles. A vertex
// is a combination of position, uv and normal that faces use. Uvs are turned over, v to 1 - v,
// since OBJ's go up and a Mesh's go down, as glTF's. Colours behind positions (v x y z r g b) are
// sRGB, as Blender writes them, and become linear; where all are whole numbers and one is above 1,
// they go to 255. Faces may name uvs and normals that are not there, and elements whose numbers are
// NaN: such a normal is computed, and a face at such a position left out. Colours (Kd) and the
// first picture (map_Kd) come from those .mtl files that are among `files`. Throws a FileProblem
// that names the line.
Mesh meshOfObj(std::string_view text, const Files& files, std::vector<std::string>& warnings);

}  // namespace warpjet
