#include "mesh/files.hpp"

// This definition is in a separate file: the linker uses it only if a program doesn't define the
// limit.
const std::size_t warpjet::maxMeshBytes = std::size_t{1} << 30;
