// STL files, text and binary, read like p5's loadModel does: each triangle has its own vertices and
// normal, and colors are ignored.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh/files.hpp"
#include "mesh/mesh.hpp"

namespace warpjet {

// Returns true if the bytes have the size in the header of a binary STL.
bool hasStlSize(Bytes bytes);

// Returns true for a binary STL, also if it is truncated or has extra bytes. Many binary STLs begin
// with "solid", like text files.
bool isBinaryStl(Bytes bytes);

// Returns true if a text begins with the word "solid".
bool isTextStl(std::string_view text);

// These functions throw a FileProblem. Missing or invalid normals are replaced by those of their
// triangles, and triangles with invalid positions are omitted.
Mesh meshOfTextStl(std::string_view text, std::vector<std::string>& warnings);
Mesh meshOfBinaryStl(Bytes bytes, std::vector<std::string>& warnings);

}  // namespace warpjet
