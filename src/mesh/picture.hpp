// Detects image formats.
#pragma once

#include <string>

#include "mesh/files.hpp"

namespace warpjet {

// Returns the MIME type of an image, by its first bytes.
std::string sniffType(Bytes bytes);

}  // namespace warpjet
