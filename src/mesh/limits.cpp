#include "mesh/files.hpp"

// In a file of its own: the linker uses it only if a program doesn't define the limit.
const std::size_t warpjet::maxMeshBytes = std::size_t{1} << 30;
