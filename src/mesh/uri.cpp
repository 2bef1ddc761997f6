#include "mesh/uri.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace warpjet {

namespace {

constexpr std::uint8_t noDigit = 0xFF;

constexpr std::array<std::uint8_t, 256> base64Digits() {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<std::uint8_t, 256> values{};
  values.fill(noDigit);
  for (std::size_t i = 0; i < digits.size(); ++i)
    values[static_cast<unsigned char>(digits[i])] = static_cast<std::uint8_t>(i);
  values['-'] = 62;  // the URL-safe alphabet, RFC 4648, section 5
  values['_'] = 63;
  return values;
}

constexpr auto base64Values = base64Digits();

std::optional<std::vector<std::uint8_t>> decodeBase64(std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::uint8_t value = base64Values[static_cast<unsigned char>(c)];
    if (value == noDigit) return std::nullopt;
    bits = bits << 6 | value;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> count));
  }
  return bytes;
}

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// Returns true if a text starts with `start`, which is lowercase; case-insensitive.
bool startsLike(std::string_view text, std::string_view start) {
  return std::equal(start.begin(), start.end(), text.begin(),
                    text.begin() + std::min(text.size(), start.size()), [](char lower, char c) {
                      return c == lower || (c >= 'A' && c <= 'Z' && c - 'A' + 'a' == lower);
                    });
}

std::string decodePercents(std::string_view uri) {
  std::string plain;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool isEscape = uri[i] == '%' && i + 2 < uri.size() && hexDigit(uri[i + 1]) >= 0 &&
                          hexDigit(uri[i + 2]) >= 0;
    plain +=
        isEscape ? static_cast<char>(hexDigit(uri[i + 1]) * 16 + hexDigit(uri[i + 2])) : uri[i];
    if (isEscape) i += 2;
  }
  return plain;
}

}  // namespace

bool isDataUri(std::string_view uri) { return startsLike(uri, "data:"); }

std::optional<DataUri> decodeDataUri(std::string_view uri) {
  uri.remove_prefix(std::string_view("data:").size());
  const std::size_t comma = uri.find(',');
  if (comma == uri.npos) return std::nullopt;
  const std::string_view type = uri.substr(0, comma), text = uri.substr(comma + 1);
  const std::string mimeType(type.substr(0, type.find(';')));
  const std::size_t last = type.rfind(';');
  if (last == type.npos || !startsLike(type.substr(last), ";base64")) {
    const std::string plain = decodePercents(text);
    return DataUri{mimeType, {plain.begin(), plain.end()}};
  }
  auto bytes = decodeBase64(text);
  if (!bytes) return std::nullopt;
  return DataUri{mimeType, std::move(*bytes)};
}

std::string uriOfName(std::string_view name, std::string_view beside) {
  const bool isAbsolute =
      name.starts_with('/') || name.starts_with('\\') || (name.size() > 1 && name[1] == ':');
  if (isAbsolute) name.remove_prefix(name.find_last_of("/\\:") + 1);
  std::string uri(beside.substr(0, beside.rfind('/') + 1));
  for (const char c : name) {
    const bool isPlain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                         (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '_' || c == '~' ||
                         c == '/';
    constexpr char digits[] = "0123456789ABCDEF";
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\\')
      uri += '/';
    else if (isPlain)
      uri += c;
    else
      uri += {'%', digits[byte >> 4], digits[byte & 15]};
  }
  return uri;
}

const std::vector<std::uint8_t>* fileOf(const std::string& uri, const Files& files) {
  auto found = files.find(uri);
  if (found == files.end()) found = files.find(decodePercents(uri));
  return found == files.end() ? nullptr : &found->second;
}

}  // namespace warpjet
