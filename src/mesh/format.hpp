// Which format a file has, by its bytes.
#pragma once

#include "mesh/files.hpp"

namespace warpjet {

enum class Format { Glb, Gltf, Obj, TextStl, BinaryStl };

// Throws a FileProblem for what is none of them.
Format formatOf(Bytes bytes);

}  // namespace warpjet
