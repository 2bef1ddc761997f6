#include "mesh/text/encoding.hpp"

#include <cstdint>

namespace warpjet {

namespace {

constexpr std::uint32_t replacement = 0xFFFD;

// Returns the position of the low byte in each 16-bit unit: 0 in little endian, 1 in big endian.
// nullopt if the bytes aren't UTF-16.
std::optional<std::size_t> lowByteOf(Bytes bytes) {
  if (bytes.size() < 2) return std::nullopt;
  if (bytes[0] == 0xFF && bytes[1] == 0xFE) return 0;
  if (bytes[0] == 0xFE && bytes[1] == 0xFF) return 1;
  if (bytes.size() < 4) return std::nullopt;
  const auto isAscii = [](std::uint8_t byte) { return byte >= 9 && byte < 127; };
  for (const std::size_t low : {std::size_t{0}, std::size_t{1}})
    if (isAscii(bytes[low]) && isAscii(bytes[2 + low]) && bytes[1 - low] == 0 &&
        bytes[3 - low] == 0)
      return low;
  return std::nullopt;
}

void appendUtf8(std::string& text, std::uint32_t code) {
  const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80) return put(code);
  if (code < 0x800) {
    put(0xC0 | code >> 6);
  } else {
    if (code < 0x10000) {
      put(0xE0 | code >> 12);
    } else {
      put(0xF0 | code >> 18);
      put(0x80 | (code >> 12 & 0x3F));
    }
    put(0x80 | (code >> 6 & 0x3F));
  }
  put(0x80 | (code & 0x3F));
}

bool isHigh(std::uint32_t unit) { return unit >= 0xD800 && unit < 0xDC00; }
bool isLow(std::uint32_t unit) { return unit >= 0xDC00 && unit < 0xE000; }

}  // namespace

std::string_view textOf(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::optional<std::string> utf8OfUtf16(Bytes bytes) {
  const std::optional<std::size_t> low = lowByteOf(bytes);
  if (!low) return std::nullopt;
  const std::size_t units = bytes.size() / 2;
  const auto unitAt = [&](std::size_t i) {
    return bytes[2 * i + *low] | static_cast<std::uint32_t>(bytes[2 * i + 1 - *low]) << 8;
  };
  std::string text;
  text.reserve(units);
  for (std::size_t i = 0; i < units; ++i) {
    std::uint32_t code = unitAt(i);
    if (isHigh(code) && i + 1 < units && isLow(unitAt(i + 1)))
      code = 0x10000 + ((code - 0xD800) << 10) + (unitAt(++i) - 0xDC00);
    else if (isHigh(code) || isLow(code))
      code = replacement;
    appendUtf8(text, code);
  }
  return text;
}

}  // namespace warpjet
