// The rows of the table that compute with integers; operations named `bits` treat them as unsigned.
// Only the front ends for shader source use them.
#pragma once

#include <tuple>

#include "ops/ints.hpp"
#include "ops/row.hpp"
#include "ops/scalar.hpp"

namespace warpjet::ops {

using enum Precedence;
using enum Language;

inline constexpr std::tuple intRows{
    row("int", call("int($0)").with(Wgsl, "i32($0)"), everywhere,
        [](auto x) { return truncate(x); }),
    row("bitsOf", call("int(uint($0))").with(Wgsl, "i32(u32($0))").missingIn(Glsl100), everywhere,
        [](double x) { return truncateBits(x); }),
    row("intToFloat", call("float($0)").with(Wgsl, "f32($0)"), everywhere,
        [](auto x) { return asFloat(x); }),
    row("bitsToFloat", call("float(uint($0))").with(Wgsl, "f32(u32($0))").missingIn(Glsl100),
        everywhere, [](auto x) { return bitsAsFloat(x); }),
    row("floatBitsToInt",
        call("floatBitsToInt($0)").with(Wgsl, "bitcast<i32>($0)").missingIn(Glsl100), everywhere,
        [](double x) { return floatBits(x); }),
    row("intBitsToFloat",
        call("intBitsToFloat($0)").with(Wgsl, "bitcast<f32>($0)").missingIn(Glsl100), everywhere,
        [](double x) { return floatOfBits(x); }),
    row("intAdd", infix("$0 + $1", Additive), everywhere,
        [](auto x, auto y) { return intSum(x, y); }),
    row("intSub", infix("$0 - $1", Additive), everywhere,
        [](double x, double y) { return intDifference(x, y); }),
    row("intMult", infix("$0 * $1", Multiplicative), everywhere,
        [](double x, double y) { return intProduct(x, y); }),
    row("intDiv", infix("$0 / $1", Multiplicative), everywhere,
        [](double x, double y) { return intQuotient(x, y); }),
    row("intMod", infix("$0 % $1", Multiplicative).missingIn(Glsl100), everywhere,
        [](auto x, auto y) { return intRemainder(x, y); })
        .lowersTo(
            [](auto x, auto y) { return intDifference(x, intProduct(intQuotient(x, y), y)); }),
    row("bitsDiv",
        call("int(uint($0) / uint($1))").with(Wgsl, "i32(u32($0) / u32($1))").missingIn(Glsl100),
        everywhere, [](double x, double y) { return bitsQuotient(x, y); }),
    row("bitsMod",
        call("int(uint($0) % uint($1))").with(Wgsl, "i32(u32($0) % u32($1))").missingIn(Glsl100),
        everywhere, [](double x, double y) { return bitsRemainder(x, y); }),
    row("bitAnd", bits("$0 & $1").missingIn(Glsl100), everywhere,
        [](auto x, auto y) { return bitAnd(x, y); }),
    row("bitOr", bits("$0 | $1").missingIn(Glsl100), everywhere,
        [](double x, double y) { return bitOr(x, y); }),
    row("bitXor", bits("$0 ^ $1").missingIn(Glsl100), everywhere,
        [](double x, double y) { return bitXor(x, y); }),
    row("bitNot", Spellings(Spelling{"~$0", Unary, {Unary, {}, {}}}).missingIn(Glsl100), everywhere,
        [](double x) { return bitNot(x); }),
    row("shiftLeft", bits("$0 << $1").withText(Wgsl, "$0 << u32($1)").missingIn(Glsl100),
        everywhere, [](double x, double y) { return shiftLeft(x, y); }),
    row("shiftRight", bits("$0 >> $1").withText(Wgsl, "$0 >> u32($1)").missingIn(Glsl100),
        everywhere, [](double x, double y) { return shiftRight(x, y); }),
    row("bitsShiftRight",
        call("int(uint($0) >> $1)").with(Wgsl, "i32(u32($0) >> u32($1))").missingIn(Glsl100),
        everywhere, [](auto x, auto y) { return bitsShiftRight(x, y); }),
    row("intLt", infix("$0 < $1", Relational), everywhere,
        [](double x, double y) { return lt(x, y); }),
    row("bitsLt",
        Spellings(Spelling{"uint($0) < uint($1)", Relational})
            .withText(Wgsl, "u32($0) < u32($1)")
            .missingIn(Glsl100),
        everywhere, [](double x, double y) { return bitsOf(x) < bitsOf(y); }),
    row("intEq", infix("$0 == $1", Equality), everywhere,
        [](double x, double y) { return eq(x, y); }),
    row("intIfElse", conditional, everywhere,
        [](auto condition, auto yes, auto no) { return ifElse(condition, yes, no); }),
};

}  // namespace warpjet::ops
