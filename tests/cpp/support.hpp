// What the tests of several rooms need: a graph with inputs, and an evaluator of whole graphs in
// double. It takes each operation's value from the table, which ops_test checks by itself.
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "diff/differentiator.hpp"
#include "emit/emit.hpp"
#include "graph/expression.hpp"
#include "graph/reachable.hpp"

namespace warpjet {

inline Expression scalar(Graph& graph, const std::string& name) {
  return {&graph, graph.component(graph.input(name, 1), 0)};
}

inline std::array<Expression, 3> vector3(Graph& graph, const std::string& name) {
  const auto input = graph.input(name, 3);
  return {Expression{&graph, graph.component(input, 0)},
          Expression{&graph, graph.component(input, 1)},
          Expression{&graph, graph.component(input, 2)}};
}

// The statements for one scalar result named `y`.
inline std::string code(Expression y, int maxDepth = 8) {
  const std::vector<Output> outputs{{"y", {y.id}}};
  EmitOptions options;
  options.maxDepth = maxDepth;
  return emit(*y.graph, outputs, options).code;
}

// The value of a node in double, where each input has the value of its number and component.
inline double evaluateNode(const Graph& graph, NodeId root,
                           const std::map<NodeId, double>& inputs) {
  std::map<NodeId, double> values;
  for (const NodeId id : reachable(graph, {&root, 1})) {
    if (graph.isConstant(id)) {
      values[id] = graph.value(id);
    } else if (graph.isInput(id)) {
      values[id] = inputs.at(id);
    } else {
      std::array<double, ops::maxArity> x{};
      for (int i = 0; i < graph.arity(id); ++i) x[i] = values[graph.operand(id, i)];
      values[id] = ops::evaluate(graph.node(id).op, x);
    }
  }
  return values[root];
}

}  // namespace warpjet
