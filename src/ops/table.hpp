// THE table: one row an operation. A row gives name, operands and meaning for people, then types,
// spelling, the domain on which tests sample it, value, and one partial derivative an operand; `v`
// is the operation's own result, so that exp, sqrt or tan can share it. A row that a language lacks
// also says how it is lowered to others, and what other rooms ask of it are its traits.
//
// A new row needs nothing but itself: a value that takes `double` runs everywhere. One that takes
// any scalar runs four vertices at a time and has narrow bounds; what it calls must then be in
// scalar.hpp, in interval.hpp and among the lanes of src/eval. tests/cpp/own_row adds such rows and
// sees what becomes of them. What a formula here calls must be in graph/expression.hpp.
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
using enum Trait;

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
    unary(
        {"neg", "x", "-x"}, floats, negation, everywhere, [](auto x) { return -x; }, minusOne)
        .with(OnMatrices),
    binary(
        {"add", "x, y", "The sum of two or more."}, floats, infix("$0 + $1", Additive), everywhere,
        [](auto x, auto y) { return x + y; }, one, one)
        .with(Chained, OnMatrices, Commutative),
    binary(
        {"sub", "x, y", "x - y, and minus all that follow."}, floats, infix("$0 - $1", Additive),
        everywhere, [](auto x, auto y) { return x - y; }, one, minusOne)
        .with(Chained, OnMatrices),
    binary(
        {"mult", "x, y", "The product of two or more; with a matrix, that of linear algebra."},
        floats, infix("$0 * $1", Multiplicative), everywhere,
        [](auto x, auto y) { return x * y; },  //
        [](auto, auto y, auto) { return y; },  //
        [](auto x, auto, auto) { return x; })
        .with(Chained, OnMatrices, Commutative),
    binary(
        {"div", "x, y", "x / y, and divided by all that follow."}, floats,
        infix("$0 / $1", Multiplicative), {anywhere, positive, {}},
        [](auto x, auto y) { return x / y; },        //
        [](auto, auto y, auto) { return 1.0 / y; },  //
        [](auto, auto y, auto v, auto d) {
          // A quotient may be 0 by its numerator, and turns there; sinh / cosh has huge parts that
          // count.
          return countedWhere(logicalOr(lt(abs(y), 1 / least), gt(abs(v), least)), d, -(v * d) / y);
        })
        .with(Chained, OnMatrices, Divides),

    // powers
    binary(
        {"pow", "x, exponent",
         "x to the power of the exponent. A whole number from -16 to 16 makes a product, right for "
         "negative x too; with any other exponent, x must not be negative."},
        floats, call("pow($0, $1)"), {positive, anywhere, {}},
        [](auto x, auto y) { return pow(x, y); },
        [](auto x, auto y, auto v, auto d) {
          const auto slope = ifElse(gt(x, 0.0), y * pow(x, y - 1.0), 0.0);
          return countedWhere(gt(v, least), d, slope * d);
        },
        [](auto x, auto, auto v, auto d) {
          const auto term = countedWhere(gt(v, least), d, v * (log(x) * d));
          return ifElse(gt(x, 0.0), countedWhere(gt(v, least), x, term), 0.0);
        }),
    unary(
        {"sqrt", "x", "The square root; its derivative at 0 counts as 0."}, floats,
        call("sqrt($0)"), {positive}, [](auto x) { return sqrt(x); },
        [](auto x, auto v) { return ifElse(gt(x, 0.0), 0.5 / v, 0.0); }),
    unary(
        {"inversesqrt", "x", "1 / sqrt(x)"}, floats,
        call("inversesqrt($0)").with(Wgsl, "inverseSqrt($0)"), {positive},
        [](auto x) { return inversesqrt(x); },
        [](auto, auto v, auto d) {
          return countedWhere(gt(v, least), d, -0.5 * (v * v) * (v * d));
        }),
    unary(
        {"exp", "x", "e to the power of x."}, floats, call("exp($0)"), everywhere,
        [](auto x) { return exp(x); },
        [](auto, auto v, auto d) { return countedWhere(gt(v, least), d, v * d); }),
    unary(
        {"exp2", "x", "2 to the power of x."}, floats, call("exp2($0)"), everywhere,
        [](auto x) { return exp2(x); },
        [](auto, auto v, auto d) { return countedWhere(gt(v, least), d, v * ln2 * d); }),
    unary(
        {"log", "x", "The natural logarithm, of what is greater than 0."}, floats, call("log($0)"),
        {positive}, [](auto x) { return log(x); }, [](auto x, auto) { return 1.0 / x; }),
    unary(
        {"log2", "x", "The logarithm to base 2, of what is greater than 0."}, floats,
        call("log2($0)"), {positive}, [](auto x) { return log2(x); },
        [](auto x, auto) { return (1 / ln2) / x; }),

    // trigonometry, in radians
    unary(
        {"sin", "x", "The sine of an angle in radians."}, floats, call("sin($0)"), everywhere,
        [](auto x) { return sin(x); }, [](auto x, auto) { return cos(x); }),
    unary(
        {"cos", "x", "The cosine of an angle in radians."}, floats, call("cos($0)"), everywhere,
        [](auto x) { return cos(x); }, [](auto x, auto) { return -sin(x); }),
    unary(
        {"tan", "x", "The tangent of an angle in radians."}, floats, call("tan($0)"),
        {belowRightAngle}, [](auto x) { return tan(x); }, [](auto, auto v) { return v * v + 1.0; }),
    unary(
        {"asin", "x", "The angle from -π/2 to π/2 whose sine is x, which is from -1 to 1."}, floats,
        call("asin($0)"), {unitInterval}, [](auto x) { return asin(x); },
        [](auto x, auto) { return inversesqrtOrZero((1.0 - x) * (x + 1.0)); }),
    unary(
        {"acos", "x", "The angle from 0 to π whose cosine is x, which is from -1 to 1."}, floats,
        call("acos($0)"), {unitInterval}, [](auto x) { return acos(x); },
        [](auto x, auto) { return -inversesqrtOrZero((1.0 - x) * (x + 1.0)); }),
    unary(
        {"atan", "x", "The angle from -π/2 to π/2 whose tangent is x."}, floats, call("atan($0)"),
        everywhere, [](auto x) { return atan(x); },
        [](auto x, auto, auto d) { return countedWhere(lt(abs(x), most), d, d / (x * x + 1.0)); }),
    binary(
        {"atan2", "y, x", "The angle of the point (x, y), from -π to π."}, floats,
        call("atan($0, $1)").with(Wgsl, "atan2($0, $1)"), everywhere,
        [](auto y, auto x) { return atan2(y, x); },
        [](auto y, auto x, auto, auto d) { return turn(x, y, d); },
        [](auto y, auto x, auto, auto d) { return -turn(y, x, d); })
        .with(Hidden),

    // hyperbolic functions
    unary(
        {"sinh", "x", "The hyperbolic sine."}, floats, call("sinh($0)").missingIn(Glsl100),
        everywhere, [](auto x) { return sinh(x); }, [](auto x, auto) { return cosh(x); })
        .loweredTo([](auto x) { return 0.5 * (exp(x) - exp(-x)); }),
    unary(
        {"cosh", "x", "The hyperbolic cosine."}, floats, call("cosh($0)").missingIn(Glsl100),
        everywhere, [](auto x) { return cosh(x); }, [](auto x, auto) { return sinh(x); })
        .loweredTo([](auto x) { return 0.5 * (exp(x) + exp(-x)); }),
    unary(
        {"tanh", "x", "The hyperbolic tangent, between -1 and 1."}, floats, nowhere, everywhere,
        [](auto x) { return tanh(x); },
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
    unary(
        {"asinh", "x", "The number whose hyperbolic sine is x."}, floats, nowhere, everywhere,
        [](auto x) { return asinh(x); }, [](auto x, auto) { return inversesqrt(x * x + 1.0); })
        .loweredTo([](auto x) {
          // By |x|, since built-in ones cancel far below zero: -88 for asinh(-10000), which is
          // -9.9.
          return sign(x) * log(abs(x) + sqrt(x * x + 1.0));
        }),
    unary(
        {"acosh", "x", "The number from 0 up whose hyperbolic cosine is x, which is at least 1."},
        floats, call("acosh($0)").missingIn(Glsl100), {aboveOne}, [](auto x) { return acosh(x); },
        [](auto x, auto) {
          return ifElse(gt(x, 1.0), inversesqrt(x - 1.0) * inversesqrt(x + 1.0), 0.0);
        })
        .loweredTo([](auto x) { return log(x + sqrt(x * x - 1.0)); }),
    unary(
        {"atanh", "x", "The number whose hyperbolic tangent is x, which is between -1 and 1."},
        floats, call("atanh($0)").missingIn(Glsl100), {unitInterval},
        [](auto x) { return atanh(x); }, [](auto x, auto) { return 1.0 / ((1.0 - x) * (x + 1.0)); })
        .loweredTo([](auto x) { return 0.5 * log((1.0 + x) / (1.0 - x)); }),

    // pieces
    unary(
        {"abs", "x", "x without its sign."}, floats, call("abs($0)"), everywhere,
        [](auto x) { return abs(x); }, [](auto x, auto) { return sign(x); }),
    unary({"sign", "x", "-1, 0 or 1."}, floats, call("sign($0)"), everywhere,
          [](auto x) { return sign(x); }),
    unary({"floor", "x", "The whole number at or below x."}, floats, call("floor($0)"), everywhere,
          [](auto x) { return floor(x); }),
    unary({"ceil", "x", "The whole number at or above x."}, floats, call("ceil($0)"), everywhere,
          [](auto x) { return ceil(x); }),
    unary({"round", "x",
           "The nearest whole number; a half goes to the even one: round(0.5) is 0, round(1.5) 2."},
          floats, call("roundEven($0)").missingIn(Glsl100).with(Wgsl, "round($0)"), everywhere,
          [](auto x) { return round(x); })
        .loweredTo([](auto x) {
          const auto below = floor(x), rest = x - below;
          const auto tie = mod(below, 2.0);
          return below + ifElse(eq(rest, 0.5), tie, step(0.5, rest));
        }),
    unary({"trunc", "x", "x without what follows its point."}, floats,
          call("trunc($0)").missingIn(Glsl100), everywhere, [](auto x) { return trunc(x); })
        .loweredTo([](auto x) { return sign(x) * floor(abs(x)); }),
    unary(
        {"fract", "x", "x - floor(x)"}, floats, call("fract($0)"), everywhere,
        [](auto x) { return fract(x); }, one),
    binary(
        {"mod", "x, divisor",
         "x - divisor * floor(x / divisor), which has the sign of the divisor."},
        floats, call("mod($0, $1)", secondOperand).missingIn(Wgsl), {anywhere, positive, {}},
        [](auto x, auto y) { return mod(x, y); }, one,
        [](auto x, auto y, auto) { return -floor(x / y); })
        .with(Divides)
        .loweredTo([](auto x, auto y) { return x - y * floor(x / y); }),
    binary(
        {"min", "x, y", "The least of two or more."}, floats,
        call("min($0, $1)", secondOperand).with(Wgsl, "min($0, $1)"), everywhere,
        [](auto x, auto y) { return min(x, y); },
        [](auto x, auto y, auto) { return ifElse(lt(y, x), 0.0, 1.0); },
        [](auto x, auto y, auto) { return ifElse(lt(y, x), 1.0, 0.0); })
        .with(Chained, Branches),
    binary(
        {"max", "x, y", "The greatest of two or more."}, floats,
        call("max($0, $1)", secondOperand).with(Wgsl, "max($0, $1)"), everywhere,
        [](auto x, auto y) { return max(x, y); },
        [](auto x, auto y, auto) { return ifElse(lt(x, y), 0.0, 1.0); },
        [](auto x, auto y, auto) { return ifElse(lt(x, y), 1.0, 0.0); })
        .with(Chained, Branches),
    ternary(
        {"clamp", "x, low, high", "x, but not below low nor above high."}, floats,
        call("clamp($0, $1, $2)", secondOperand | thirdOperand).with(Wgsl, "clamp($0, $1, $2)"),
        {anywhere, negative, positive},
        [](auto x, auto low, auto high) { return min(max(x, low), high); },
        [](auto x, auto low, auto high, auto) {
          return ifElse(logicalOr(lt(x, low), gt(x, high)), 0.0, 1.0);
        },
        [](auto x, auto low, auto high, auto) {
          return ifElse(logicalAnd(lt(x, low), le(low, high)), 1.0, 0.0);
        },
        [](auto x, auto low, auto high, auto) { return ifElse(gt(max(x, low), high), 1.0, 0.0); })
        .with(Branches),
    ternary(
        {"mix", "x, y, amount", "From x where the amount is 0 to y where it is 1, and beyond."},
        floats, call("mix($0, $1, $2)", thirdOperand), everywhere,
        [](auto x, auto y, auto t) { return mix(x, y, t); },
        [](auto, auto, auto t, auto) { return 1.0 - t; },  //
        [](auto, auto, auto t, auto) { return t; },
        [](auto x, auto y, auto, auto) { return y - x; })
        .with(OnMatrices),
    binary({"step", "edge, x", "0 where x is below the edge, otherwise 1."}, floats,
           call("step($0, $1)", firstOperand).with(Wgsl, "step($0, $1)"), everywhere,
           [](auto edge, auto x) { return step(edge, x); }),

    // conditions
    binary({"lt", "x, y", "x < y"}, comparison, infix("$0 < $1", Relational), everywhere,
           [](auto x, auto y) { return lt(x, y); }),
    binary({"le", "x, y", "x <= y"}, comparison, infix("$0 <= $1", Relational), everywhere,
           [](auto x, auto y) { return le(x, y); }),
    binary({"gt", "x, y", "x > y"}, comparison, infix("$0 > $1", Relational), everywhere,
           [](auto x, auto y) { return gt(x, y); }),
    binary({"ge", "x, y", "x >= y"}, comparison, infix("$0 >= $1", Relational), everywhere,
           [](auto x, auto y) { return ge(x, y); }),
    binary({"eq", "x, y", "x == y"}, comparison, infix("$0 == $1", Equality), everywhere,
           [](auto x, auto y) { return eq(x, y); }),
    binary({"ne", "x, y", "x != y"}, comparison, infix("$0 != $1", Equality), everywhere,
           [](auto x, auto y) { return ne(x, y); }),
    binary({"and", "x, y", "Whether all are true."}, logic, logical("$0 && $1"), everywhere,
           [](auto x, auto y) { return logicalAnd(x, y); })
        .with(Chained),
    binary({"or", "x, y", "Whether any is true."}, logic, logical("$0 || $1"), everywhere,
           [](auto x, auto y) { return logicalOr(x, y); })
        .with(Chained),
    unary({"not", "x", "Whether x is false."}, logic, logicalNegation, everywhere,
          [](auto x) { return logicalNot(x); }),
    ternary(
        {"ifElse", "condition, yes, no",
         "One of two values; a number other than 0 counts as true."},
        choice, conditional, everywhere,
        [](auto condition, auto yes, auto no) { return ifElse(condition, yes, no); }, zero,
        [](auto condition, auto, auto, auto) { return ifElse(condition, 1.0, 0.0); },
        [](auto condition, auto, auto, auto) { return ifElse(condition, 0.0, 1.0); })
        .with(OnMatrices, Branches),

    // noise
    binary({"hash", "h, i", "A whole number from 0 to 4090 that looks random."}, floats,
           call("warpjetHash($0, $1)"), {positive, anywhere, {}},
           [](auto h, auto i) { return hash(h, i); })
        .with(Hidden)
        .helpedBy(hashHelpers),

    // conversions, inserted where a condition is used as a number or a number as a condition
    unary({"float", "x", "1 or 0."}, toFloat, call("float($0)").with(Wgsl, "f32($0)"), everywhere,
          [](auto x) { return ifElse(x, 1.0, 0.0); })
        .with(Hidden),
    unary({"bool", "x", "Whether x is not 0."}, toBool, call("bool($0)"), everywhere,
          [](auto x) { return ne(x, 0.0); })
        .with(Hidden),

    // whole numbers; with `bits` they are taken to have no sign
    unary({"int", "x", "x without what follows its point."}, toWhole,
          call("int($0)").with(Wgsl, "i32($0)"), everywhere, [](auto x) { return truncated(x); })
        .with(ForText),
    unary({"bitsOf", "x", "The same of what is not negative."}, toWhole,
          call("int(uint($0))").with(Wgsl, "i32(u32($0))").missingIn(Glsl100), everywhere,
          [](double x) { return truncatedBits(x); })
        .with(ForText),
    unary({"intToFloat", "x", "x as a float."}, wholeToFloat,
          call("float($0)").with(Wgsl, "f32($0)"), everywhere, [](auto x) { return asFloat(x); })
        .with(ForText),
    unary({"bitsToFloat", "x", "x as a float."}, wholeToFloat,
          call("float(uint($0))").with(Wgsl, "f32(u32($0))").missingIn(Glsl100), everywhere,
          [](auto x) { return bitsAsFloat(x); })
        .with(ForText),
    unary({"floatBitsToInt", "x", "The bits of a float."}, toWhole,
          call("floatBitsToInt($0)").with(Wgsl, "bitcast<i32>($0)").missingIn(Glsl100), everywhere,
          [](double x) { return floatBits(x); })
        .with(ForText),
    unary({"intBitsToFloat", "x", "The float of these bits."}, wholeToFloat,
          call("intBitsToFloat($0)").with(Wgsl, "bitcast<f32>($0)").missingIn(Glsl100), everywhere,
          [](double x) { return floatOfBits(x); })
        .with(ForText),
    binary({"intAdd", "x, y", "x + y"}, wholes, infix("$0 + $1", Additive), everywhere,
           [](auto x, auto y) { return wholeSum(x, y); })
        .with(ForText, Commutative),
    binary({"intSub", "x, y", "x - y"}, wholes, infix("$0 - $1", Additive), everywhere,
           [](double x, double y) { return wholeDifference(x, y); })
        .with(ForText),
    binary({"intMult", "x, y", "x * y"}, wholes, infix("$0 * $1", Multiplicative), everywhere,
           [](double x, double y) { return wholeProduct(x, y); })
        .with(ForText, Commutative),
    binary({"intDiv", "x, y", "x / y, towards 0"}, wholes, infix("$0 / $1", Multiplicative),
           everywhere, [](double x, double y) { return wholeQuotient(x, y); })
        .with(ForText),
    binary({"intMod", "x, y", "What that leaves."}, wholes,
           infix("$0 % $1", Multiplicative).missingIn(Glsl100), everywhere,
           [](auto x, auto y) { return wholeRemainder(x, y); })
        .with(ForText)
        .loweredTo([](auto x, auto y) {
          return wholeDifference(x, wholeProduct(wholeQuotient(x, y), y));
        }),
    binary({"bitsDiv", "x, y", "x / y"}, wholes,
           call("int(uint($0) / uint($1))").with(Wgsl, "i32(u32($0) / u32($1))").missingIn(Glsl100),
           everywhere, [](double x, double y) { return bitsQuotient(x, y); })
        .with(ForText),
    binary({"bitsMod", "x, y", "What that leaves."}, wholes,
           call("int(uint($0) % uint($1))").with(Wgsl, "i32(u32($0) % u32($1))").missingIn(Glsl100),
           everywhere, [](double x, double y) { return bitsRemainder(x, y); })
        .with(ForText),
    binary({"bitAnd", "x, y", "Bits that both have."}, wholes, bits("$0 & $1").missingIn(Glsl100),
           everywhere, [](auto x, auto y) { return bitAnd(x, y); })
        .with(ForText, Commutative),
    binary({"bitOr", "x, y", "Bits that either has."}, wholes, bits("$0 | $1").missingIn(Glsl100),
           everywhere, [](double x, double y) { return bitOr(x, y); })
        .with(ForText, Commutative),
    binary({"bitXor", "x, y", "Bits that one of both has."}, wholes,
           bits("$0 ^ $1").missingIn(Glsl100), everywhere,
           [](double x, double y) { return bitXor(x, y); })
        .with(ForText, Commutative),
    unary({"bitNot", "x", "Bits that x has not."}, wholes,
          Spellings(Spelling{"~$0", Unary, {Unary, {}, {}}}).missingIn(Glsl100), everywhere,
          [](double x) { return bitNot(x); })
        .with(ForText),
    binary({"shiftLeft", "x, count", "x with its bits that many places further up."}, wholes,
           bits("$0 << $1").withText(Wgsl, "$0 << u32($1)").missingIn(Glsl100), everywhere,
           [](double x, double y) { return shiftLeft(x, y); })
        .with(ForText),
    binary({"shiftRight", "x, count", "x with its bits down, the sign where they come from."},
           wholes, bits("$0 >> $1").withText(Wgsl, "$0 >> u32($1)").missingIn(Glsl100), everywhere,
           [](double x, double y) { return shiftRight(x, y); })
        .with(ForText),
    binary({"bitsShiftRight", "x, count", "x with its bits down, zeros where they come from."},
           wholes,
           call("int(uint($0) >> $1)").with(Wgsl, "i32(u32($0) >> u32($1))").missingIn(Glsl100),
           everywhere, [](auto x, auto y) { return bitsShiftRight(x, y); })
        .with(ForText),
    binary({"intLt", "x, y", "x < y"}, wholeComparison, infix("$0 < $1", Relational), everywhere,
           [](double x, double y) { return lt(x, y); })
        .with(ForText),
    binary({"bitsLt", "x, y", "x < y"}, wholeComparison,
           Spellings(Spelling{"uint($0) < uint($1)", Relational})
               .withText(Wgsl, "u32($0) < u32($1)")
               .missingIn(Glsl100),
           everywhere, [](double x, double y) { return bitsOf(x) < bitsOf(y); })
        .with(ForText),
    binary({"intEq", "x, y", "x == y"}, wholeComparison, infix("$0 == $1", Equality), everywhere,
           [](double x, double y) { return eq(x, y); })
        .with(ForText),
    ternary({"intIfElse", "condition, yes, no", "One of two."}, wholeChoice, conditional,
            everywhere,
            [](auto condition, auto yes, auto no) { return ifElse(condition, yes, no); })
        .with(ForText, Branches),
};

}  // namespace warpjet::ops
