#include "warp/warp.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "algebra/derivatives.hpp"
#include "algebra/matrices.hpp"
#include "algebra/vectors.hpp"
#include "graph/flags.hpp"
#include "graph/reachable.hpp"
#include "warp/orientation.hpp"

namespace warpjet {

namespace {

// Returns x + 1 if x is a sum with the term -1 within a few levels; otherwise nullopt. An offset is
// often "moved - position", and its derivative is such a sum; adding 1 would cost digits where the
// rest is small. -(a - b), which the graph doesn't simplify, is treated as b - a.
std::optional<Expression> cancelMinusOne(Expression x, int levels = 4) {
  Graph& graph = *x.graph;
  if (graph.isConstant(x.id, -1)) return Expression{&graph, graph.constant(0)};
  if (graph.is(x.id, ops::find("neg")) && graph.is(graph.operand(x.id, 0), ops::find("sub"))) {
    const NodeId difference = graph.operand(x.id, 0);
    x.id =
        graph.apply(ops::find("sub"), {graph.operand(difference, 1), graph.operand(difference, 0)});
  }
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

// Returns the max magnitude of the components; infinite near a pole, or if unbounded.
double maxMagnitude(const Value& v) {
  double maxValue = 0;
  for (const NodeId node : v.nodes()) {
    const Interval range = v.graph().range(node);
    if (range.canBeNaN) return Interval::infinity;
    maxValue = std::max({maxValue, -range.low, range.high});
  }
  return maxValue;
}

// Returns the sum of the components' magnitudes. It is NaN if a component is; a maximum may not be.
Expression sizeOf(const Value& v) { return sum(byComponent(ops::find("abs"), std::array{v})); }

// Squares, or cubes, of numbers below these limits, and sums of a few of them, are finite in
// float32.
constexpr double maxSquarable = 1e18, maxCubable = 1e12;

// Returns true if float32 can represent all values for inputs far beyond the magnitude that
// Graph::range assumes; sums of a few of them are then finite, too.
bool stayFinite(const Graph& graph, std::span<const NodeId> values) {
  constexpr double maxInput = 1e30, maxFinite = 1e37;
  std::vector<Interval> ranges(graph.size());
  for (const NodeId id : reachable(graph, values)) {
    Interval& range = ranges[index(id)];
    range = Interval::anything(true);
    if (graph.isConstant(id)) range = graph.value(id);
    if (graph.isInput(id)) range = {-maxInput, maxInput};
    if (graph.isResult(id)) range = {-Graph::assumedMagnitude, Graph::assumedMagnitude};
    if (!graph.isOperation(id)) continue;
    Operands<Interval> x;
    for (int i = 0; i < graph.arity(id); ++i) x[i] = ranges[index(graph.operand(id, i))];
    range = ops::rangeOf(graph.node(id).op, x);
  }
  return std::all_of(values.begin(), values.end(), [&](NodeId id) {
    const Interval& range = ranges[index(id)];
    return !range.canBeNaN && -maxFinite <= range.low && range.high <= maxFinite;
  });
}

// The approximate max magnitude of a vector's components, and whether they are finite for all
// inputs.
struct Size {
  double maxValue;
  bool staysFinite;
};

// Normalizes a vector; zero, infinite and NaN vectors become zero. It is scaled before it is
// squared, unless it is known to be small. Larger inputs than assumed may still make it infinite:
// its components are then selected to be zero, since multiplying by zero would give NaN.
Value normalizeOrZero(const Value& v, const Size& known) {
  const auto orZero = [&](Expression condition, const Value& x) {
    return fill(x.graph(), x.shape(), [&](int i) { return ifElse(condition, x[i], 0.0); });
  };
  if (known.maxValue <= maxSquarable) {
    if (known.staysFinite) return normalize(v);
    const Expression squared = dot(v, v);
    return orZero(logicalAnd(gt(squared, 0.0), lt(squared, 1e38)), v * inversesqrt(squared));
  }
  const Expression size = sizeOf(v);
  const Value scaled = v / size;
  return orZero(logicalAnd(gt(size, 0.0), lt(size, 1e38)),
                scaled * inversesqrt(dot(scaled, scaled)));
}

// Returns M, scaled down so that its entries add up to at most `limit` if they may be larger.
// Scaling by a positive factor keeps directions and orientation. If the size is unbounded, as near
// a pole, M is unchanged.
Value limitSize(const Value& m, double limit) {
  const double maxValue = maxMagnitude(m);
  if (maxValue <= limit || maxValue == Interval::infinity) return m;
  return m * Value(min(limit / sizeOf(m), 1.0));
}

std::array<Expression, 5> varyingNumbers(const WarpInputs& inputs) {
  const auto& [position, normal, uv, tangent, gradients, color] = inputs;
  return {normal[0], normal[1], normal[2], uv[0], uv[1]};
}

// Marks those of `candidates` that the values depend on.
Flags findRead(std::span<const NodeId> values, const Graph& graph,
               std::span<const NodeId> candidates) {
  const std::vector<NodeId> nodes = reachable(graph, values);
  Flags isRead(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i)
    isRead[i] = std::binary_search(nodes.begin(), nodes.end(), candidates[i]);
  return isRead;
}

WarpedDirections warpDirections(const Value& m, const WarpInputs& inputs) {
  Graph& graph = m.graph();
  const Value& t = inputs.tangent;
  const Value direction = fill(graph, vectorOf(3), [&](int i) { return t[i]; });
  const Value normal = warpNormal(m, inputs.normal), warped = warpTangent(m, direction, normal);
  const Value tangent = fill(graph, vectorOf(4), [&](int i) { return i < 3 ? warped[i] : t[3]; });
  return {normal, tangent, multiply(m, direction), determinant(limitSize(m, maxCubable))};
}

// Returns the inputs that vary per vertex.
std::vector<NodeId> vertexInputs(const WarpInputs& inputs) {
  std::vector<NodeId> all;
  const auto add = [&](const Value& v) {
    all.insert(all.end(), v.nodes().begin(), v.nodes().end());
  };
  for (const Value& v : {inputs.position, inputs.normal, inputs.uv, inputs.tangent}) add(v);
  for (const Value& gradient : inputs.gradients) add(gradient);
  if (inputs.color) add(*inputs.color);
  return all;
}

Expression valueOrOne(std::optional<Expression> orientation, Graph& graph) {
  return orientation.value_or(Expression{&graph, graph.constant(1)});
}

void orient(std::optional<WarpedDirections>& directions, Expression orientation) {
  if (!directions) return;
  directions->normal = directions->normal * Value(orientation);
  directions->tangent.set(3, (directions->tangent[3] * orientation).id);
}

}  // namespace

Warp makeWarp(Differentiator& differentiator, const Value& offset, const WarpInputs& inputs,
              const WarpOptions& options) {
  Warp warp{offset, inputs.position + offset};
  if (!options.needsDirections) return warp;
  Graph& graph = offset.graph();
  const Value constant = deformation(differentiator, offset, inputs.position);
  const std::array<Expression, 5> numbers = varyingNumbers(inputs);
  std::vector<NodeId> nodes, gradients;
  for (const Expression number : numbers) nodes.push_back(number.id);
  const Flags isRead = findRead(offset.nodes(), graph, nodes);
  const bool readsAny = std::find(isRead.begin(), isRead.end(), true) != isRead.end();
  if (options.isFlat || !readsAny) warp.flat = warpDirections(constant, inputs);
  Value m = constant;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!isRead[i]) continue;
    m = varyInput(differentiator, m, offset, numbers[i], inputs.gradients[i]);
    const auto gradient = inputs.gradients[i].nodes();
    gradients.insert(gradients.end(), gradient.begin(), gradient.end());
  }
  warp.surface = readsAny ? warpDirections(m, inputs) : warp.flat;
  const Flags isNeeded = findRead(m.nodes(), graph, gradients);
  warp.varies = std::find(isNeeded.begin(), isNeeded.end(), true) != isNeeded.end();

