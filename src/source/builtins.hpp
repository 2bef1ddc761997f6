// Built-in functions: names, signatures, and how each is lowered. Each language has a table of
// them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "source/codes.hpp"
#include "source/types.hpp"

namespace warpjet::source {

// Determines how a call becomes operations.
enum class Way : std::uint8_t {
  Each,     // the row's code, component by component
  Grouped,  // the row's code, on whole vectors
  AbsInt,   // like all below: see lower_builtins.cpp
  SignInt,
  MinInt,
  MaxInt,
  ClampInt,
  MixBool,
  PackSigned,
  PackUnsigned,
  UnpackSigned,
  UnpackUnsigned,
  PackHalf,
  UnpackHalf,
  Modf,
  Dot,
  Cross,
  MatrixCompMult,
  OuterProduct,
  Transpose,
  Compare,
  Any,
  All,
  Not,
  Texture,
  TextureProj,
  TextureSize,
  TexelFetch,
  IsNan,
  IsInf,
  Same,  // like all below: see lower_bits.cpp
  Saturate,
  Fma,
  Ldexp,
  Frexp,
  ModfPair,
  QuantizeToHalf,
  CountOneBits,
  CountLeadingZeros,
  CountTrailingZeros,
  FirstLeadingBit,
  FirstTrailingBit,
  ReverseBits,
  ExtractBits,
  InsertBits,
  DotBytes,
  PackBytes,
  PackBytesClamped,
  UnpackBytes,
  Unsupported,
};

// `signature` is described in signatures.hpp.
struct BuiltIn {
  std::string_view name, signature;
  Way way;
  Code code = Code::Constant;
};

using BuiltIns = std::span<const BuiltIn>;

bool isBuiltIn(BuiltIns table, std::string_view name);

struct Found {
  int row;
  Type result;
};

std::optional<Found> findBuiltIn(BuiltIns table, std::string_view name,
                                 std::span<const Type> operands);
bool isOut(const BuiltIn& row, std::size_t parameter);
// Returns true if the function reads an image, which no constant expression does.
bool readsImage(const BuiltIn& row);
// Returns true if the function's last parameter is an offset in texels.
bool hasOffset(const BuiltIn& row);

}  // namespace warpjet::source
