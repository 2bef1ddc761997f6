// THE table: one row an operation. A row gives name, types, spelling, the domain on which tests
// sample it, value, and one partial derivative an operand; `v` is the operation's own result, so
// that exp, sqrt or tan can share it. A new row needs besides itself only a value function in
// scalar.hpp (if the standard library has none), one in graph/expression.hpp if a formula here
// calls it, and its type in types.ts.
//
// Kinks: d|x| = sign(x). floor, sign, step and comparisons have derivative 0; fract has 1; mod(x,
// y) has 1 by x and -floor(x/y) by y. min, max, clamp and ifElse take the branch that the value
// takes. At and beyond the edge of its domain an operation has derivative 0 instead of infinity or
// 0/0: sqrt(0), pow(x, y) for x <= 0 (whole powers are products and never come here), asin and acos
// of 1 and -1, atan(0, 0). So length, dist and normalize are safe at zero. log, inversesqrt and 1/x
// are not guarded: where they are infinite, so is the position.
//
// A lone `//` keeps clang-format from joining two lines.
#pragma once

#include <tuple>

#include "ops/row.hpp"
#include "ops/scalar.hpp"

namespace warpjet::ops {

inline constexpr auto one = [](auto...) { return 1.0; };
inline constexpr auto minusOne = [](auto...) { return -1.0; };
inline constexpr auto zero = [](auto...) { return 0.0; };

// For derivatives that are infinite at the edge of an operation's domain.
inline constexpr auto divideOrZero = [](auto x, auto y) { return ifElse(gt(y, 0.0), x / y, 0.0); };
inline constexpr auto inversesqrtOrZero = [](auto x) {
  return ifElse(gt(x, 0.0), inversesqrt(x), 0.0);
};

using enum Precedence;

inline constexpr std::tuple table{
    // arithmetic
    unary(
        "neg", floats, negation, everywhere, [](auto x) { return -x; }, minusOne),
    binary(
        "add", floats, infix("$0 + $1", Additive), everywhere, [](auto x, auto y) { return x + y; },
        one, one),
    binary(
        "sub", floats, infix("$0 - $1", Additive), everywhere, [](auto x, auto y) { return x - y; },
        one, minusOne),
    binary(
        "mult", floats, infix("$0 * $1", Multiplicative), everywhere,
        [](auto x, auto y) { return x * y; },  //
        [](auto, auto y, auto) { return y; },  //
        [](auto x, auto, auto) { return x; }),
    binary(
        "div", floats, infix("$0 / $1", Multiplicative), {anywhere, positive, {}},
        [](auto x, auto y) { return x / y; },        //
        [](auto, auto y, auto) { return 1.0 / y; },  //
        [](auto, auto y, auto v) { return -(v / y); }),

    // powers
    binary(
        "pow", floats, call("pow($0, $1)"), {positive, anywhere, {}},
        [](auto x, auto y) { return pow(x, y); },
        [](auto x, auto y, auto) { return ifElse(gt(x, 0.0), y * pow(x, y - 1.0), 0.0); },
        [](auto x, auto, auto v) { return ifElse(gt(x, 0.0), v * log(x), 0.0); }),
    unary(
        "sqrt", floats, call("sqrt($0)"), {positive}, [](auto x) { return sqrt(x); },
        [](auto x, auto v) { return ifElse(gt(x, 0.0), 0.5 / v, 0.0); }),
    unary(
        "inversesqrt", floats, call("inversesqrt($0)"), {positive},
        [](auto x) { return inversesqrt(x); }, [](auto, auto v) { return -0.5 * (v * v * v); }),
    unary(
        "exp", floats, call("exp($0)"), everywhere, [](auto x) { return exp(x); },
        [](auto, auto v) { return v; }),
    unary(
        "log", floats, call("log($0)"), {positive}, [](auto x) { return log(x); },
        [](auto x, auto) { return 1.0 / x; }),

    // trigonometry, in radians
    unary(
        "sin", floats, call("sin($0)"), everywhere, [](auto x) { return sin(x); },
        [](auto x, auto) { return cos(x); }),
    unary(
        "cos", floats, call("cos($0)"), everywhere, [](auto x) { return cos(x); },
        [](auto x, auto) { return -sin(x); }),
    unary(
        "tan", floats, call("tan($0)"), {belowRightAngle}, [](auto x) { return tan(x); },
        [](auto, auto v) { return v * v + 1.0; }),
    unary(
        "asin", floats, call("asin($0)"), {unitInterval}, [](auto x) { return asin(x); },
        [](auto x, auto) { return inversesqrtOrZero(1.0 - x * x); }),
    unary(
        "acos", floats, call("acos($0)"), {unitInterval}, [](auto x) { return acos(x); },
        [](auto x, auto) { return -inversesqrtOrZero(1.0 - x * x); }),
    unary(
        "atan", floats, call("atan($0)"), everywhere, [](auto x) { return atan(x); },
        [](auto x, auto) { return 1.0 / (x * x + 1.0); }),
    binary(
        "atan2", floats, call("atan($0, $1)"), everywhere,
        [](auto y, auto x) { return atan2(y, x); },
        [](auto y, auto x, auto) { return divideOrZero(x, x * x + y * y); },
        [](auto y, auto x, auto) { return -divideOrZero(y, x * x + y * y); }),

    // pieces
    unary(
        "abs", floats, call("abs($0)"), everywhere, [](auto x) { return abs(x); },
        [](auto x, auto) { return sign(x); }),
    unary("sign", floats, call("sign($0)"), everywhere, [](auto x) { return sign(x); }),
    unary("floor", floats, call("floor($0)"), everywhere, [](auto x) { return floor(x); }),
    unary(
        "fract", floats, call("fract($0)"), everywhere, [](auto x) { return fract(x); }, one),
    binary(
        "mod", floats, call("mod($0, $1)"), {anywhere, positive, {}},
        [](auto x, auto y) { return mod(x, y); }, one,
        [](auto x, auto y, auto) { return -floor(x / y); }),
    binary(
        "min", floats, call("min($0, $1)"), everywhere, [](auto x, auto y) { return min(x, y); },
        [](auto x, auto y, auto) { return ifElse(lt(y, x), 0.0, 1.0); },
        [](auto x, auto y, auto) { return ifElse(lt(y, x), 1.0, 0.0); }),
    binary(
        "max", floats, call("max($0, $1)"), everywhere, [](auto x, auto y) { return max(x, y); },
        [](auto x, auto y, auto) { return ifElse(lt(x, y), 0.0, 1.0); },
        [](auto x, auto y, auto) { return ifElse(lt(x, y), 1.0, 0.0); }),
    ternary(
        "clamp", floats, call("clamp($0, $1, $2)"), {anywhere, negative, positive},
        [](auto x, auto low, auto high) { return min(max(x, low), high); },
        [](auto x, auto low, auto high, auto) {
          return ifElse(logicalOr(lt(x, low), gt(x, high)), 0.0, 1.0);
        },
        [](auto x, auto low, auto high, auto) {
          return ifElse(logicalAnd(lt(x, low), le(low, high)), 1.0, 0.0);
        },
        [](auto x, auto low, auto high, auto) { return ifElse(gt(max(x, low), high), 1.0, 0.0); }),
    ternary(
        "mix", floats, call("mix($0, $1, $2)"), everywhere,
        [](auto x, auto y, auto t) { return mix(x, y, t); },
        [](auto, auto, auto t, auto) { return 1.0 - t; },  //
        [](auto, auto, auto t, auto) { return t; },
        [](auto x, auto y, auto, auto) { return y - x; }),
    binary("step", floats, call("step($0, $1)"), everywhere,
           [](auto edge, auto x) { return step(edge, x); }),

    // conditions
    binary("lt", comparison, infix("$0 < $1", Relational), everywhere,
           [](auto x, auto y) { return lt(x, y); }),
    binary("le", comparison, infix("$0 <= $1", Relational), everywhere,
           [](auto x, auto y) { return le(x, y); }),
    binary("gt", comparison, infix("$0 > $1", Relational), everywhere,
           [](auto x, auto y) { return gt(x, y); }),
    binary("ge", comparison, infix("$0 >= $1", Relational), everywhere,
           [](auto x, auto y) { return ge(x, y); }),
    binary("eq", comparison, infix("$0 == $1", Equality), everywhere,
           [](auto x, auto y) { return eq(x, y); }),
    binary("ne", comparison, infix("$0 != $1", Equality), everywhere,
           [](auto x, auto y) { return ne(x, y); }),
    binary("and", logic, infix("$0 && $1", LogicalAnd), everywhere,
           [](auto x, auto y) { return logicalAnd(x, y); }),
    binary("or", logic, infix("$0 || $1", LogicalOr), everywhere,
           [](auto x, auto y) { return logicalOr(x, y); }),
    unary("not", logic, logicalNegation, everywhere, [](auto x) { return logicalNot(x); }),
    ternary(
        "ifElse", choice, conditional, everywhere,
        [](auto condition, auto yes, auto no) { return ifElse(condition, yes, no); }, zero,
        [](auto condition, auto, auto, auto) { return ifElse(condition, 1.0, 0.0); },
        [](auto condition, auto, auto, auto) { return ifElse(condition, 0.0, 1.0); }),

    // conversions, inserted where a condition is used as a number or a number as a condition
    unary("float", toFloat, call("float($0)"), everywhere,
          [](auto x) { return ifElse(x, 1.0, 0.0); }),
    unary("bool", toBool, call("bool($0)"), everywhere, [](auto x) { return ne(x, 0.0); }),
};

inline constexpr std::size_t count = std::tuple_size_v<decltype(table)>;

}  // namespace warpjet::ops
