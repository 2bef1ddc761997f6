#include "glsl/builtins.hpp"

namespace warpjet::glsl {

namespace {

using enum Way;

// GLSL ES 3.00, section 8, and what only 1.00 has.
constexpr std::array table{
    // angles
    BuiltIn{"radians", "GG", Each, Code::Radians},
    BuiltIn{"degrees", "GG", Each, Code::Degrees},
    BuiltIn{"sin", "GG", Each, Code::Sin},
    BuiltIn{"cos", "GG", Each, Code::Cos},
    BuiltIn{"tan", "GG", Each, Code::Tan},
    BuiltIn{"asin", "GG", Each, Code::Asin},
    BuiltIn{"acos", "GG", Each, Code::Acos},
    BuiltIn{"atan", "GGG", Each, Code::Atan},
    BuiltIn{"atan", "GG", Each, Code::Atan},
    BuiltIn{"sinh", "GG", Each, Code::Sinh},
    BuiltIn{"cosh", "GG", Each, Code::Cosh},
    BuiltIn{"tanh", "GG", Each, Code::Tanh},
    BuiltIn{"asinh", "GG", Each, Code::Asinh},
    BuiltIn{"acosh", "GG", Each, Code::Acosh},
    BuiltIn{"atanh", "GG", Each, Code::Atanh},

    // powers
    BuiltIn{"pow", "GGG", Each, Code::Pow},
    BuiltIn{"exp", "GG", Each, Code::Exp},
    BuiltIn{"log", "GG", Each, Code::Log},
    BuiltIn{"exp2", "GG", Each, Code::Exp2},
    BuiltIn{"log2", "GG", Each, Code::Log2},
    BuiltIn{"sqrt", "GG", Each, Code::Sqrt},
    BuiltIn{"inversesqrt", "GG", Each, Code::InverseSqrt},

    // pieces
    BuiltIn{"abs", "GG", Each, Code::Abs},
    BuiltIn{"abs", "II", AbsInt},
    BuiltIn{"sign", "GG", Each, Code::Sign},
    BuiltIn{"sign", "II", SignInt},
    BuiltIn{"floor", "GG", Each, Code::Floor},
    BuiltIn{"trunc", "GG", Each, Code::Trunc},
    BuiltIn{"round", "GG", Each, Code::Round},
    BuiltIn{"roundEven", "GG", Each, Code::Round},
    BuiltIn{"ceil", "GG", Each, Code::Ceil},
    BuiltIn{"fract", "GG", Each, Code::Fract},
    BuiltIn{"mod", "GGG", Each, Code::Mod},
    BuiltIn{"mod", "GGF", Each, Code::Mod},
    BuiltIn{"modf", "GG>G", Modf},
    BuiltIn{"min", "GGG", Each, Code::Min},
    BuiltIn{"min", "GGF", Each, Code::Min},
    BuiltIn{"min", "III", MinInt},
    BuiltIn{"min", "IIi", MinInt},
    BuiltIn{"min", "UUU", MinInt},
    BuiltIn{"min", "UUu", MinInt},
    BuiltIn{"max", "GGG", Each, Code::Max},
    BuiltIn{"max", "GGF", Each, Code::Max},
    BuiltIn{"max", "III", MaxInt},
    BuiltIn{"max", "IIi", MaxInt},
    BuiltIn{"max", "UUU", MaxInt},
    BuiltIn{"max", "UUu", MaxInt},
    BuiltIn{"clamp", "GGGG", Each, Code::Clamp},
    BuiltIn{"clamp", "GGFF", Each, Code::Clamp},
    BuiltIn{"clamp", "IIII", ClampInt},
    BuiltIn{"clamp", "IIii", ClampInt},
    BuiltIn{"clamp", "UUUU", ClampInt},
    BuiltIn{"clamp", "UUuu", ClampInt},
    BuiltIn{"mix", "GGGG", Each, Code::Mix},
    BuiltIn{"mix", "GGGF", Each, Code::Mix},
    BuiltIn{"mix", "GGGB", MixBool},
    BuiltIn{"step", "GGG", Each, Code::Step},
    BuiltIn{"step", "GFG", Each, Code::Step},
    BuiltIn{"smoothstep", "GGGG", Each, Code::Smoothstep},
    BuiltIn{"smoothstep", "GFFG", Each, Code::Smoothstep},
    BuiltIn{"isnan", "BG", IsNan},
    BuiltIn{"isinf", "BG", IsInf},

    // bits
    BuiltIn{"floatBitsToInt", "IG", Each, Code::FloatBits},
    BuiltIn{"floatBitsToUint", "UG", Each, Code::FloatBits},
    BuiltIn{"intBitsToFloat", "GI", Each, Code::FloatOfBits},
    BuiltIn{"uintBitsToFloat", "GU", Each, Code::FloatOfBits},
    BuiltIn{"packSnorm2x16", "u2", PackSigned},
    BuiltIn{"unpackSnorm2x16", "2u", UnpackSigned},
    BuiltIn{"packUnorm2x16", "u2", PackUnsigned},
    BuiltIn{"unpackUnorm2x16", "2u", UnpackUnsigned},
    BuiltIn{"packHalf2x16", "u2", PackHalf},
    BuiltIn{"unpackHalf2x16", "2u", UnpackHalf},

    // vectors
    BuiltIn{"length", "FG", Grouped, Code::Length},
    BuiltIn{"distance", "FGG", Grouped, Code::Distance},
    BuiltIn{"dot", "FGG", Dot},
    BuiltIn{"cross", "333", Cross},
    BuiltIn{"normalize", "GG", Grouped, Code::Normalize},
    BuiltIn{"faceforward", "GGGG", Grouped, Code::Faceforward},
    BuiltIn{"reflect", "GGG", Grouped, Code::Reflect},
    BuiltIn{"refract", "GGGF", Grouped, Code::Refract},

    // matrices
    BuiltIn{"matrixCompMult", "MMM", MatrixCompMult},
    BuiltIn{"outerProduct", "OVV", OuterProduct},
    BuiltIn{"transpose", "TM", Transpose},
    BuiltIn{"determinant", "FQ", Grouped, Code::Determinant},
    BuiltIn{"inverse", "QQ", Grouped, Code::Inverse},

    // conditions
    BuiltIn{"lessThan", "YVV", Compare, Code::Lt},
    BuiltIn{"lessThan", "YWW", Compare, Code::Lt},
    BuiltIn{"lessThan", "YXX", Compare, Code::Lt},
    BuiltIn{"lessThanEqual", "YVV", Compare, Code::Le},
    BuiltIn{"lessThanEqual", "YWW", Compare, Code::Le},
    BuiltIn{"lessThanEqual", "YXX", Compare, Code::Le},
    BuiltIn{"greaterThan", "YVV", Compare, Code::Gt},
    BuiltIn{"greaterThan", "YWW", Compare, Code::Gt},
    BuiltIn{"greaterThan", "YXX", Compare, Code::Gt},
    BuiltIn{"greaterThanEqual", "YVV", Compare, Code::Ge},
    BuiltIn{"greaterThanEqual", "YWW", Compare, Code::Ge},
    BuiltIn{"greaterThanEqual", "YXX", Compare, Code::Ge},
    BuiltIn{"equal", "YVV", Compare, Code::Eq},
    BuiltIn{"equal", "YWW", Compare, Code::Eq},
    BuiltIn{"equal", "YXX", Compare, Code::Eq},
    BuiltIn{"equal", "YYY", Compare, Code::Eq},
    BuiltIn{"notEqual", "YVV", Compare, Code::Ne},
    BuiltIn{"notEqual", "YWW", Compare, Code::Ne},
    BuiltIn{"notEqual", "YXX", Compare, Code::Ne},
    BuiltIn{"notEqual", "YYY", Compare, Code::Ne},
    BuiltIn{"any", "bY", Any},
    BuiltIn{"all", "bY", All},
    BuiltIn{"not", "YY", Not},

    // images
    BuiltIn{"texture", "4S2", Texture},
    BuiltIn{"texture2D", "4S2", Texture},
    BuiltIn{"textureLod", "4S2F", Texture},
    BuiltIn{"texture2DLod", "4S2F", Texture},
    BuiltIn{"textureProj", "4S3", TextureProj},
    BuiltIn{"textureProj", "4S4", TextureProj},
    BuiltIn{"texture2DProj", "4S3", TextureProj},
    BuiltIn{"texture2DProj", "4S4", TextureProj},
    BuiltIn{"textureProjLod", "4S3F", TextureProj},
    BuiltIn{"textureProjLod", "4S4F", TextureProj},
    BuiltIn{"texture2DProjLod", "4S3F", TextureProj},
    BuiltIn{"texture2DProjLod", "4S4F", TextureProj},
    BuiltIn{"textureOffset", "4S2k", Texture},
    BuiltIn{"textureLodOffset", "4S2Fk", Texture},
    BuiltIn{"textureProjOffset", "4S3k", TextureProj},
    BuiltIn{"textureProjOffset", "4S4k", TextureProj},
    BuiltIn{"textureProjLodOffset", "4S3Fk", TextureProj},
    BuiltIn{"textureProjLodOffset", "4S4Fk", TextureProj},
    BuiltIn{"textureSize", "kSi", TextureSize},
    BuiltIn{"texelFetch", "4Ski", TexelFetch},
    BuiltIn{"texelFetchOffset", "4Skik", TexelFetch},

    // what a warp has no use for, or a vertex has none
    BuiltIn{"dFdx", "GG", Refused},
    BuiltIn{"dFdy", "GG", Refused},
    BuiltIn{"fwidth", "GG", Refused},
};

// Whether an operand fits a letter. What a generic letter stands for is settled by the first.
struct Match {
  int size = 0;
  Type matrix;
  int columns = 0, rows = 0;

