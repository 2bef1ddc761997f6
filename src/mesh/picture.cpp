#include "mesh/picture.hpp"

#include <string_view>

#include "mesh/text/encoding.hpp"

namespace warpjet {

std::string sniffType(Bytes bytes) {
  const std::string_view text = textOf(bytes);
  if (text.starts_with("\x89PNG")) return "image/png";
  if (text.starts_with("\xFF\xD8\xFF")) return "image/jpeg";
  if (text.starts_with("RIFF") && text.substr(0, 12).ends_with("WEBP")) return "image/webp";
  if (text.starts_with("\xABKTX 20")) return "image/ktx2";
  return "application/octet-stream";
}

}  // namespace warpjet
