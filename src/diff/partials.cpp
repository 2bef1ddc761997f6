#include "diff/partials.hpp"

#include "graph/multi_index.hpp"
#include "ops/rows.hpp"

namespace warpjet {

namespace {

template <std::size_t Row, std::size_t K>
Expression times(Graph& graph, const Operands<Expression>& x, Expression value,
                 Expression derivative) {
  return {&graph, toNode(graph, ops::term<Row, K>(x.data(), value, derivative))};
}

template <std::size_t Row>
constexpr Partials partialsOfRow() {
  using Functions = decltype(std::get<Row>(ops::table).partials);
  return ops::withIndices<std::tuple_size_v<Functions>>([](auto... k) {
    return Partials{Partial{&times<Row, k>, ops::takesDerivative<Row, k>}...};
  });
}

constexpr auto partials =
    ops::withIndices<ops::count>([](auto... row) { return std::array{partialsOfRow<row>()...}; });

}  // namespace

const Partials& partialsOf(Op op) { return partials[index(op)]; }

std::vector<Slope> slopesOf(Graph& graph, NodeId id) {
  std::vector<Slope> slopes;
  if (graph.isCall(id)) {
    const std::vector<NodeId> arguments = graph.arguments(id), byArgument = graph.partials(id);
    for (std::size_t i = 0; i < arguments.size(); ++i)
      slopes.push_back({arguments[i], byArgument[i]});
    return slopes;
  }
  const NodeId call = graph.operand(id, 0);
  const int values = graph.function(call).values, variables = graph.function(call).variables;
  const std::vector<NodeId> arguments = graph.arguments(call);
  const int derivative = graph.resultNumber(id) / values, value = graph.resultNumber(id) % values;
  MultiIndices indices(variables, MultiIndices::orderOf(variables, derivative) + 1);
  for (int i = 0; i < variables; ++i) {
    const int number = indices.derivative(derivative, i) * values + value;
    slopes.push_back({arguments[i], graph.result(call, number)});
  }
  return slopes;
}

}  // namespace warpjet
