// A copy of the table with three rows of its own. The core is built once more with this file in the
// place of src/ops/table.hpp, and nothing else changed.
#pragma once

#include <tuple>

#include "ops/row.hpp"
#include "ops/scalar.hpp"

#define table standardTable
#include "../../../../src/ops/table.hpp"
#undef table

namespace warpjet::ops {

inline constexpr Helpers cbrtHelpers{
    "highp float warpjetCbrt(highp float x) { return sign(x) * pow(abs(x), 1.0 / 3.0); }\n", "",
    "fn warpjetCbrt(x: f32) -> f32 { return sign(x) * pow(abs(x), 1.0 / 3.0); }\n"};

inline constexpr auto table = std::tuple_cat(
    standardTable,
    std::tuple{
        // For plain numbers alone, with a function of its own in the texts that have it.
        row(
            "cbrt", call("warpjetCbrt($0)").missingIn(Glsl100), everywhere,
            [](double x) { return std::cbrt(x); }, [](auto, auto v) { return 1.0 / (3.0 * v * v); })
            .helpedBy(cbrtHelpers)
            .loweredTo([](auto x) { return sign(x) * pow(abs(x), 1.0 / 3); }),
        // For any scalar.
        row(
            "hypot", call("length(vec2($0, $1))").with(Wgsl, "length(vec2f($0, $1))"), everywhere,
            [](auto x, auto y) { return sqrt(x * x + y * y); },
            [](auto x, auto, auto v) { return x / v; }, [](auto, auto y, auto v) { return y / v; }),
        // Two plain numbers, without a derivative.
        row("times", call("round($0 / $1)").missingIn(Glsl100), {anywhere, positive, {}},
            [](double x, double y) { return std::nearbyint(x / y); })
            .loweredTo([](auto x, auto y) { return floor(x / y + 0.5); }),
    });

}  // namespace warpjet::ops
