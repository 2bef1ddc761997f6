// Constant expressions of a source that is still being parsed. Here every function of known numbers
// is folded; in shader code that is left to the shader compiler.
#include "source/lower.hpp"

namespace warpjet::source {

Lowering::Lowering(const Tree& tree, Problems& problems)
    : tree_(tree), problems_(problems), maxIterations_(rejectUnknown), recorder_(true) {}

// Evaluates a constant expression, after the constants that were declared since the last call.
std::vector<double> Lowering::constant(ExpressionId expression) {
  steps_ = 0;
  while (slots_.size() < tree_.variables.size()) {
    const Variable& variable = tree_.variables[slots_.size()];
    const bool isKnown = variable.kind == Variable::Kind::Constant && variable.start != nothing;
    const int size = isKnown ? sizeOf(variable.type) : 0;
    slots_.push_back(
        store_.allocate(static_cast<std::size_t>(size), recorder_.undefined(Base::Float)));
    if (isKnown) set(slots_.back(), evaluate(variable.start));
  }
  std::vector<double> numbers;
  for (const Id id : evaluate(expression)) {
    if (problems_.any() || !recorder_.isConstant(id)) return {};
    numbers.push_back(recorder_.value(id));
  }
  return numbers;
}

// Expands a function of vectors or matrices by its formula in section 8 of GLSL ES 3.00.
Lowering::Value Lowering::expandFunction(Code code, const std::vector<Value>& x) {
  const auto floatOf = [&](Operator op, Id a, Id b) { return scalar(op, Base::Float, a, b); };
  const auto constant = [&](double value) { return number(Base::Float, value); };
  const auto forEach = [&](const auto& make) {
    Value value;
    for (std::size_t i = 0; i < x[0].size(); ++i) value.push_back(make(i));
    return value;
  };
  const auto dot = [&](const Value& a, const Value& b) {
    Id sum = constant(0);
    for (std::size_t i = 0; i < a.size(); ++i)
      sum = floatOf(Operator::Add, sum, floatOf(Operator::Multiply, a[i], b[i]));
    return sum;
  };
  const auto length = [&](const Value& a) {
    return recorder_.apply(Code::Sqrt, Base::Float, {dot(a, a)});
  };
  switch (code) {
    case Code::Length:
      return {length(x[0])};
    case Code::Distance:
      return {length(
          forEach([&](std::size_t i) { return floatOf(Operator::Subtract, x[0][i], x[1][i]); }))};
    case Code::Normalize: {
      const Id size = length(x[0]);
      return forEach([&](std::size_t i) { return floatOf(Operator::Divide, x[0][i], size); });
    }
    case Code::Faceforward: {
      const Id isFacing = floatOf(Operator::Less, dot(x[2], x[1]), constant(0));
      return forEach([&](std::size_t i) {
        return recorder_.choose(isFacing, x[0][i],
                                recorder_.apply(Code::Neg, Base::Float, {x[0][i]}));
      });
    }
    case Code::Reflect: {
      const Id twice = floatOf(Operator::Multiply, constant(2), dot(x[1], x[0]));
      return forEach([&](std::size_t i) {
        return floatOf(Operator::Subtract, x[0][i], floatOf(Operator::Multiply, twice, x[1][i]));
      });
    }
    case Code::Refract: {
      const Id cosine = dot(x[1], x[0]), ratio = x[2][0];
      const Id squaredSine =
          floatOf(Operator::Subtract, constant(1), floatOf(Operator::Multiply, cosine, cosine));
      const Id radicand = floatOf(
          Operator::Subtract, constant(1),
          floatOf(Operator::Multiply, floatOf(Operator::Multiply, ratio, ratio), squaredSine));
      const Id isTotal = floatOf(Operator::Less, radicand, constant(0));
      const Id normalFactor = floatOf(
          Operator::Add, floatOf(Operator::Multiply, ratio, cosine),
          recorder_.apply(Code::Sqrt, Base::Float,
                          {recorder_.apply(Code::Max, Base::Float, {radicand, constant(0)})}));
      return forEach([&](std::size_t i) {
        const Id bent = floatOf(Operator::Subtract, floatOf(Operator::Multiply, ratio, x[0][i]),
                                floatOf(Operator::Multiply, normalFactor, x[1][i]));
        return recorder_.choose(isTotal, constant(0), bent);
      });
    }
    default:
      return code == Code::Determinant ? Value{determinant(x[0])} : inverse(x[0]);
  }
}

// Returns the minor of a square matrix without a column and a row.
Id Lowering::minorOf(const Value& matrix, std::size_t column, std::size_t row) {
  const std::size_t size = matrix.size() == 4 ? 2 : matrix.size() == 9 ? 3 : 4;
  Value rest;
  for (std::size_t i = 0; i < matrix.size(); ++i)
    if (i / size != column && i % size != row) rest.push_back(matrix[i]);
  return determinant(rest);
}

// Returns the determinant by expansion along the first column.
Id Lowering::determinant(const Value& matrix) {
  if (matrix.size() == 1) return matrix[0];
  const std::size_t size = matrix.size() == 4 ? 2 : matrix.size() == 9 ? 3 : 4;
  Id sum = number(Base::Float, 0);
  for (std::size_t row = 0; row < size; ++row) {
    const Id term = scalar(Operator::Multiply, Base::Float, matrix[row], minorOf(matrix, 0, row));
    sum = scalar(row % 2 ? Operator::Subtract : Operator::Add, Base::Float, sum, term);
  }
  return sum;
}

Lowering::Value Lowering::inverse(const Value& matrix) {
  const std::size_t size = matrix.size() == 4 ? 2 : matrix.size() == 9 ? 3 : 4;
  const Id whole = determinant(matrix);
  Value value;
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    const std::size_t column = i / size, row = i % size;
    const Id minor = minorOf(matrix, row, column);
    const Id signed_ =
        (column + row) % 2 ? recorder_.apply(Code::Neg, Base::Float, {minor}) : minor;
    value.push_back(scalar(Operator::Divide, Base::Float, signed_, whole));
  }
  return value;
}

}  // namespace warpjet::source
