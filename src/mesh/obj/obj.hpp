// Reads the text format Wavefront OBJ (B1, "Object Files", in the Advanced Visualizer manual).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh/files.hpp"
#include "mesh/mesh.hpp"

namespace warpjet {

// Reads v, vt, vn and f; negative indices count from the end, polygons become triangles. A vertex
// is a combination of position, uv and normal that faces use. v becomes 1 - v, since v points up in
// OBJ files and down in a Mesh, as in glTF. Colors after positions (v x y z r g b) are sRGB, as
// Blender writes them, and become linear; if all are integers and one is above 1, their max is 255.
// Faces may refer to uvs and normals that don't exist, and to elements that are NaN. Such a normal
// is computed, and a face with such a position is omitted. Colors (Kd) and the first image (map_Kd)
// come from those .mtl files that are in `files`. Throws a FileProblem that names the line.
Mesh meshOfObj(std::string_view text, const Files& files, std::vector<std::string>& warnings);

}  // namespace warpjet
