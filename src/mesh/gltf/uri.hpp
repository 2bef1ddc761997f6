// Where the bytes behind a uri of a glTF are: inside it, or among the caller's files.
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

// `data:<type>;base64,<text>`, or without ";base64" and with percent signs (RFC 2397). Nothing if
// the text is no base64 though it should be, or is missing.
std::optional<DataUri> decodedDataUri(std::string_view uri);

// The file of that name as written, or as it reads without percent signs ("my file.bin"), or null.
const std::vector<std::uint8_t>* fileOf(const std::string& uri, const Files& files);

}  // namespace warpjet
