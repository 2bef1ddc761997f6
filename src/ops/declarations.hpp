// Declares every operation, one per line: name, types and traits. Most files need no more of an
// operation than this. table.hpp has its spelling and formulas, documentation.hpp its description;
// both have the same names in the same order.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>

#include "ops/types.hpp"

namespace warpjet::ops {

// Properties of an operation that other modules need.
enum class Trait : std::uint8_t {
  Chained,      // takes any number of operands, from left to right
  OnMatrices,   // works on matrices componentwise, except products and quotients by a matrix
  Commutative,  // x and y may be swapped
  Branches,     // its value is that of one operand, and the other operands don't matter
  Divides,      // its second operand must not be 0
  Increasing,   // monotonically increasing in its only operand
  Hidden,       // has no public method of its name
  SourceOnly,   // only the front ends for shader source use it
};

class Traits {
 public:
  constexpr Traits() = default;
  constexpr Traits(std::initializer_list<Trait> all) {
    for (const Trait trait : all) bits_ |= bit(trait);
  }

  constexpr bool has(Trait trait) const { return (bits_ & bit(trait)) != 0; }

 private:
  static constexpr unsigned bit(Trait trait) { return 1u << static_cast<unsigned>(trait); }

  unsigned bits_ = 0;
};

struct Declaration {
  std::string_view name;
  int arity;
  Signature signature;
  Traits traits;
};

template <class... Each>
constexpr Declaration unary(std::string_view name, Signature signature, Each... traits) {
  return {name, 1, signature, {traits...}};
}

template <class... Each>
constexpr Declaration binary(std::string_view name, Signature signature, Each... traits) {
  return {name, 2, signature, {traits...}};
}

template <class... Each>
constexpr Declaration ternary(std::string_view name, Signature signature, Each... traits) {
  return {name, 3, signature, {traits...}};
}

using enum Trait;

inline constexpr std::array declarations{
    // arithmetic
    unary("neg", floats, OnMatrices),
    binary("add", floats, Chained, OnMatrices, Commutative),
    binary("sub", floats, Chained, OnMatrices),
    binary("mult", floats, Chained, OnMatrices, Commutative),
    binary("div", floats, Chained, OnMatrices, Divides),

    // powers
    binary("pow", floats),
    unary("sqrt", floats),
    unary("inversesqrt", floats),
    unary("exp", floats),
    unary("exp2", floats),
    unary("log", floats),
    unary("log2", floats),

    // trigonometry, in radians
    unary("sin", floats),
    unary("cos", floats),
    unary("tan", floats),
    unary("asin", floats),
    unary("acos", floats),
    unary("atan", floats),
    binary("atan2", floats, Hidden),

    // hyperbolic functions
    unary("sinh", floats),
    unary("cosh", floats),
    unary("tanh", floats),
    unary("asinh", floats),
    unary("acosh", floats),
    unary("atanh", floats),

    // piecewise functions
    unary("abs", floats),
    unary("sign", floats),
    unary("floor", floats),
    unary("ceil", floats),
    unary("round", floats),
    unary("trunc", floats),
    unary("fract", floats),
    binary("mod", floats, Divides),
    binary("min", floats, Chained, Branches),
    binary("max", floats, Chained, Branches),
    ternary("clamp", floats, Branches),
    ternary("mix", floats, OnMatrices),
    binary("step", floats),

    // conditions
    binary("lt", comparison),
    binary("le", comparison),
    binary("gt", comparison),
    binary("ge", comparison),
    binary("eq", comparison),
    binary("ne", comparison),
    binary("and", logic, Chained),
    binary("or", logic, Chained),
    unary("not", logic),
    ternary("ifElse", choice, OnMatrices, Branches),

    // noise
    binary("hash", floats, Hidden),

    // conversions, inserted where a condition is used as a number or vice versa
    unary("float", toFloat, Hidden),
    unary("bool", toBool, Hidden),

    // integers; operations named `bits` treat them as unsigned
    unary("int", toInt, SourceOnly),
    unary("bitsOf", toInt, SourceOnly),
    unary("intToFloat", fromInt, SourceOnly),
    unary("bitsToFloat", fromInt, SourceOnly),
    unary("floatBitsToInt", toInt, SourceOnly),
    unary("intBitsToFloat", fromInt, SourceOnly),
    binary("intAdd", ints, SourceOnly, Commutative),
    binary("intSub", ints, SourceOnly),
    binary("intMult", ints, SourceOnly, Commutative),
    binary("intDiv", ints, SourceOnly),
    binary("intMod", ints, SourceOnly),
    binary("bitsDiv", ints, SourceOnly),
    binary("bitsMod", ints, SourceOnly),
    binary("bitAnd", ints, SourceOnly, Commutative),
    binary("bitOr", ints, SourceOnly, Commutative),
    binary("bitXor", ints, SourceOnly, Commutative),
    unary("bitNot", ints, SourceOnly),
    binary("shiftLeft", ints, SourceOnly),
    binary("shiftRight", ints, SourceOnly),
    binary("bitsShiftRight", ints, SourceOnly),
    binary("intLt", intComparison, SourceOnly),
    binary("bitsLt", intComparison, SourceOnly),
    binary("intEq", intComparison, SourceOnly),
    ternary("intIfElse", intChoice, SourceOnly, Branches),
};

}  // namespace warpjet::ops
