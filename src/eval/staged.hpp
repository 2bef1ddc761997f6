// Four floats that machine code will compute: a scalar type whose operations write instructions
// instead of executing them. The formulas of the table and the generic functions of lanes_*.hpp are
// evaluated with it, so that the machine code has the operations of the interpreter in the same
// order and rounds alike.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "eval/lanes_trigonometry.hpp"
#include "eval/wasm_bytes.hpp"
#include "graph/graph.hpp"

namespace warpjet {

struct StagedMask;

// The location of a value: a local of the function being written, or one of the numbers shared by
// all vertices.
struct Staged {
  using Mask = StagedMask;
  static constexpr std::uint32_t sharedFlag = 1u << 31;  // a bit of `place`

  std::uint32_t place;

  Staged() = default;
  explicit Staged(std::uint32_t where) : place(where) {}
  Staged(double x);
};

Staged staged(wasm::Simd instruction, Staged x);
Staged staged(wasm::Simd instruction, Staged x, Staged y);
Staged staged(wasm::Simd instruction, Staged x, Staged y, Staged z);
// Shifts each lane by `count` bits.
Staged shiftBits(wasm::Simd instruction, Staged x, int count);
// `routine` calls a function of this module, `kernel` an imported one.
Staged routine(Op op, Staged x);
Staged routine(Op op, Staged x, Staged y);
Staged kernel(Op op, Staged x);
Staged kernel(Op op, Staged x, Staged y);

// Lanes as integers.
struct StagedBits {
  Staged lanes;
};

inline StagedBits operator<<(StagedBits x, int count) {
  return {shiftBits(wasm::ShiftLeft, x.lanes, count)};
}

struct StagedMask {
  StagedBits bits;
};

inline StagedMask asMask(Staged x) { return {{x}}; }
inline Staged asLanes(StagedMask x) { return x.bits.lanes; }

inline Staged operator+(Staged x, Staged y) { return staged(wasm::Sum, x, y); }
inline Staged operator-(Staged x, Staged y) { return staged(wasm::Difference, x, y); }
inline Staged operator*(Staged x, Staged y) { return staged(wasm::Product, x, y); }
inline Staged operator/(Staged x, Staged y) { return staged(wasm::Quotient, x, y); }
inline Staged operator-(Staged x) { return staged(wasm::Negate, x); }

inline StagedMask lt(Staged x, Staged y) { return asMask(staged(wasm::LessThan, x, y)); }
inline StagedMask le(Staged x, Staged y) { return asMask(staged(wasm::LessOrEqual, x, y)); }
inline StagedMask gt(Staged x, Staged y) { return asMask(staged(wasm::GreaterThan, x, y)); }
inline StagedMask ge(Staged x, Staged y) { return asMask(staged(wasm::GreaterOrEqual, x, y)); }
inline StagedMask eq(Staged x, Staged y) { return asMask(staged(wasm::Equal, x, y)); }
inline StagedMask ne(Staged x, Staged y) { return asMask(staged(wasm::NotEqual, x, y)); }

inline StagedMask logicalAnd(StagedMask x, StagedMask y) {
  return asMask(staged(wasm::And, asLanes(x), asLanes(y)));
}
inline StagedMask logicalOr(StagedMask x, StagedMask y) {
  return asMask(staged(wasm::Or, asLanes(x), asLanes(y)));
}
inline StagedMask logicalNot(StagedMask x) { return asMask(staged(wasm::Not, asLanes(x))); }

inline Staged ifElse(StagedMask condition, Staged yes, Staged no) {
  return staged(wasm::Select, yes, no, asLanes(condition));
}

inline StagedMask signOf(Staged x) { return asMask(staged(wasm::And, x, -0.0)); }
inline Staged flipSign(Staged x, StagedMask signs) { return staged(wasm::Xor, x, asLanes(signs)); }

inline Staged abs(Staged x) { return staged(wasm::Absolute, x); }
inline Staged floor(Staged x) { return staged(wasm::Floor, x); }
inline Staged ceil(Staged x) { return staged(wasm::Ceil, x); }
inline Staged round(Staged x) { return staged(wasm::Nearest, x); }
inline Staged trunc(Staged x) { return staged(wasm::Truncate, x); }
inline Staged sqrt(Staged x) { return staged(wasm::SquareRoot, x); }
inline Staged min(Staged x, Staged y) { return staged(wasm::Min, x, y); }
inline Staged max(Staged x, Staged y) { return staged(wasm::Max, x, y); }

// Routines, which are written once per module.
inline Staged sin(Staged x) { return routine(ops::find("sin"), x); }
inline Staged cos(Staged x) { return routine(ops::find("cos"), x); }
inline Staged hash(Staged h, Staged i) { return routine(ops::find("hash"), h, i); }

// Functions of the interpreter, which machine_code.cpp imports.
inline constexpr std::array kernelOps{
    ops::find("tan"),   ops::find("asin"),  ops::find("acos"),  ops::find("atan"),
    ops::find("atan2"), ops::find("exp"),   ops::find("exp2"),  ops::find("log"),
    ops::find("log2"),  ops::find("pow"),   ops::find("sinh"),  ops::find("cosh"),
    ops::find("tanh"),  ops::find("asinh"), ops::find("acosh"), ops::find("atanh"),
};
inline Staged tan(Staged x) { return kernel(ops::find("tan"), x); }
inline Staged asin(Staged x) { return kernel(ops::find("asin"), x); }
inline Staged acos(Staged x) { return kernel(ops::find("acos"), x); }
inline Staged atan(Staged x) { return kernel(ops::find("atan"), x); }
inline Staged atan2(Staged y, Staged x) { return kernel(ops::find("atan2"), y, x); }
inline Staged exp(Staged x) { return kernel(ops::find("exp"), x); }
inline Staged exp2(Staged x) { return kernel(ops::find("exp2"), x); }
inline Staged log(Staged x) { return kernel(ops::find("log"), x); }
inline Staged log2(Staged x) { return kernel(ops::find("log2"), x); }
inline Staged pow(Staged x, Staged y) { return kernel(ops::find("pow"), x, y); }
inline Staged sinh(Staged x) { return kernel(ops::find("sinh"), x); }
inline Staged cosh(Staged x) { return kernel(ops::find("cosh"), x); }
inline Staged tanh(Staged x) { return kernel(ops::find("tanh"), x); }
inline Staged asinh(Staged x) { return kernel(ops::find("asinh"), x); }
inline Staged acosh(Staged x) { return kernel(ops::find("acosh"), x); }
inline Staged atanh(Staged x) { return kernel(ops::find("atanh"), x); }

}  // namespace warpjet
