#include "algebra/derivatives.hpp"

namespace warpjet {

Value derivative(Differentiator& differentiator, const Value& value, Expression input) {
  return fill(value.graph(), value.shape(), [&](int i) {
    return Expression{&value.graph(), differentiator.derivative(value[i].id, input.id)};
  });
}

Value gradient(Differentiator& differentiator, Expression value, const Value& inputs) {
  return fill(inputs.graph(), inputs.shape(), [&](int i) {
    return Expression{&inputs.graph(), differentiator.derivative(value.id, inputs[i].id)};
  });
}

Value jacobian(Differentiator& differentiator, const Value& value, const Value& inputs) {
  return fillMatrix(value.graph(), inputs.size(), value.size(), [&](int column, int row) {
    return Expression{&value.graph(), differentiator.derivative(value[row].id, inputs[column].id)};
  });
}

}  // namespace warpjet
