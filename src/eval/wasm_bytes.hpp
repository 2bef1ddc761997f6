// The bytes of a WebAssembly module: numbers in LEB128, sections, and the instructions that we use
// (WebAssembly Core Specification 2.0, chapter 5).
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace warpjet {

class WasmBytes {
 public:
  void byte(std::uint8_t x) { bytes_.push_back(x); }
  void number(std::uint32_t x);
  void signedNumber(std::int32_t x);
  void text(std::string_view characters, std::string_view more = {});
  void append(const WasmBytes& other);
  // Appends the size of the bytes and then the bytes, as required for functions and sections.
  void appendCounted(const WasmBytes& other);
  void section(std::uint8_t kind, const WasmBytes& contents);

  const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  std::size_t size() const { return bytes_.size(); }

 private:
  std::vector<std::uint8_t> bytes_;
};

namespace wasm {

inline constexpr std::uint8_t i32 = 0x7f, v128 = 0x7b, functionType = 0x60, noResult = 0x40;
enum Section : std::uint8_t { Types = 1, Imports, Functions, Exports = 7, Code = 10 };
// The kinds of imports and exports.
enum Outside : std::uint8_t { OfFunction = 0, OfMemory = 2 };

enum Plain : std::uint8_t {
  Loop = 0x03,
  If = 0x04,
  End = 0x0b,
  BranchIf = 0x0d,
  Call = 0x10,
  LocalGet = 0x20,
  LocalSet = 0x21,
  LocalTee = 0x22,
  Number = 0x41,
  Less = 0x49,  // unsigned
  Add = 0x6a,
  Multiply = 0x6c,
};

// Instructions on four 32-bit lanes, which follow the prefix 0xfd.
enum Simd : std::uint32_t {
  Load = 0x00,
  LoadSplat = 0x09,
  Store = 0x0b,
  Equal = 0x41,
  NotEqual,
  LessThan,
  GreaterThan,
  LessOrEqual,
  GreaterOrEqual,
  Not = 0x4d,
  And = 0x4e,
  Or = 0x50,
  Xor,
  Select,
  AnyTrue,
  LoadLane = 0x56,
  StoreLane = 0x5a,
  LoadFirst = 0x5c,
  Ceil = 0x67,
  Floor,
  Truncate,
  Nearest,
  ShiftLeft = 0xab,
  ShiftRight,  // arithmetic shift
  AddInts = 0xae,
  SubtractInts = 0xb1,
  Absolute = 0xe0,
  Negate,
  SquareRoot = 0xe3,
  Sum,
  Difference,
  Product,
  Quotient,
  Min = 0xea,  // the second operand if it is below the first, like our min
  Max,
};

}  // namespace wasm

}  // namespace warpjet