  // Also orients the surface by the determinant without gradients, the orientation of space: with
  // arbitrary gradients, the determinant can have either sign.
  warp.orientation = valueOrOne(
      orientation(warp.flat ? warp.flat->determinant : determinant(limitSize(constant, maxCubable)),
                  vertexInputs(inputs)),
      graph);
  orient(warp.flat, *warp.orientation);
  orient(warp.surface, *warp.orientation);
  return warp;
}

Value deformation(Differentiator& differentiator, const Value& offset, const Value& position) {
  Value m = jacobian(differentiator, offset, position);
  for (int i = 0; i < 3; ++i) m.set(i, i, plusOne(m.at(i, i)));
  return m;
}

Value varyInput(Differentiator& differentiator, const Value& m, const Value& offset,
                Expression input, const Value& gradient) {
  const Value slope = derivative(differentiator, offset, input);
  return fill(m.graph(), m.shape(), [&](int i) { return m[i] + slope[i % 3] * gradient[i / 3]; });
}

Value warpNormal(const Value& matrix, const Value& normal) {
  const Value m = limitSize(matrix, maxSquarable);
  const Value a = cross(m.column(1), m.column(2)), b = cross(m.column(2), m.column(0)),
              c = cross(m.column(0), m.column(1));
  const double maxValue = maxMagnitude(matrix);
  std::vector<NodeId> cofactors;
  for (const Value& column : {a, b, c}) {
    const auto nodes = column.nodes();
    cofactors.insert(cofactors.end(), nodes.begin(), nodes.end());
  }
  return normalizeOrZero(a * normal[0] + b * normal[1] + c * normal[2],
                         {maxValue * maxValue, stayFinite(m.graph(), cofactors)});
}

std::optional<Expression> orientationOf(const Value& m, const Value& normal,
                                        const Value& position) {
  std::vector<NodeId> vertexInputs(position.nodes().begin(), position.nodes().end());
  for (const NodeId id : reachable(m.graph(), normal.nodes())) {
    if (m.graph().isInput(id)) vertexInputs.push_back(id);
  }
  return orientation(determinant(limitSize(m, maxCubable)), vertexInputs);
}

Value outwardNormal(const Value& m, const Value& normal, const Value& position) {
  const Value warped = warpNormal(m, normal);
  return warped * Value(valueOrOne(orientationOf(m, normal, position), m.graph()));
}

Value warpTangent(const Value& matrix, const Value& tangent, const Value& normal) {
  const Value m = limitSize(matrix, maxSquarable), moved = multiply(m, tangent);
  return normalizeOrZero(moved - normal * dot(normal, moved),
                         {maxMagnitude(matrix), stayFinite(m.graph(), m.nodes())});
}

}  // namespace warpjet
