#include "algebra/value.hpp"

namespace warpjet {

Value Value::column(int i) const {
  return fill(graph(), vectorOf(shape_.rows), [&](int row) { return at(i, row); });
}

Value Value::row(int i) const {
  return fill(graph(), vectorOf(shape_.columns), [&](int column) { return at(column, i); });
}

Value byComponent(Op op, std::span<const Value> operands) {
  Shape shape;
  for (const Value& operand : operands) {
    if (operand.size() > 1) shape = operand.shape();
  }
  Graph& graph = operands[0].graph();
  Value result(graph, shape);
  for (int i = 0; i < shape.size(); ++i) {
    Operands<NodeId> components{};
    for (std::size_t k = 0; k < operands.size(); ++k)
      components[k] = operands[k].nodes()[operands[k].size() == 1 ? 0 : i];
    result.set(i, graph.apply(op, components));
  }
  return result;
}

}  // namespace warpjet
