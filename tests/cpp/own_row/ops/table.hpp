// A copy of the table with three more rows. The core is built a second time with this file instead
// of src/ops/table.hpp, without any other change than own_row/ops/declarations.hpp.
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
        // Its value is written only for double. GLSL ES 3.00 and WGSL call a helper function.
        row(
            "cbrt", call("warpjetCbrt($0)").missingIn(Glsl100), everywhere,
            [](double x) { return std::cbrt(x); }, [](auto, auto v) { return 1.0 / (3.0 * v * v); })
            .withHelpers(cbrtHelpers)
            .lowersTo([](auto x) { return sign(x) * pow(abs(x), 1.0 / 3); }),
        // Its value is written for any type of scalar.
        row(
            "hypot", call("length(vec2($0, $1))").with(Wgsl, "length(vec2f($0, $1))"), everywhere,
            [](auto x, auto y) { return sqrt(x * x + y * y); },
            [](auto x, auto, auto v) { return x / v; }, [](auto, auto y, auto v) { return y / v; }),
        // Its value is written for two doubles; it has no derivative.
        row("times", call("round($0 / $1)").missingIn(Glsl100), {anywhere, positive, {}},
            [](double x, double y) { return std::nearbyint(x / y); })
            .lowersTo([](auto x, auto y) { return floor(x / y + 0.5); }),
    });

}  // namespace warpjet::ops