  bool generic(Base base, Type type, int least) {
    if (type.isArray() || type.base != base || type.columns != 1 || type.rows < least) return false;
    if (size == 0) size = type.rows;
    return size == type.rows;
  }

  bool fits(char letter, Type type) {
    switch (letter) {
      case 'G':
        return generic(Base::Float, type, 1);
      case 'I':
        return generic(Base::Int, type, 1);
      case 'U':
        return generic(Base::Uint, type, 1);
      case 'B':
        return generic(Base::Bool, type, 1);
      case 'V':
        return generic(Base::Float, type, 2);
      case 'W':
        return generic(Base::Int, type, 2);
      case 'X':
        return generic(Base::Uint, type, 2);
      case 'Y':
        return generic(Base::Bool, type, 2);
      case 'M':
      case 'Q':
        if (!type.isMatrix() || (letter == 'Q' && type.columns != type.rows)) return false;
        if (matrix.base == Base::Void) matrix = type;
        return matrix == type;
      default:
        return type == fixed(letter);
    }
  }

  static Type fixed(char letter) {
    switch (letter) {
      case 'F':
        return floatType;
      case 'i':
        return intType;
      case 'u':
        return uintType;
      case 'b':
        return boolType;
      case 'S':
        return samplerType;
      case 'k':
        return vectorType(Base::Int, 2);
      default:
        return vectorType(Base::Float, letter - '0');
    }
  }

