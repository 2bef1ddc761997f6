// Every operation: its name, its types and its traits, one a line. Most files need no more of an
// operation than this. Its spelling and formulas are its row of table.hpp, what people read of it
// is its row of documentation.hpp; both have the same names in the same order.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>

#include "ops/types.hpp"

namespace warpjet::ops {

// What the other rooms ask of an operation.
enum class Trait : std::uint8_t {
  Chained,      // takes any number of operands, from left to right
  OnMatrices,   // matrices have it by component, but for products, and quotients by a matrix
  Commutative,  // x and y may change places
  Branches,     // its value is that of one operand, and what the others are does not matter
  Divides,      // its second operand must not be 0
  Rising,       // of one operand, with which its value never falls
  Hidden,       // no sketch calls it by its name
  ForText,      // only what reads shader text does
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

    // pieces
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

    // conversions, inserted where a condition is used as a number or a number as a condition
    unary("float", toFloat, Hidden),
    unary("bool", toBool, Hidden),

    // whole numbers; with `bits` they are taken to have no sign
    unary("int", toWhole, ForText),
    unary("bitsOf", toWhole, ForText),
    unary("intToFloat", wholeToFloat, ForText),
    unary("bitsToFloat", wholeToFloat, ForText),
    unary("floatBitsToInt", toWhole, ForText),
    unary("intBitsToFloat", wholeToFloat, ForText),
    binary("intAdd", wholes, ForText, Commutative),
    binary("intSub", wholes, ForText),
    binary("intMult", wholes, ForText, Commutative),
    binary("intDiv", wholes, ForText),
    binary("intMod", wholes, ForText),
    binary("bitsDiv", wholes, ForText),
    binary("bitsMod", wholes, ForText),
    binary("bitAnd", wholes, ForText, Commutative),
    binary("bitOr", wholes, ForText, Commutative),
    binary("bitXor", wholes, ForText, Commutative),
    unary("bitNot", wholes, ForText),
    binary("shiftLeft", wholes, ForText),
    binary("shiftRight", wholes, ForText),
    binary("bitsShiftRight", wholes, ForText),
    binary("intLt", wholeComparison, ForText),
    binary("bitsLt", wholeComparison, ForText),
    binary("intEq", wholeComparison, ForText),
    ternary("intIfElse", wholeChoice, ForText, Branches),
};

}  // namespace warpjet::ops
