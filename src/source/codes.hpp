// The operations of lowered code, with their external names: those of the builder, except leaves
// and conversions between numbers and groups of numbers.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace warpjet::source {

// clang-format off
#define WARPJET_CODES(CODE) \
  CODE(Constant, "constant") \
  CODE(Whole, "whole") \
  CODE(Undefined, "undefined") \
  CODE(Argument, "argument") \
  CODE(Uniform, "uniform") \
  CODE(Component, "component") \
  CODE(StepNumber, "stepNumber") \
  CODE(State, "state") \
  CODE(Parameter, "parameter") \
  CODE(Call, "call") \
  CODE(Result, "result") \
  CODE(Define, "define") \
  CODE(End, "end") \
  CODE(Fold, "fold") \
  CODE(Next, "next") \
  CODE(Outcome, "outcome") \
  CODE(Image, "image") \
  CODE(Texel, "texel") \
  CODE(FetchedTexel, "fetchedTexel") \
  CODE(ImageSize, "imageSize") \
  CODE(Neg, "neg") \
  CODE(Add, "add") \
  CODE(Sub, "sub") \
  CODE(Mult, "mult") \
  CODE(Div, "div") \
  CODE(Pow, "pow") \
  CODE(Sqrt, "sqrt") \
  CODE(InverseSqrt, "inversesqrt") \
  CODE(Exp, "exp") \
  CODE(Exp2, "exp2") \
  CODE(Log, "log") \
  CODE(Log2, "log2") \
  CODE(Sin, "sin") \
  CODE(Cos, "cos") \
  CODE(Tan, "tan") \
  CODE(Asin, "asin") \
  CODE(Acos, "acos") \
  CODE(Atan, "atan") \
  CODE(Sinh, "sinh") \
  CODE(Cosh, "cosh") \
  CODE(Tanh, "tanh") \
  CODE(Asinh, "asinh") \
  CODE(Acosh, "acosh") \
  CODE(Atanh, "atanh") \
  CODE(Abs, "abs") \
  CODE(Sign, "sign") \
  CODE(Floor, "floor") \
  CODE(Ceil, "ceil") \
  CODE(Round, "round") \
  CODE(Trunc, "trunc") \
  CODE(Fract, "fract") \
  CODE(Mod, "mod") \
  CODE(Min, "min") \
  CODE(Max, "max") \
  CODE(Clamp, "clamp") \
  CODE(Mix, "mix") \
  CODE(Step, "step") \
  CODE(Smoothstep, "smoothstep") \
  CODE(Radians, "radians") \
  CODE(Degrees, "degrees") \
  CODE(Lt, "lt") \
  CODE(Le, "le") \
  CODE(Gt, "gt") \
  CODE(Ge, "ge") \
  CODE(Eq, "eq") \
  CODE(Ne, "ne") \
  CODE(And, "and") \
  CODE(Or, "or") \
  CODE(Not, "not") \
  CODE(IfElse, "ifElse") \
  CODE(Length, "length") \
  CODE(Distance, "distance") \
  CODE(Normalize, "normalize") \
  CODE(Reflect, "reflect") \
  CODE(Refract, "refract") \
  CODE(Faceforward, "faceforward") \
  CODE(Determinant, "determinant") \
  CODE(Inverse, "inverse") \
  CODE(Vec2, "vec2") \
  CODE(Vec3, "vec3") \
  CODE(Vec4, "vec4") \
  CODE(Mat2, "mat2") \
  CODE(Mat3, "mat3") \
  CODE(Mat4, "mat4") \
  CODE(IntOf, "int") \
  CODE(FloatOf, "intToFloat") \
  CODE(UintOf, "bitsOf") \
  CODE(FloatOfUint, "bitsToFloat") \
  CODE(IntOfHalves, "intOfHalves") \
  CODE(UintOfHalves, "uintOfHalves") \
  CODE(IntAdd, "intAdd") \
  CODE(IntSub, "intSub") \
  CODE(IntMult, "intMult") \
  CODE(IntDiv, "intDiv") \
  CODE(IntMod, "intMod") \
  CODE(UintDiv, "bitsDiv") \
  CODE(UintMod, "bitsMod") \
  CODE(BitAnd, "bitAnd") \
  CODE(BitOr, "bitOr") \
  CODE(BitXor, "bitXor") \
  CODE(BitNot, "bitNot") \
  CODE(ShiftLeft, "shiftLeft") \
  CODE(ShiftRight, "shiftRight") \
  CODE(UintShiftRight, "bitsShiftRight") \
  CODE(IntLt, "intLt") \
  CODE(UintLt, "bitsLt") \
  CODE(IntEq, "intEq") \
  CODE(IntIfElse, "intIfElse") \
  CODE(FloatBits, "floatBitsToInt") \
  CODE(FloatOfBits, "intBitsToFloat") \
  CODE(SameBits, "")
// clang-format on

#define WARPJET_CODE(code, name) code,
enum class Code : std::uint8_t { WARPJET_CODES(WARPJET_CODE) };
#undef WARPJET_CODE

#define WARPJET_CODE(code, name) name,
inline constexpr std::array codeNames{WARPJET_CODES(WARPJET_CODE)};
#undef WARPJET_CODE

#undef WARPJET_CODES

}  // namespace warpjet::source
