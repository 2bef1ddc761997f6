#include "eval/wasm_bytes.hpp"

namespace warpjet {

void WasmBytes::number(std::uint32_t x) {
  for (; x >= 0x80; x >>= 7) byte(static_cast<std::uint8_t>(x | 0x80));
  byte(static_cast<std::uint8_t>(x));
}

void WasmBytes::signedNumber(std::int32_t x) {
  // The last group of seven bits contains the sign.
  for (; x < -64 || x > 63; x >>= 7) byte(static_cast<std::uint8_t>(x | 0x80));
  byte(static_cast<std::uint8_t>(x & 0x7f));
}

void WasmBytes::text(std::string_view characters, std::string_view more) {
  number(static_cast<std::uint32_t>(characters.size() + more.size()));
  for (const std::string_view part : {characters, more}) {
    for (const char x : part) byte(static_cast<std::uint8_t>(x));
  }
}

void WasmBytes::append(const WasmBytes& other) {
  for (const std::uint8_t x : other.bytes_) byte(x);
}

void WasmBytes::appendCounted(const WasmBytes& other) {
  number(static_cast<std::uint32_t>(other.size()));
  append(other);
}

void WasmBytes::section(std::uint8_t kind, const WasmBytes& contents) {
  byte(kind);
  appendCounted(contents);
}

}  // namespace warpjet
