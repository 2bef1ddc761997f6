#include "warp/warp.hpp"

#include <optional>

#include "graph/expression.hpp"

namespace warpjet {

namespace {

using Vector = std::array<Expression, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Zero stays zero, where GLSL's normalize is undefined.
Vector normalizeOrZero(const Vector& v) {
  const Expression squared = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  const Expression scale = ifElse(gt(squared, 0.0), inversesqrt(squared), 0.0);
  return {v[0] * scale, v[1] * scale, v[2] * scale};
}

// x + 1 if x is a sum with the term -1 within a few levels. An offset is often "moved - position",
// and its derivative such a sum; adding 1 to it would cost digits where the rest is small.
std::optional<Expression> cancelMinusOne(Expression x, int levels = 4) {
  Graph& graph = *x.graph;
  if (graph.isConstant(x.id, -1)) return Expression{&graph, graph.constant(0)};
  const bool isSum = graph.is(x.id, ops::find("add")),
             isDifference = graph.is(x.id, ops::find("sub"));
  if (levels == 0 || !(isSum || isDifference)) return {};
  const Expression left{&graph, graph.operand(x.id, 0)}, right{&graph, graph.operand(x.id, 1)};
  if (isDifference && graph.isConstant(right.id, 1)) return left;
  if (const auto rest = cancelMinusOne(left, levels - 1))
    return isSum ? *rest + right : *rest - right;
  if (!isSum) return {};
  if (const auto rest = cancelMinusOne(right, levels - 1)) return left + *rest;
  return {};
}

Expression plusOne(Expression x) {
  if (const auto rest = cancelMinusOne(x)) return *rest;
  return x + 1.0;
}

// The columns of I + J.
std::array<Vector, 3> jacobianOfWarp(Differentiator& differentiator, Graph& graph,
                                     const Vec3& position, const Vec3& offset) {
  std::array<Vector, 3> columns;
  for (std::size_t column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      const Expression entry{&graph, differentiator.derivative(offset[row], position[column])};
      columns[column][row] = row == column ? plusOne(entry) : entry;
    }
  }
  return columns;
}

}  // namespace

Vec3 warpedPosition(Graph& graph, const Vec3& position, const Vec3& offset) {
  Vec3 moved;
  for (std::size_t i = 0; i < 3; ++i)
    moved[i] = (Expression{&graph, position[i]} + Expression{&graph, offset[i]}).id;
  return moved;
}

Vec3 warpedNormal(Differentiator& differentiator, Graph& graph, const Vec3& position,
                  const Vec3& normal, const Vec3& offset) {
  const auto m = jacobianOfWarp(differentiator, graph, position, offset);
  const std::array<Vector, 3> cofactor{cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};

  Vector turned;
  for (std::size_t row = 0; row < 3; ++row) {
    Expression sum{&graph, graph.constant(0)};
    for (std::size_t column = 0; column < 3; ++column)
      sum = sum + cofactor[column][row] * Expression{&graph, normal[column]};
    turned[row] = sum;
  }
  const Vector unit = normalizeOrZero(turned);
  return {unit[0].id, unit[1].id, unit[2].id};
}

}  // namespace warpjet
