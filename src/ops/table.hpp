// THE table: one row per operation, in the order of declarations.hpp, which has the types and
// traits. A row gives spelling, the domain on which tests sample it, value, and one partial
// derivative per operand; `v` is the operation's own result, so that exp, sqrt or tan can share it.
// A row that a language lacks also says how it is lowered to other operations.
//
// A new row only needs its declaration: a value that takes `double` runs everywhere. A value that
// takes any scalar type runs four vertices at a time and has narrow bounds; the functions it calls
// must then be in scalar.hpp, in interval.hpp and among the lanes of src/eval. tests/cpp/own_row
// adds such rows and tests them. The functions that partials and lowered formulas call must be in
// graph/expression.hpp.
//
// Kinks: d|x| = sign(x). floor, ceil, round, trunc, sign, step and comparisons have derivative 0;
// fract has 1; mod(x, y) has 1 with respect to x and -floor(x/y) with respect to y. min, max, clamp
// and ifElse have the derivative of the branch that the value takes, min and max of the first of
// equal operands, and clamp(x, low, high) is min(max(x, low), high) even if low > high. On and
// outside the boundary of its domain an operation has derivative 0 instead of infinity or 0/0:
// sqrt(0), pow(x, y) for x <= 0 (integer powers are products and never reach this row), asin and
// acos of 1 and -1, acosh(1), atan(0, 0). So length, dist and normalize are safe at zero. log,
// inversesqrt, atanh and 1/x are not guarded: where their derivative is infinite, so is the
// position.
//
// Infinities: an operation that is finite for an infinite operand, such as 1/x, exp(-x) or atan(x),
// has derivative 0 there, even if the derivative of the operand is infinite or NaN. Such a row
// takes the operand's derivative `d` as well and returns the product, computed in an order in which
// no intermediate float32 overflows or underflows.
//
// A lone `//` keeps clang-format from joining two lines.
#pragma once

#include <tuple>

#include "ops/hash_source.hpp"
#include "ops/int_rows.hpp"
#include "ops/partial_formulas.hpp"
#include "ops/row.hpp"
#include "ops/scalar.hpp"

