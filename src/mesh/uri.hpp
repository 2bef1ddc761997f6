// The uris of a model's further files, and where their bytes are: inside the uri, or among the
// caller's files.
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

// The name of a file, as OBJ and MTL files have it, as a relative uri: backslashes become slashes,
// other signs percent escapes, and of a name from the root of somebody's disk only the last part is
// kept. `beside` is the uri of the file that names it.
std::string uriOfName(std::string_view name, std::string_view beside = {});

// The file of that name as written, or as it reads without percent signs ("my file.bin"), or null.
const std::vector<std::uint8_t>* fileOf(const std::string& uri, const Files& files);

}  // namespace warpjet