  Type result(char letter) const {
    switch (letter) {
      case 'G':
      case 'V':
        return vectorType(Base::Float, size);
      case 'I':
        return vectorType(Base::Int, size);
      case 'U':
        return vectorType(Base::Uint, size);
      case 'B':
      case 'Y':
        return vectorType(Base::Bool, size);
      case 'M':
      case 'Q':
        return matrix;
      case 'T':
        return matrixType(matrix.rows, matrix.columns);
      case 'O':
        return matrixType(columns, rows);
      default:
        return fixed(letter);
    }
  }
};

std::optional<Type> match(std::string_view signature, std::span<const Type> operands) {
  Match match;
  std::size_t i = 0;
  for (const char letter : signature.substr(1)) {
    if (letter == '>') continue;
    if (i >= operands.size()) return std::nullopt;
    // The sizes of its operands have nothing to do with each other.
    if (signature[0] == 'O') {
      if (!operands[i].isVector() || operands[i].base != Base::Float) return std::nullopt;
      (i == 0 ? match.rows : match.columns) = operands[i].rows;
    } else if (!match.fits(letter, operands[i])) {
      return std::nullopt;
    }
    ++i;
  }
  if (i != operands.size()) return std::nullopt;
  return match.result(signature[0]);
}

}  // namespace

const std::span<const BuiltIn> builtIns = table;

bool isBuiltIn(std::string_view name) {
  for (const BuiltIn& row : table)
    if (row.name == name) return true;
  return false;
}

std::optional<Found> findBuiltIn(std::string_view name, std::span<const Type> operands) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table[i].name != name) continue;
    if (const auto result = match(table[i].signature, operands))
      return Found{static_cast<int>(i), *result};
  }
  return std::nullopt;
}

bool isOut(const BuiltIn& row, std::size_t parameter) {
  std::size_t i = 0;
  bool isNext = false;
  for (const char letter : row.signature.substr(1)) {
    if (letter == '>') {
      isNext = true;
      continue;
    }
    if (i++ == parameter) return isNext;
    isNext = false;
  }
  return false;
}

std::string_view builtInFeature(const BuiltIn& row) {
  if (row.way >= AbsInt && row.way <= ClampInt)
    return "abs, sign, min, max or clamp of whole numbers";
  return row.way == MixBool ? "mix by a bvec" : "";
}

bool readsImage(const BuiltIn& row) {
  return row.way == Texture || row.way == TextureProj || row.way == TextureSize ||
         row.way == TexelFetch;
}

bool hasOffset(const BuiltIn& row) {
  return row.signature.find('S') != row.signature.npos && row.name.ends_with("Offset");
}

}  // namespace warpjet::glsl
