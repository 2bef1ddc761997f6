#include "eval/fronts.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace warpjet {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// tanh(3) is 0.995.
constexpr double endOfTanh = 3;
// 1 / (1 + exp(x)) is (1 - tanh(x / 2)) / 2.
constexpr double endOfSigmoid = 2 * endOfTanh;

// Powers with exponents from 0 to this have no narrow peak.
constexpr double minExponent = 8;

std::optional<double> known(const Graph& graph, NodeId id) {
  return graph.isConstant(id) ? std::optional(graph.value(id)) : std::nullopt;
}

std::optional<FrontAt> powerOf(NodeId base, double exponent) {
  if (exponent >= 0 && exponent < minExponent) return std::nullopt;
  return FrontAt{base, {Profile::Power, exponent}};
}

std::optional<FrontAt> frontOfPow(const Graph& graph, NodeId base, NodeId exponent) {
  if (const auto number = known(graph, exponent)) return powerOf(base, *number);
  const auto number = known(graph, base);
  if (!number || *number <= 0) return std::nullopt;
  return FrontAt{exponent, {Profile::Exponential, std::log(*number)}};
}

// `first` and `second` are the limits of an operand.
std::optional<FrontAt> stepAt(Graph& graph, NodeId argument, std::optional<double> first,
                              std::optional<double> second) {
  if (!first || !second || !(*first < *second)) return std::nullopt;
  // The argument must pass a limit: see `addAtLimit` in kinks.cpp.
  const Interval range = graph.range(argument);
  if (*second == infinity ? range.low >= *first : *first == -infinity && range.high <= *second)
    return std::nullopt;
  return FrontAt{argument, {Profile::Step, *first, *second}};
}

// A product of equal factors, as a power of one of them.
struct Power {
  NodeId base;
  int exponent;
};

// Products of products are only searched this deep: factors are shared, so that each level can
// double the visits.
constexpr int maxProductDepth = 6;

Power powerAt(const Graph& graph, NodeId id, int depth = maxProductDepth) {
  if (depth == 0 || !graph.is(id, ops::find("mult"))) return {id, 1};
  const Power first = powerAt(graph, graph.operand(id, 0), depth - 1);
  const Power second = powerAt(graph, graph.operand(id, 1), depth - 1);
  if (first.base != second.base) return {id, 1};
  return {first.base, first.exponent + second.exponent};
}

std::optional<FrontAt> frontOfDivision(Graph& graph, NodeId divisor) {
  // A sigmoid: 1 / (c + exp(x)).
  for (int i = 0; i < 2 && graph.is(divisor, ops::find("add")); ++i) {
    const NodeId term = graph.operand(divisor, i);
    const auto c = known(graph, graph.operand(divisor, 1 - i));
    if (!graph.is(term, ops::find("exp")) || !c || *c <= 0) continue;
    return stepAt(graph, graph.operand(term, 0), std::log(*c) - endOfSigmoid,
                  std::log(*c) + endOfSigmoid);
  }
  if (const auto [base, exponent] = powerAt(graph, divisor); exponent > 1)
    return powerOf(base, -exponent);
  // Vectors are often normalized. That has no narrow peak, and measuring it takes milliseconds.
  if (graph.is(divisor, ops::find("sqrt"))) return std::nullopt;
  return powerOf(divisor, -1);
}

// A choice by a comparison with a constant changes on one side of it if the other branch is
// constant.
std::optional<FrontAt> frontOfChoice(Graph& graph, NodeId id) {
  const NodeId condition = graph.operand(id, 0);
  const bool isLess = graph.is(condition, ops::find("lt")) || graph.is(condition, ops::find("le"));
  const bool isMore = graph.is(condition, ops::find("gt")) || graph.is(condition, ops::find("ge"));
  const bool isYesConstant = graph.isConstant(graph.operand(id, 1));
  const bool isNoConstant = graph.isConstant(graph.operand(id, 2));
  if (!(isLess || isMore) || isYesConstant == isNoConstant) return std::nullopt;
  const int k = graph.isConstant(graph.operand(condition, 0)) ? 0 : 1;
  const std::optional<double> limit = known(graph, graph.operand(condition, k));
  // The other operand is below the limit where the branch that varies is chosen.
  const bool isBelow = (isLess == (k == 1)) == isNoConstant;
  const NodeId argument = graph.operand(condition, 1 - k);
  return isBelow ? stepAt(graph, argument, -infinity, limit)
                 : stepAt(graph, argument, limit, infinity);
}

}  // namespace

std::optional<FrontAt> frontOf(Graph& graph, NodeId id) {
  if (!graph.isOperation(id)) return std::nullopt;
  const Op op = graph.node(id).op;
  const auto operand = [&](int i) { return graph.operand(id, i); };
  const auto limit = [&](int i) { return known(graph, operand(i)); };
  if (op == ops::find("exp")) return FrontAt{operand(0), {Profile::Exponential, 1}};
  if (op == ops::find("exp2"))
    return FrontAt{operand(0), {Profile::Exponential, std::numbers::ln2}};
  if (op == ops::find("pow")) return frontOfPow(graph, operand(0), operand(1));
  if (op == ops::find("div")) return frontOfDivision(graph, operand(1));
  if (op == ops::find("tanh")) return stepAt(graph, operand(0), -endOfTanh, endOfTanh);
  if (op == ops::find("atan")) return FrontAt{operand(0), {Profile::Arctangent}};
  if (op == ops::find("ifElse")) return frontOfChoice(graph, id);
  if (op == ops::find("clamp")) return stepAt(graph, operand(0), limit(1), limit(2));
  if (op == ops::find("max") || op == ops::find("min")) {
    const int k = graph.isConstant(operand(0)) ? 0 : 1;
    return op == ops::find("max") ? stepAt(graph, operand(1 - k), limit(k), infinity)
                                  : stepAt(graph, operand(1 - k), -infinity, limit(k));
  }
  return std::nullopt;
}

}  // namespace warpjet
