// The second table: operations composed of rows of the first, ops/table.hpp, so that they need no
// derivative rule of their own, which could be wrong. One row each: name, operands and description
// for the documentation, then the kinds of operands and result, and the formula.
#pragma once

#include <algorithm>
#include <array>
#include <numbers>
#include <span>

#include "algebra/derivatives.hpp"
#include "algebra/matrices.hpp"
#include "algebra/vectors.hpp"
#include "diff/differentiator.hpp"
#include "ops/title.hpp"
#include "warp/warp.hpp"

namespace warpjet {

// The requirement on an operand or a result.
enum class Kind : char {
  Number = 's',
  Vector = 'v',  // two to four components; all vectors of a row have the same size
  Vec3 = '3',
  NumberOrVector = 'x',  // componentwise: all operands that aren't numbers have the same shape
  Square = 'm',          // a square matrix
  Matrix = 'M',
  Any = 'e',
  Mat3 = '9',
  Input = 'i',    // a number that is an input
  Inputs = 'I',   // a vector of distinct inputs
  Inputs3 = 'J',  // a vec3 of distinct inputs
};

constexpr bool isInput(Kind kind) {
  return kind == Kind::Input || kind == Kind::Inputs || kind == Kind::Inputs3;
}

// Derivatives need the differentiator; the other formulas ignore it.
using Compose = Value (*)(Differentiator&, std::span<const Value>);

// Returns why constant operands are invalid; empty if they are valid.
using Rejection = std::string_view (*)(std::span<const Value>);

struct Composition {
  ops::Title title;
  std::string_view operands;  // one Kind per operand
  Kind result;
  Compose compose;
  Rejection rejection = nullptr;
  bool isListed = true;  // false for internal use by our JavaScript
};

inline bool isConstant(const Value& v, double value) {
  return std::all_of(v.nodes().begin(), v.nodes().end(),
                     [&](NodeId id) { return v.graph().isConstant(id, value); });
}

inline constexpr std::array compositions{
    // vectors
    Composition{{"dot", "a, b", "The dot product."},
                "vv",
                Kind::Number,
                [](auto&, auto x) -> Value { return dot(x[0], x[1]); }},
    Composition{{"cross", "a, b", "The cross product."},
                "33",
                Kind::Vec3,
                [](auto&, auto x) { return cross(x[0], x[1]); }},
    Composition{{"length", "v", "The length; its derivative at zero is defined as zero."},
                "v",
                Kind::Number,
                [](auto&, auto x) -> Value { return length(x[0]); }},
    Composition{{"dist", "a, b", "The distance between two points."},
                "vv",
                Kind::Number,
                [](auto&, auto x) -> Value { return length(x[0] - x[1]); }},
    Composition{{"distance", "a, b", "The distance between two points."},
                "vv",
                Kind::Number,
                [](auto&, auto x) -> Value { return length(x[0] - x[1]); }},
    Composition{
        {"normalize", "v", "The unit vector in the same direction; zero for the zero vector."},
        "v",
        Kind::Vector,
        [](auto&, auto x) { return normalize(x[0]); }},
    Composition{{"scale", "v, factor", "The vector times a number."},
                "es",
                Kind::Any,
                [](auto&, auto x) { return x[0] * x[1]; }},
    Composition{{"reflect", "incident, normal",
                 "The direction reflected by a surface with that unit normal."},
                "vv",
                Kind::Vector,
                [](auto&, auto x) { return reflect(x[0], x[1]); }},
    Composition{{"refract", "incident, normal, eta",
                 "The direction refracted by a surface with that unit normal, for a ratio of "
                 "indices of refraction; zero in case of total internal reflection."},
                "vvs",
                Kind::Vector,
                [](auto&, auto x) { return refract(x[0], x[1], x[2][0]); }},
    Composition{{"faceforward", "normal, incident, reference",
                 "The normal, reversed if `incident` points along `reference`."},
                "vvv",
                Kind::Vector,
                [](auto&, auto x) { return faceforward(x[0], x[1], x[2]); }},

    // numbers and vectors
    Composition{{"smoothstep", "low, high, x",
                 "A smooth step from 0 for x at `low` to 1 for x at `high`, which must differ."},
                "xxx",
                Kind::NumberOrVector,
                [](auto&, auto x) { return smoothstep(x[0], x[1], x[2]); }},
    Composition{{"radians", "degrees", "An angle in degrees, as radians."},
                "x",
                Kind::NumberOrVector,
                [](auto&, auto x) { return x[0] * (std::numbers::pi / 180); }},
    Composition{{"degrees", "radians", "An angle in radians, as degrees."},
                "x",
                Kind::NumberOrVector,
                [](auto&, auto x) { return x[0] * (180 / std::numbers::pi); }},

    // matrices
    Composition{{"transpose", "m", "The transposed matrix."},
                "M",
                Kind::Matrix,
                [](auto&, auto x) { return transpose(x[0]); }},
    Composition{{"determinant", "m", "The determinant."},
                "m",
                Kind::Number,
                [](auto&, auto x) -> Value { return determinant(x[0]); }},
    Composition{{"inverse", "m", "The inverse; infinite or NaN where the determinant is 0."},
                "m",
                Kind::Square,
                [](auto&, auto x) { return inverse(x[0]); },
                [](auto x) -> std::string_view {
                  return isConstant(Value(determinant(x[0])), 0)
                             ? "the determinant of this matrix is 0, so that it has no inverse"
                             : "";
                }},
    Composition{{"rotateX", "angle",
                 "The mat3 that rotates by an angle in radians about the x axis, "
                 "counterclockwise when the axis points at the viewer."},
                "s",
                Kind::Mat3,
                [](auto&, auto x) { return rotationAbout(0, x[0][0]); }},
    Composition{{"rotateY", "angle", "The mat3 that rotates about the y axis, like `rotateX`."},
                "s",
                Kind::Mat3,
                [](auto&, auto x) { return rotationAbout(1, x[0][0]); }},
    Composition{{"rotateZ", "angle", "The mat3 that rotates about the z axis, like `rotateX`."},
                "s",
                Kind::Mat3,
                [](auto&, auto x) { return rotationAbout(2, x[0][0]); }},
    Composition{{"rotate", "axis, angle", "The mat3 that rotates about any axis, like `rotateX`."},
                "3s",
                Kind::Mat3,
                [](auto&, auto x) { return rotationAbout(x[0], x[1][0]); },
                [](auto x) -> std::string_view {
                  return isConstant(x[0], 0) ? "the axis is zero, so that it has no direction" : "";
                }},

    // derivatives
    Composition{{"derivative", "value, input",
                 "The exact partial derivative of each component with respect to an input."},
                "ei",
                Kind::Any,
                [](auto& d, auto x) { return derivative(d, x[0], x[1][0]); }},
    Composition{{"gradient", "value, inputs",
                 "The exact derivatives of a number with respect to a vector of inputs."},
                "sI",
                Kind::Vector,
                [](auto& d, auto x) { return gradient(d, x[0][0], x[1]); }},
    Composition{
        {"jacobian", "value, inputs",
         "The exact derivatives of a vector: a matrix with a column for each component of a "
         "vector of inputs."},
        "vI",
        Kind::Matrix,
        [](auto& d, auto x) { return jacobian(d, x[0], x[1]); }},
    Composition{
        {"adjustNormal", "offset, normal, position",
         "The unit normal after the warp of `position` by this offset; zero where it has "
         "none."},
        "33J",
        Kind::Vec3,
        [](auto& d, auto x) { return outwardNormal(deformation(d, x[0], x[2]), x[1], x[2]); }},
    Composition{
        {"adjustTangent", "offset, tangent, normal, position",
         "The unit tangent after the warp of `position` by this offset, at right angles to "
         "`normal`, the one after the warp."},
        "333J",
        Kind::Vec3,
        [](auto& d, auto x) { return warpTangent(deformation(d, x[0], x[3]), x[1], x[2]); }},
    Composition{{"orientation", "offset, normal, position",
                 "-1 if the warp of `position` by this offset mirrors all of space, 1 if it "
                 "does not, 0 if it may mirror parts of it."},
                "33J",
                Kind::Number,
                [](auto& d, auto x) -> Value {
                  const auto found = orientationOf(deformation(d, x[0], x[2]), x[1], x[2]);
                  return found ? Value(*found) : constantLike(x[0], 0);
                },
                nullptr,
                false},
};

static_assert(std::all_of(compositions.begin(), compositions.end(), [](const Composition& row) {
  return row.operands.find_first_not_of("sv3xmM9eiIJ") == std::string_view::npos;
}));

// A composition without its documentation, so that the program doesn't contain those texts.
struct Form {
  std::string_view operands;
  Compose compose;
  Rejection rejection;
};

inline constexpr auto forms = [] {
  std::array<Form, compositions.size()> all{};
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = {compositions[i].operands, compositions[i].compose, compositions[i].rejection};
  return all;
}();

}  // namespace warpjet
