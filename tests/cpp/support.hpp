// Shared by the tests of several modules: functions that make inputs of a graph, and that evaluate
// graphs in double. They take each operation's value from the table, which ops_test checks.
#pragma once

#include <cmath>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "algebra/value.hpp"
#include "emit/emit.hpp"
#include "graph/expression.hpp"
#include "graph/reachable.hpp"

namespace warpjet {

// Returns an input of any shape.
inline Value variable(Graph& graph, const std::string& name, Shape shape) {
  const std::uint32_t input = graph.input(name, shape);
  return fill(graph, shape, [&](int i) { return Expression{&graph, graph.component(input, i)}; });
}

inline Expression scalar(Graph& graph, const std::string& name) {
  return variable(graph, name, scalarShape)[0];
}

inline Value vector3(Graph& graph, const std::string& name) {
  return variable(graph, name, vectorOf(3));
}

inline Output result(const std::string& name, const Value& value) {
  return {name, value.shape(), {value.nodes().begin(), value.nodes().end()}};
}

// Returns the statements for one scalar result named `y`.
inline std::string code(Expression y, int maxDepth = 8, const Dialect& dialect = glsl300) {
  EmitOptions options;
  options.maxDepth = maxDepth;
  return emit(*y.graph, dialect, std::vector{result("y", y)}, options).code;
}

// Returns the expression that is assigned to `y` in the statements of `code`.
inline std::string body(Expression y, const Dialect& dialect = glsl300) {
  const std::string text = code(y, 8, dialect);
  const std::size_t start = text.find("y = ") + 4;
  return text.substr(start, text.find(';', start) - start);
}

// Returns the number of the row with that name.
inline Op rowNamed(std::string_view name) {
  std::size_t i = 0;
  while (i < ops::count && ops::declarations[i].name != name) ++i;
  return Op{static_cast<std::uint8_t>(i)};
}

// Maps each input node to its value.
using Inputs = std::map<NodeId, double>;

// Returns the values of all nodes that `roots` need, in double.
inline std::map<NodeId, double> evaluateNodes(const Graph& graph, std::span<const NodeId> roots,
                                              const Inputs& inputs) {
  std::map<NodeId, double> values;
  for (const NodeId id : reachable(graph, roots)) {
    if (graph.isConstant(id)) {
      values[id] = graph.value(id);
    } else if (graph.isInput(id)) {
      values[id] = inputs.at(id);
    } else {
      Operands<double> x{};
      for (int i = 0; i < graph.arity(id); ++i) x[i] = values[graph.operand(id, i)];
      values[id] = ops::valueOf(graph.node(id).op, x);
    }
  }
  return values;
}

inline double evaluateNode(const Graph& graph, NodeId root, const Inputs& inputs) {
  return evaluateNodes(graph, {&root, 1}, inputs)[root];
}

}  // namespace warpjet
