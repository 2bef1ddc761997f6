// STL files, text and binary, as p5's loadModel shows them: each triangle has vertices and a normal
// of its own, and colours are left out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh/files.hpp"
#include "mesh/mesh.hpp"

namespace warpjet {

// Whether the bytes have the size that a binary STL's header says.
bool hasStlSize(Bytes bytes);

// The same, or whether they look like one that is cut off or has more behind it. Many of their
// headers begin with "solid", as texts do.
bool isBinaryStl(Bytes bytes);

// Whether a text begins with the word "solid".
bool isTextStl(std::string_view text);

// Both throw a FileProblem. Normals that are missing or no numbers become those of their triangles,
// and triangles at positions that are no numbers are left out.
Mesh meshOfTextStl(std::string_view text, std::vector<std::string>& warnings);
Mesh meshOfBinaryStl(Bytes bytes, std::vector<std::string>& warnings);

}  // namespace warpjet
