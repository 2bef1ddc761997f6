// Finds the bytes of the files that a model refers to by URI: inside of the URI, or among the files
// that the caller passed.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mesh/files.hpp"

namespace warpjet {

struct DataUri {
  std::string mimeType;
  std::vector<std::uint8_t> bytes;
};

bool isDataUri(std::string_view uri);

// Parses `data:<type>;base64,<text>`, or percent encoding without ";base64" (RFC 2397). Returns
// nullopt if the base64 is invalid or missing.
std::optional<DataUri> decodeDataUri(std::string_view uri);

// Converts the name of a file in an OBJ or MTL file to a relative URI: backslashes become slashes,
// other characters percent escapes, and of absolute paths only the last part is kept. `beside` is
// the URI of the file that contains the name.
std::string uriOfName(std::string_view name, std::string_view beside = {});

// Returns the file with that name as written, or percent-decoded ("my file.bin"), or null.
const std::vector<std::uint8_t>* fileOf(const std::string& uri, const Files& files);

}  // namespace warpjet
