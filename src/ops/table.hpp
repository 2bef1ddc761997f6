// THE table: one row an operation, in the order of declarations.hpp, which has the types and
// traits. A row gives spelling, the domain on which tests sample it, value, and one partial
// derivative an operand; `v` is the operation's own result, so that exp, sqrt or tan can share it.
// A row that a language lacks also says how it is lowered to others.
//
// A new row needs nothing but its declaration: a value that takes `double` runs everywhere. One
// that takes any scalar runs four vertices at a time and has narrow bounds; what it calls must then
// be in scalar.hpp, in interval.hpp and among the lanes of src/eval. tests/cpp/own_row adds such
// rows and sees what becomes of them. What a formula here calls must be in graph/expression.hpp.
//
// Kinks: d|x| = sign(x). floor, ceil, round, trunc, sign, step and comparisons have derivative 0;
// fract has 1; mod(x, y) has 1 by x and -floor(x/y) by y. min, max, clamp and ifElse take the
// branch that the value takes, min and max the first of equal operands, and clamp(x, low, high) is
// min(max(x, low), high) even where low is above high. At and beyond the edge of its domain an
// operation has derivative 0 instead of infinity or 0/0: sqrt(0), pow(x, y) for x <= 0 (whole
// powers are products and never come here), asin and acos of 1 and -1, acosh(1), atan(0, 0). So
// length, dist and normalize are safe at zero. log, inversesqrt, atanh and 1/x are not guarded:
// where they are infinite, so is the position.
//
// Infinities: what has a value where its operand is infinite, such as 1/x, exp(-x) or atan(x), has
// derivative 0 there, though the operand's be infinite or no number. Such a row takes the operand's
// derivative `d` as well and gives the product, in an order in which float32 neither overflows nor
// underflows before its end.
//
// A lone `//` keeps clang-format from joining two lines.
#pragma once

#include <tuple>

#include "ops/row.hpp"
#include "ops/scalar.hpp"
#include "ops/whole.hpp"

namespace warpjet::ops {

inline constexpr auto one = [](auto...) { return 1.0; };
inline constexpr auto minusOne = [](auto...) { return -1.0; };
inline constexpr auto zero = [](auto...) { return 0.0; };

// For derivatives that are infinite at the edge of an operation's domain.
inline constexpr auto inversesqrtOrZero = [](auto x) {
  return ifElse(gt(x, 0.0), inversesqrt(x), 0.0);
};

// Where what may be infinite is multiplied by less, or divided by more, the product is lost beside
// the ones of I + J; float32 ends early enough beyond for what is still finite to stay so.
inline constexpr double least = 1e-25, most = 1e30;

// x d / (x² + y²), or 0 at zero: scaled, since float32 may have no x² where it has the quotient.
inline constexpr auto turn = [](auto x, auto y, auto d) {
  const auto size = max(abs(x), abs(y)), a = x / size, b = y / size;
  const auto term = ifElse(gt(size, 0.0), a / (a * a + b * b) * (d / size), 0.0);
  return countedWhere(lt(size, most), size, countedWhere(lt(size, most), d, term));
};

using enum Precedence;
using enum Language;

// hashOf of scalar.hpp; in whole numbers where the language has them. 4091 * 262144 keeps a
// negative `i` above zero, where GLSL's % is defined. Where all is float, a quotient rounded to a
// whole number leaves a remainder that lies up to 5 beyond 0 or 4091, if division is right to 2.5
// ulp. Products of two such, at most 2^24, are exact as well, so only the last one is put right.
inline constexpr Helpers hashHelpers{
    R"(highp float warpjetHash(highp float h, highp float i) {
  highp uint n = (1597u * (uint(h) + uint(int(floor(i)) + 1072431104) % 4091u) + 823u) % 4091u;
  return float(n * n % 4091u * n % 4091u);
}
)",
    R"(highp float warpjetRemainder(highp float x) {
  return x - 4091.0 * floor(x / 4091.0);
}
highp float warpjetHash(highp float h, highp float i) {
  highp float n = warpjetRemainder(1597.0 * (floor(h) + warpjetRemainder(floor(i))) + 823.0);
  highp float r = warpjetRemainder(warpjetRemainder(n * n) * n);
  return r < 0.0 ? r + 4091.0 : r < 4091.0 ? r : r - 4091.0;
}
)",
    R"(fn warpjetHash(h: f32, i: f32) -> f32 {
  let n = (1597u * (u32(h) + u32(i32(floor(i)) + 1072431104) % 4091u) + 823u) % 4091u;
  return f32(n * n % 4091u * n % 4091u);
}
)"};

