// This limit is so low that mutated files reach it within libFuzzer's limits of time and memory.
#include "mesh/files.hpp"

const std::size_t warpjet::maxMeshBytes = std::size_t{1} << 22;