namespace warpjet::ops {

using enum Precedence;
using enum Language;

inline constexpr std::tuple floatRows{
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
          // A quotient may be 0 because its numerator is, and change sign there; in sinh / cosh,
          // huge terms cancel and still matter.
          return maskTerm(logicalOr(lt(abs(y), 1 / minFactor), gt(abs(v), minFactor)), d,
                          -(v * d) / y);
        }),

    // powers
    row(
        "pow", call("pow($0, $1)"), {positive, anywhere, {}},
        [](auto x, auto y) { return pow(x, y); },
        [](auto x, auto y, auto v, auto d) {
          const auto slope = ifElse(gt(x, 0.0), y * pow(x, y - 1.0), 0.0);
          return maskTerm(gt(v, minFactor), d, slope * d);
        },
        [](auto x, auto, auto v, auto d) {
          const auto term = maskTerm(gt(v, minFactor), d, v * (log(x) * d));
          return ifElse(gt(x, 0.0), maskTerm(gt(v, minFactor), x, term), 0.0);
        }),
    row(
        "sqrt", call("sqrt($0)"), {positive}, [](auto x) { return sqrt(x); },
        [](auto x, auto v) { return ifElse(gt(x, 0.0), 0.5 / v, 0.0); }),
    row(
        "inversesqrt", call("inversesqrt($0)").with(Wgsl, "inverseSqrt($0)"), {positive},
        [](auto x) { return inversesqrt(x); },
        [](auto, auto v, auto d) {
          return maskTerm(gt(v, minFactor), d, -0.5 * (v * v) * (v * d));
        }),
    row(
        "exp", call("exp($0)"), everywhere, [](auto x) { return exp(x); },
        [](auto, auto v, auto d) { return maskTerm(gt(v, minFactor), d, v * d); }),
    row(
        "exp2", call("exp2($0)"), everywhere, [](auto x) { return exp2(x); },
        [](auto, auto v, auto d) { return maskTerm(gt(v, minFactor), d, v * ln2 * d); }),
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
        [](auto x, auto, auto d) {
          return maskTerm(lt(abs(x), maxDivisor), d, d / (x * x + 1.0));
        }),
    row(
        "atan2", call("atan($0, $1)").with(Wgsl, "atan2($0, $1)"), everywhere,
        [](auto y, auto x) { return atan2(y, x); },
        [](auto y, auto x, auto, auto d) { return angleSlope(x, y, d); },
        [](auto y, auto x, auto, auto d) { return -angleSlope(y, x, d); }),

    // hyperbolic functions
    row(
        "sinh", call("sinh($0)").missingIn(Glsl100), everywhere, [](auto x) { return sinh(x); },
        [](auto x, auto) { return cosh(x); })
        .lowersTo([](auto x) { return 0.5 * (exp(x) - exp(-x)); }),
    row(
        "cosh", call("cosh($0)").missingIn(Glsl100), everywhere, [](auto x) { return cosh(x); },
        [](auto x, auto) { return sinh(x); })
        .lowersTo([](auto x) { return 0.5 * (exp(x) + exp(-x)); }),
    row(
        "tanh", nowhere, everywhere, [](auto x) { return tanh(x); },
        [](auto x, auto, auto d) {
          // Not 1 - v², which float32 rounds to zero for x > 9.
          const auto shrink = exp(-2.0 * abs(x)),
                     slope = 4.0 * shrink / ((shrink + 1.0) * (shrink + 1.0));
          return maskTerm(gt(shrink, minFactor), d, slope * d);
        })
        .lowersTo([](auto x) {
          // shrink is at most 1; built-in functions compute exp(2x), which overflows and gives NaN.
          const auto shrink = exp(-2.0 * abs(x));
          return sign(x) * (1.0 - shrink) / (1.0 + shrink);
        }),
    row(
        "asinh", nowhere, everywhere, [](auto x) { return asinh(x); },
        [](auto x, auto) { return inversesqrt(x * x + 1.0); })
        .lowersTo([](auto x) {
          // Uses |x|, since built-in functions lose all digits for large negative x: they give -88
          // for asinh(-10000), which is -9.9.
          return sign(x) * log(abs(x) + sqrt(x * x + 1.0));
        }),
    row(
        "acosh", call("acosh($0)").missingIn(Glsl100), {aboveOne}, [](auto x) { return acosh(x); },
        [](auto x, auto) {
          return ifElse(gt(x, 1.0), inversesqrt(x - 1.0) * inversesqrt(x + 1.0), 0.0);
        })
        .lowersTo([](auto x) { return log(x + sqrt(x * x - 1.0)); }),
    row(
        "atanh", call("atanh($0)").missingIn(Glsl100), {unitInterval},
        [](auto x) { return atanh(x); }, [](auto x, auto) { return 1.0 / ((1.0 - x) * (x + 1.0)); })
        .lowersTo([](auto x) { return 0.5 * log((1.0 + x) / (1.0 - x)); }),

    // piecewise functions
    row(
        "abs", call("abs($0)"), everywhere, [](auto x) { return abs(x); },
        [](auto x, auto) { return sign(x); }),
    row("sign", call("sign($0)"), everywhere, [](auto x) { return sign(x); }),
    row("floor", call("floor($0)"), everywhere, [](auto x) { return floor(x); }),
    row("ceil", call("ceil($0)"), everywhere, [](auto x) { return ceil(x); }),
    row("round", call("roundEven($0)").missingIn(Glsl100).with(Wgsl, "round($0)"), everywhere,
        [](auto x) { return round(x); })
        .lowersTo([](auto x) {
          const auto below = floor(x), rest = x - below;
          const auto tie = mod(below, 2.0);
          return below + ifElse(eq(rest, 0.5), tie, step(0.5, rest));
        }),
    row("trunc", call("trunc($0)").missingIn(Glsl100), everywhere, [](auto x) { return trunc(x); })
        .lowersTo([](auto x) { return sign(x) * floor(abs(x)); }),
    row(
        "fract", call("fract($0)"), everywhere, [](auto x) { return fract(x); }, one),
    row(
        "mod", call("mod($0, $1)", secondOperand).missingIn(Wgsl), {anywhere, positive, {}},
        [](auto x, auto y) { return mod(x, y); }, one,
        [](auto x, auto y, auto) { return -floor(x / y); })
        .lowersTo([](auto x, auto y) { return x - y * floor(x / y); }),
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
        .withHelpers(hashHelpers),

    // conversions, inserted where a condition is used as a number or vice versa
    row("float", call("float($0)").with(Wgsl, "f32($0)"), everywhere,
        [](auto x) { return ifElse(x, 1.0, 0.0); }),
    row("bool", call("bool($0)"), everywhere, [](auto x) { return ne(x, 0.0); }),
};

inline constexpr auto table = std::tuple_cat(floatRows, intRows);

}  // namespace warpjet::ops
