#include "source/glsl/built_in_table.hpp"

namespace warpjet::source::glsl {

namespace {

using enum Way;

// GLSL ES 3.00, section 8, and the functions that exist only in 1.00.
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

    // piecewise functions
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

    // functions that are useless for a warp, or that vertex shaders lack
    BuiltIn{"dFdx", "GG", Unsupported},
    BuiltIn{"dFdy", "GG", Unsupported},
    BuiltIn{"fwidth", "GG", Unsupported},
};

}  // namespace

const BuiltIns builtIns = table;

std::string_view builtInFeature(const BuiltIn& row) {
  if (row.way >= AbsInt && row.way <= ClampInt)
    return "abs, sign, min, max or clamp of whole numbers";
  return row.way == MixBool ? "mix by a bvec" : "";
}

}  // namespace warpjet::source::glsl
