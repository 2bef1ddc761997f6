#include "mesh/files.hpp"

// Alone in its file: the linker takes it only where a program defines no other.
const std::size_t warpjet::mostMeshBytes = std::size_t{1} << 30;
