#include "warp/warp.hpp"

#include <optional>

#include "algebra/derivatives.hpp"
#include "algebra/matrices.hpp"
#include "algebra/vectors.hpp"

namespace warpjet {

namespace {

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

}  // namespace

Value deformation(Differentiator& differentiator, const Value& offset, const Value& position) {
  Value m = jacobian(differentiator, offset, position);
  for (int i = 0; i < 3; ++i) m.set(i, i, plusOne(m.at(i, i)));
  return m;
}

Value varied(Differentiator& differentiator, const Value& m, const Value& offset, Expression input,
             const Value& gradient) {
  const Value slope = derivative(differentiator, offset, input);
  return fill(m.graph(), m.shape(), [&](int i) { return m[i] + slope[i % 3] * gradient[i / 3]; });
}

Value turnedNormal(const Value& m, const Value& normal) {
  const Value cofactor[] = {cross(m.column(1), m.column(2)), cross(m.column(2), m.column(0)),
                            cross(m.column(0), m.column(1))};
  return normalize(cofactor[0] * normal[0] + cofactor[1] * normal[1] + cofactor[2] * normal[2]);
}

Value turnedTangent(const Value& m, const Value& tangent, const Value& normal) {
  const Value moved = multiply(m, tangent);
  return normalize(moved - normal * dot(normal, moved));
}

}  // namespace warpjet
