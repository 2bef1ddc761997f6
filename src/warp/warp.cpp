#include "warp/warp.hpp"

#include <algorithm>
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

// How large any component can be; infinite near a pole, or without bound.
double mostOf(const Value& v) {
  double most = 0;
  for (const NodeId node : v.nodes()) {
    const Interval range = v.graph().range(node);
    if (range.canBeNaN) return Interval::infinity;
    most = std::max({most, -range.low, range.high});
  }
  return most;
}

// What is no number stays so in it, as not in a maximum.
Expression sizeOf(const Value& v) { return sum(byComponent(ops::find("abs"), std::array{v})); }

// float32 has the squares of smaller numbers, and sums of a few.
constexpr double mostSquared = 1e18;

// Length 1 in the same direction, or zero for zero and for what is infinite or no number. Scaled
// before it is squared, unless `most` says that it is small: how large its components are, about.
Value unit(const Value& v, double most) {
  if (most <= mostSquared) return normalize(v);
  const Expression size = sizeOf(v);
  const Value scaled = v / size;
  const Value turned = scaled * inversesqrt(dot(scaled, scaled));
  const Expression hasDirection = logicalAnd(gt(size, 0.0), lt(size, 1e38));
  return fill(v.graph(), v.shape(), [&](int i) { return ifElse(hasDirection, turned[i], 0.0); });
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

Value sized(const Value& m) {
  const double most = mostOf(m);
  if (most <= mostSquared || most == Interval::infinity) return m;
  return m * Value(min(mostSquared / sizeOf(m), 1.0));
}

Value turnedNormal(const Value& given, const Value& normal) {
  const Value m = sized(given);
  const Value a = cross(m.column(1), m.column(2)), b = cross(m.column(2), m.column(0)),
              c = cross(m.column(0), m.column(1));
  const double most = mostOf(given);
  return unit(a * normal[0] + b * normal[1] + c * normal[2], most * most);
}

Value turnedTangent(const Value& given, const Value& tangent, const Value& normal) {
  const Value m = sized(given), moved = multiply(m, tangent);
  return unit(moved - normal * dot(normal, moved), mostOf(given));
}

}  // namespace warpjet
