// THE table of built-in functions: names, signatures, and how each is lowered.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "glsl/codes.hpp"
#include "glsl/types.hpp"

namespace warpjet::glsl {

// How a call becomes operations.
enum class Way : std::uint8_t {
  Each,     // the code of the row, component by component
  Grouped,  // the code of the row, on whole vectors
  AbsInt,   // and so on: see lower_builtins.cpp
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
  Refused,
};

// A signature is the result and the parameters, a letter each; a parameter after `>` is out.
//   G float or vec2 to vec4, all of one size; F float; I the same of int, i int; U and u of uint;
//   B bool and bvec, b bool; V vec2 to vec4; W ivec; X uvec; Y bvec; 2 3 4 vec2 …; M any matrix;
//   Q a square matrix; S sampler2D; k ivec2; T the transposed of M; O the matrix
//   of an outer product, whose operands may differ in size
struct BuiltIn {
  std::string_view name, signature;
  Way way;
  Code code = Code::Constant;
};

extern const std::span<const BuiltIn> builtIns;

bool isBuiltIn(std::string_view name);

struct Found {
  int row;
  Type result;
};

std::optional<Found> findBuiltIn(std::string_view name, std::span<const Type> operands);
bool isOut(const BuiltIn& row, std::size_t parameter);
// What the table of versions calls it where its name is in both languages, or an empty word.
std::string_view builtInFeature(const BuiltIn& row);
// Whether it reads an image, which no constant does.
bool readsImage(const BuiltIn& row);
// Whether it takes an offset in texels, as its last parameter.
bool hasOffset(const BuiltIn& row);

}  // namespace warpjet::glsl
