#include "source/wgsl/built_in_table.hpp"

#include <array>

namespace warpjet::source::wgsl {

namespace {

using enum Way;

// WGSL, section 17.
constexpr std::array table{
    // operators of vectors
    BuiltIn{"<", "YVV", Compare, Code::Lt},
    BuiltIn{"<", "YWW", Compare, Code::Lt},
    BuiltIn{"<", "YXX", Compare, Code::Lt},
    BuiltIn{"<=", "YVV", Compare, Code::Le},
    BuiltIn{"<=", "YWW", Compare, Code::Le},
    BuiltIn{"<=", "YXX", Compare, Code::Le},
    BuiltIn{">", "YVV", Compare, Code::Gt},
    BuiltIn{">", "YWW", Compare, Code::Gt},
    BuiltIn{">", "YXX", Compare, Code::Gt},
    BuiltIn{">=", "YVV", Compare, Code::Ge},
    BuiltIn{">=", "YWW", Compare, Code::Ge},
    BuiltIn{">=", "YXX", Compare, Code::Ge},
    BuiltIn{"==", "YVV", Compare, Code::Eq},
    BuiltIn{"==", "YWW", Compare, Code::Eq},
    BuiltIn{"==", "YXX", Compare, Code::Eq},
    BuiltIn{"==", "YYY", Compare, Code::Eq},
    BuiltIn{"!=", "YVV", Compare, Code::Ne},
    BuiltIn{"!=", "YWW", Compare, Code::Ne},
    BuiltIn{"!=", "YXX", Compare, Code::Ne},
    BuiltIn{"!=", "YYY", Compare, Code::Ne},
    BuiltIn{"!", "YY", Not},
    BuiltIn{"bitcast<i32>", "IG", Each, Code::FloatBits},
    BuiltIn{"bitcast<u32>", "UG", Each, Code::FloatBits},
    BuiltIn{"bitcast<f32>", "GI", Each, Code::FloatOfBits},
    BuiltIn{"bitcast<f32>", "GU", Each, Code::FloatOfBits},

    // logic
    BuiltIn{"all", "bB", All},
    BuiltIn{"any", "bB", Any},
    BuiltIn{"select", "GGGb", MixBool},
    BuiltIn{"select", "GGGB", MixBool},
    BuiltIn{"select", "IIIb", MixBool},
    BuiltIn{"select", "IIIB", MixBool},
    BuiltIn{"select", "UUUb", MixBool},
    BuiltIn{"select", "UUUB", MixBool},
    BuiltIn{"select", "BBBb", MixBool},
    BuiltIn{"select", "BBBB", MixBool},

    // angles
    BuiltIn{"radians", "GG", Each, Code::Radians},
    BuiltIn{"degrees", "GG", Each, Code::Degrees},
    BuiltIn{"sin", "GG", Each, Code::Sin},
    BuiltIn{"cos", "GG", Each, Code::Cos},
    BuiltIn{"tan", "GG", Each, Code::Tan},
    BuiltIn{"asin", "GG", Each, Code::Asin},
    BuiltIn{"acos", "GG", Each, Code::Acos},
    BuiltIn{"atan", "GG", Each, Code::Atan},
    BuiltIn{"atan2", "GGG", Each, Code::Atan},
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
    BuiltIn{"inverseSqrt", "GG", Each, Code::InverseSqrt},
    BuiltIn{"ldexp", "GGI", Ldexp},
    BuiltIn{"frexp", "GG", Frexp},
    BuiltIn{"quantizeToF16", "GG", QuantizeToHalf},

    // piecewise functions
    BuiltIn{"abs", "II", AbsInt},
    BuiltIn{"abs", "UU", Same},
    BuiltIn{"abs", "GG", Each, Code::Abs},
    BuiltIn{"sign", "II", SignInt},
    BuiltIn{"sign", "GG", Each, Code::Sign},
    BuiltIn{"floor", "GG", Each, Code::Floor},
    BuiltIn{"trunc", "GG", Each, Code::Trunc},
    BuiltIn{"round", "GG", Each, Code::Round},
    BuiltIn{"ceil", "GG", Each, Code::Ceil},
    BuiltIn{"fract", "GG", Each, Code::Fract},
    BuiltIn{"modf", "GG", ModfPair},
    BuiltIn{"min", "III", MinInt},
    BuiltIn{"min", "UUU", MinInt},
    BuiltIn{"min", "GGG", Each, Code::Min},
    BuiltIn{"max", "III", MaxInt},
    BuiltIn{"max", "UUU", MaxInt},
    BuiltIn{"max", "GGG", Each, Code::Max},
    BuiltIn{"clamp", "IIII", ClampInt},
    BuiltIn{"clamp", "UUUU", ClampInt},
    BuiltIn{"clamp", "GGGG", Each, Code::Clamp},
    BuiltIn{"saturate", "GG", Saturate},
    BuiltIn{"fma", "GGGG", Fma},
    BuiltIn{"mix", "GGGG", Each, Code::Mix},
    BuiltIn{"mix", "GGGF", Each, Code::Mix},
    BuiltIn{"step", "GGG", Each, Code::Step},
    BuiltIn{"smoothstep", "GGGG", Each, Code::Smoothstep},

    // vectors and matrices
    BuiltIn{"length", "FG", Grouped, Code::Length},
    BuiltIn{"distance", "FGG", Grouped, Code::Distance},
    BuiltIn{"dot", "iWW", Dot},
    BuiltIn{"dot", "uXX", Dot},
    BuiltIn{"dot", "FVV", Dot},
    BuiltIn{"cross", "333", Cross},
    BuiltIn{"normalize", "VV", Grouped, Code::Normalize},
    BuiltIn{"faceForward", "VVVV", Grouped, Code::Faceforward},
    BuiltIn{"reflect", "VVV", Grouped, Code::Reflect},
    BuiltIn{"refract", "VVVF", Grouped, Code::Refract},
    BuiltIn{"transpose", "TM", Transpose},
    BuiltIn{"determinant", "FQ", Grouped, Code::Determinant},

    // bits
    BuiltIn{"countOneBits", "II", CountOneBits},
    BuiltIn{"countOneBits", "UU", CountOneBits},
    BuiltIn{"countLeadingZeros", "II", CountLeadingZeros},
    BuiltIn{"countLeadingZeros", "UU", CountLeadingZeros},
    BuiltIn{"countTrailingZeros", "II", CountTrailingZeros},
    BuiltIn{"countTrailingZeros", "UU", CountTrailingZeros},
    BuiltIn{"firstLeadingBit", "II", FirstLeadingBit},
    BuiltIn{"firstLeadingBit", "UU", FirstLeadingBit},
    BuiltIn{"firstTrailingBit", "II", FirstTrailingBit},
    BuiltIn{"firstTrailingBit", "UU", FirstTrailingBit},
    BuiltIn{"reverseBits", "II", ReverseBits},
    BuiltIn{"reverseBits", "UU", ReverseBits},
    BuiltIn{"extractBits", "IIuu", ExtractBits},
    BuiltIn{"extractBits", "UUuu", ExtractBits},
    BuiltIn{"insertBits", "IIIuu", InsertBits},
    BuiltIn{"insertBits", "UUUuu", InsertBits},
    BuiltIn{"dot4I8Packed", "iuu", DotBytes},
    BuiltIn{"dot4U8Packed", "uuu", DotBytes},
    BuiltIn{"pack2x16snorm", "u2", PackSigned},
    BuiltIn{"pack2x16unorm", "u2", PackUnsigned},
    BuiltIn{"pack2x16float", "u2", PackHalf},
    BuiltIn{"pack4x8snorm", "u4", PackSigned},
    BuiltIn{"pack4x8unorm", "u4", PackUnsigned},
    BuiltIn{"pack4xI8", "un", PackBytes},
    BuiltIn{"pack4xU8", "um", PackBytes},
    BuiltIn{"pack4xI8Clamp", "un", PackBytesClamped},
    BuiltIn{"pack4xU8Clamp", "um", PackBytesClamped},
    BuiltIn{"unpack2x16snorm", "2u", UnpackSigned},
    BuiltIn{"unpack2x16unorm", "2u", UnpackUnsigned},
    BuiltIn{"unpack2x16float", "2u", UnpackHalf},
    BuiltIn{"unpack4x8snorm", "4u", UnpackSigned},
    BuiltIn{"unpack4x8unorm", "4u", UnpackUnsigned},
    BuiltIn{"unpack4xI8", "nu", UnpackBytes},
    BuiltIn{"unpack4xU8", "mu", UnpackBytes},

    // images, without their samplers
    BuiltIn{"textureSampleLevel", "4S2F", Texture},
    BuiltIn{"textureSampleLevelOffset", "4S2Fk", Texture},
    BuiltIn{"textureDimensions", "kSi", TextureSize},
    BuiltIn{"textureLoad", "4Ski", TexelFetch},

    // functions of fragments
    BuiltIn{"dpdx", "GG", Unsupported},
    BuiltIn{"dpdxCoarse", "GG", Unsupported},
    BuiltIn{"dpdxFine", "GG", Unsupported},
    BuiltIn{"dpdy", "GG", Unsupported},
    BuiltIn{"dpdyCoarse", "GG", Unsupported},
    BuiltIn{"dpdyFine", "GG", Unsupported},
    BuiltIn{"fwidth", "GG", Unsupported},
    BuiltIn{"fwidthCoarse", "GG", Unsupported},
    BuiltIn{"fwidthFine", "GG", Unsupported},
};

}  // namespace

const BuiltIns builtIns = table;

}  // namespace warpjet::source::wgsl