inline constexpr std::tuple table{
    // arithmetic
    row(
        "neg", negation, everywhere, [](auto x) { return -x; }, minusOne),
    row(
        "add", infix("$0 + $1", Additive), everywhere, [](auto x, auto y) { return x + y; }, one,
        one),
    row(
        "sub", infix("$0 - $1", Additive), everywhere, [](auto x, auto y) { return x - y; }, one,
        minusOne),
    row(
        "mult", infix("$0 * $1", Multiplicative), everywhere,
        [](auto x, auto y) { return x * y; },  //
        [](auto, auto y, auto) { return y; },  //
        [](auto x, auto, auto) { return x; }),
    row(
        "div", infix("$0 / $1", Multiplicative), {anywhere, positive, {}},
        [](auto x, auto y) { return x / y; },        //
        [](auto, auto y, auto) { return 1.0 / y; },  //
        [](auto, auto y, auto v, auto d) {
          // A quotient may be 0 by its numerator, and turns there; sinh / cosh has huge parts that
          // count.
          return countedWhere(logicalOr(lt(abs(y), 1 / least), gt(abs(v), least)), d, -(v * d) / y);
        }),

    // powers
    row(
        "pow", call("pow($0, $1)"), {positive, anywhere, {}},
        [](auto x, auto y) { return pow(x, y); },
        [](auto x, auto y, auto v, auto d) {
          const auto slope = ifElse(gt(x, 0.0), y * pow(x, y - 1.0), 0.0);
          return countedWhere(gt(v, least), d, slope * d);
        },
        [](auto x, auto, auto v, auto d) {
          const auto term = countedWhere(gt(v, least), d, v * (log(x) * d));
          return ifElse(gt(x, 0.0), countedWhere(gt(v, least), x, term), 0.0);
        }),
    row(
        "sqrt", call("sqrt($0)"), {positive}, [](auto x) { return sqrt(x); },
        [](auto x, auto v) { return ifElse(gt(x, 0.0), 0.5 / v, 0.0); }),
    row(
        "inversesqrt", call("inversesqrt($0)").with(Wgsl, "inverseSqrt($0)"), {positive},
        [](auto x) { return inversesqrt(x); },
        [](auto, auto v, auto d) {
          return countedWhere(gt(v, least), d, -0.5 * (v * v) * (v * d));
        }),
    row(
        "exp", call("exp($0)"), everywhere, [](auto x) { return exp(x); },
        [](auto, auto v, auto d) { return countedWhere(gt(v, least), d, v * d); }),
    row(
        "exp2", call("exp2($0)"), everywhere, [](auto x) { return exp2(x); },
        [](auto, auto v, auto d) { return countedWhere(gt(v, least), d, v * ln2 * d); }),
    row(
        "log", call("log($0)"), {positive}, [](auto x) { return log(x); },
        [](auto x, auto) { return 1.0 / x; }),
    row(
        "log2", call("log2($0)"), {positive}, [](auto x) { return log2(x); },
        [](auto x, auto) { return (1 / ln2) / x; }),

    // trigonometry, in radians
    row(
        "sin", call("sin($0)"), everywhere, [](auto x) { return sin(x); },
        [](auto x, auto) { return cos(x); }),
    row(
        "cos", call("cos($0)"), everywhere, [](auto x) { return cos(x); },
        [](auto x, auto) { return -sin(x); }),
    row(
        "tan", call("tan($0)"), {belowRightAngle}, [](auto x) { return tan(x); },
        [](auto, auto v) { return v * v + 1.0; }),
    row(
        "asin", call("asin($0)"), {unitInterval}, [](auto x) { return asin(x); },
        [](auto x, auto) { return inversesqrtOrZero((1.0 - x) * (x + 1.0)); }),
    row(
        "acos", call("acos($0)"), {unitInterval}, [](auto x) { return acos(x); },
        [](auto x, auto) { return -inversesqrtOrZero((1.0 - x) * (x + 1.0)); }),
    row(
        "atan", call("atan($0)"), everywhere, [](auto x) { return atan(x); },
        [](auto x, auto, auto d) { return countedWhere(lt(abs(x), most), d, d / (x * x + 1.0)); }),
    row(
        "atan2", call("atan($0, $1)").with(Wgsl, "atan2($0, $1)"), everywhere,
        [](auto y, auto x) { return atan2(y, x); },
        [](auto y, auto x, auto, auto d) { return turn(x, y, d); },
        [](auto y, auto x, auto, auto d) { return -turn(y, x, d); }),

    // hyperbolic functions
    row(
        "sinh", call("sinh($0)").missingIn(Glsl100), everywhere, [](auto x) { return sinh(x); },
        [](auto x, auto) { return cosh(x); })
        .loweredTo([](auto x) { return 0.5 * (exp(x) - exp(-x)); }),
    row(
        "cosh", call("cosh($0)").missingIn(Glsl100), everywhere, [](auto x) { return cosh(x); },
        [](auto x, auto) { return sinh(x); })
        .loweredTo([](auto x) { return 0.5 * (exp(x) + exp(-x)); }),
    row(
        "tanh", nowhere, everywhere, [](auto x) { return tanh(x); },
        [](auto x, auto, auto d) {
          // Not 1 - v², of which float32 has nothing left from x = 9 on.
          const auto shrink = exp(-2.0 * abs(x)),
                     slope = 4.0 * shrink / ((shrink + 1.0) * (shrink + 1.0));
          return countedWhere(gt(shrink, least), d, slope * d);
        })
        .loweredTo([](auto x) {
          // At most 1, where the exp(2x) of built-in ones is infinite and the result not a number.
          const auto shrink = exp(-2.0 * abs(x));
          return sign(x) * (1.0 - shrink) / (1.0 + shrink);
        }),
    row(
        "asinh", nowhere, everywhere, [](auto x) { return asinh(x); },
        [](auto x, auto) { return inversesqrt(x * x + 1.0); })
        .loweredTo([](auto x) {
          // By |x|, since built-in ones cancel far below zero: -88 for asinh(-10000), which is
          // -9.9.
          return sign(x) * log(abs(x) + sqrt(x * x + 1.0));
        }),
    row(
        "acosh", call("acosh($0)").missingIn(Glsl100), {aboveOne}, [](auto x) { return acosh(x); },
        [](auto x, auto) {
          return ifElse(gt(x, 1.0), inversesqrt(x - 1.0) * inversesqrt(x + 1.0), 0.0);
        })
        .loweredTo([](auto x) { return log(x + sqrt(x * x - 1.0)); }),
    row(
        "atanh", call("atanh($0)").missingIn(Glsl100), {unitInterval},
        [](auto x) { return atanh(x); }, [](auto x, auto) { return 1.0 / ((1.0 - x) * (x + 1.0)); })
        .loweredTo([](auto x) { return 0.5 * log((1.0 + x) / (1.0 - x)); }),

    // pieces
    row(
        "abs", call("abs($0)"), everywhere, [](auto x) { return abs(x); },
        [](auto x, auto) { return sign(x); }),
    row("sign", call("sign($0)"), everywhere, [](auto x) { return sign(x); }),
    row("floor", call("floor($0)"), everywhere, [](auto x) { return floor(x); }),
    row("ceil", call("ceil($0)"), everywhere, [](auto x) { return ceil(x); }),
    row("round", call("roundEven($0)").missingIn(Glsl100).with(Wgsl, "round($0)"), everywhere,
        [](auto x) { return round(x); })
        .loweredTo([](auto x) {
          const auto below = floor(x), rest = x - below;
          const auto tie = mod(below, 2.0);
          return below + ifElse(eq(rest, 0.5), tie, step(0.5, rest));
        }),
    row("trunc", call("trunc($0)").missingIn(Glsl100), everywhere, [](auto x) { return trunc(x); })
        .loweredTo([](auto x) { return sign(x) * floor(abs(x)); }),
    row(
        "fract", call("fract($0)"), everywhere, [](auto x) { return fract(x); }, one),
    row(
        "mod", call("mod($0, $1)", secondOperand).missingIn(Wgsl), {anywhere, positive, {}},
        [](auto x, auto y) { return mod(x, y); }, one,
        [](auto x, auto y, auto) { return -floor(x / y); })
        .loweredTo([](auto x, auto y) { return x - y * floor(x / y); }),
    row(
        "min", call("min($0, $1)", secondOperand).with(Wgsl, "min($0, $1)"), everywhere,
        [](auto x, auto y) { return min(x, y); },
        [](auto x, auto y, auto) { return ifElse(lt(y, x), 0.0, 1.0); },
        [](auto x, auto y, auto) { return ifElse(lt(y, x), 1.0, 0.0); }),
    row(
        "max", call("max($0, $1)", secondOperand).with(Wgsl, "max($0, $1)"), everywhere,
        [](auto x, auto y) { return max(x, y); },
        [](auto x, auto y, auto) { return ifElse(lt(x, y), 0.0, 1.0); },
        [](auto x, auto y, auto) { return ifElse(lt(x, y), 1.0, 0.0); }),
    row(
        "clamp",
        call("clamp($0, $1, $2)", secondOperand | thirdOperand).with(Wgsl, "clamp($0, $1, $2)"),
        {anywhere, negative, positive},
        [](auto x, auto low, auto high) { return min(max(x, low), high); },
        [](auto x, auto low, auto high, auto) {
          return ifElse(logicalOr(lt(x, low), gt(x, high)), 0.0, 1.0);
        },
        [](auto x, auto low, auto high, auto) {
          return ifElse(logicalAnd(lt(x, low), le(low, high)), 1.0, 0.0);
        },
        [](auto x, auto low, auto high, auto) { return ifElse(gt(max(x, low), high), 1.0, 0.0); }),
    row(
        "mix", call("mix($0, $1, $2)", thirdOperand), everywhere,
        [](auto x, auto y, auto t) { return mix(x, y, t); },
        [](auto, auto, auto t, auto) { return 1.0 - t; },  //
        [](auto, auto, auto t, auto) { return t; },
        [](auto x, auto y, auto, auto) { return y - x; }),
    row("step", call("step($0, $1)", firstOperand).with(Wgsl, "step($0, $1)"), everywhere,
        [](auto edge, auto x) { return step(edge, x); }),

    // conditions
    row("lt", infix("$0 < $1", Relational), everywhere, [](auto x, auto y) { return lt(x, y); }),
    row("le", infix("$0 <= $1", Relational), everywhere, [](auto x, auto y) { return le(x, y); }),
    row("gt", infix("$0 > $1", Relational), everywhere, [](auto x, auto y) { return gt(x, y); }),
    row("ge", infix("$0 >= $1", Relational), everywhere, [](auto x, auto y) { return ge(x, y); }),
    row("eq", infix("$0 == $1", Equality), everywhere, [](auto x, auto y) { return eq(x, y); }),
    row("ne", infix("$0 != $1", Equality), everywhere, [](auto x, auto y) { return ne(x, y); }),
    row("and", logical("$0 && $1"), everywhere, [](auto x, auto y) { return logicalAnd(x, y); }),
    row("or", logical("$0 || $1"), everywhere, [](auto x, auto y) { return logicalOr(x, y); }),
    row("not", logicalNegation, everywhere, [](auto x) { return logicalNot(x); }),
    row(
        "ifElse", conditional, everywhere,
        [](auto condition, auto yes, auto no) { return ifElse(condition, yes, no); }, zero,
        [](auto condition, auto, auto, auto) { return ifElse(condition, 1.0, 0.0); },
        [](auto condition, auto, auto, auto) { return ifElse(condition, 0.0, 1.0); }),

    // noise
    row("hash", call("warpjetHash($0, $1)"), {positive, anywhere, {}},
        [](auto h, auto i) { return hash(h, i); })
        .helpedBy(hashHelpers),

    // conversions, inserted where a condition is used as a number or a number as a condition
    row("float", call("float($0)").with(Wgsl, "f32($0)"), everywhere,
        [](auto x) { return ifElse(x, 1.0, 0.0); }),
    row("bool", call("bool($0)"), everywhere, [](auto x) { return ne(x, 0.0); }),

    // whole numbers; with `bits` they are taken to have no sign
    row("int", call("int($0)").with(Wgsl, "i32($0)"), everywhere,
        [](auto x) { return truncated(x); }),
    row("bitsOf", call("int(uint($0))").with(Wgsl, "i32(u32($0))").missingIn(Glsl100), everywhere,
        [](double x) { return truncatedBits(x); }),
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
        [](auto x, auto y) { return wholeSum(x, y); }),
    row("intSub", infix("$0 - $1", Additive), everywhere,
        [](double x, double y) { return wholeDifference(x, y); }),
    row("intMult", infix("$0 * $1", Multiplicative), everywhere,
        [](double x, double y) { return wholeProduct(x, y); }),
    row("intDiv", infix("$0 / $1", Multiplicative), everywhere,
        [](double x, double y) { return wholeQuotient(x, y); }),
    row("intMod", infix("$0 % $1", Multiplicative).missingIn(Glsl100), everywhere,
        [](auto x, auto y) { return wholeRemainder(x, y); })
        .loweredTo([](auto x, auto y) {
          return wholeDifference(x, wholeProduct(wholeQuotient(x, y), y));
        }),
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
