// Detects the format of a file from its bytes.
#pragma once

#include "mesh/files.hpp"

namespace warpjet {

enum class Format { Glb, Gltf, Obj, TextStl, BinaryStl };

// Throws a FileProblem for unknown formats.
Format formatOf(Bytes bytes);

}  // namespace warpjet
