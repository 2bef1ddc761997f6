// Calls of operations: checks the number of operands and their shapes.
#include <algorithm>

#include "builder/builder.hpp"
#include "module/messages.hpp"

namespace warpjet {

namespace {

constexpr Op Mult = ops::find("mult"), Div = ops::find("div");

// Returns the description of a kind in messages.
std::string_view kindName(Kind kind) {
  switch (kind) {
    case Kind::Number:
      return "a single number";
    case Kind::Vector:
      return "a vector";
    case Kind::Vec3:
      return "a vec3";
    case Kind::NumberOrVector:
      return "a number or a vector";
    case Kind::Square:
      return "a square matrix";
    case Kind::Matrix:
      return "a matrix";
    case Kind::Mat3:
      return "a mat3";
    case Kind::Input:
      return "a single input (such as position.x())";
    case Kind::Inputs:
      return "a vector of inputs (such as position)";
    case Kind::Inputs3:
      return "a vec3 of inputs (such as position)";
    default:
      return "an expression";
  }
}

bool isOfKind(Kind kind, Shape shape) {
  switch (kind) {
    case Kind::Number:
    case Kind::Input:
      return shape.isNumber();
    case Kind::Vector:
    case Kind::Inputs:
      return shape.isVector();
    case Kind::Vec3:
    case Kind::Inputs3:
      return shape == vectorOf(3);
    case Kind::NumberOrVector:
      return !shape.isMatrix();
    case Kind::Square:
      return shape.isMatrix() && shape.isSquare();
    case Kind::Matrix:
      return shape.isMatrix();
    case Kind::Mat3:
      return shape == matrixOf(3, 3);
    default:
      return true;
  }
}

}  // namespace

std::string Builder::Site::describeOperand(std::size_t operand) const {
  if (isMethod && operand == 0) return "the value it is called on";
  return "argument " + std::to_string(operand + (isMethod ? 0 : 1));
}

bool Builder::checkCount(int wanted, const Site& site) {
  const int count = static_cast<int>(operands_.size());
  if (count == wanted) return true;
  const int receivers = site.isMethod ? 1 : 0;
  reject(site.method, {"expected ", argumentCount(wanted - receivers), ", got ",
                       std::to_string(count - receivers), "."});
  return false;
}

std::nullopt_t Builder::rejectShapes(Shape a, Shape b, const Site& site) {
  const bool isProduct = a.isMatrix() || b.isMatrix();
  return reject(site.method, {shapeName(a), " and ", shapeName(b), " do not fit together; use ",
                              isProduct ? "matrices and vectors of the same size."
                                        : "vectors of the same size, or numbers."});
}

std::optional<Shape> Builder::commonShape(std::span<const Value> operands, const Site& site) {
  Shape common;
  for (const Value& operand : operands) {
    if (operand.shape().isNumber()) continue;
    if (!common.isNumber() && common != operand.shape())
      return rejectShapes(common, operand.shape(), site);
    common = operand.shape();
  }
  return common;
}

std::optional<Value> Builder::applyRow(Op op, const Site& site) {
  if (op == ops::find("atan") && operands_.size() == 2) op = ops::find("atan2");
  const std::size_t minCount = site.isMethod ? 2 : 1;
  if (!ops::has(op, ops::Trait::Chained) || operands_.size() < minCount) {
    if (!checkCount(ops::declaration(op).arity, site)) return std::nullopt;
    return applyRowTo(op, operands_, site);
  }
  std::optional<Value> result = operands_[0];
  for (std::size_t i = 1; result && i < operands_.size(); ++i)
    result = applyRowTo(op, std::array{*result, operands_[i]}, site);
  return result;
}

std::optional<Value> Builder::applyRowTo(Op op, std::span<const Value> operands, const Site& site) {
  const auto isMatrix = [](const Value& operand) { return operand.shape().isMatrix(); };
  if (std::any_of(operands.begin(), operands.end(), isMatrix)) {
    if (!ops::has(op, ops::Trait::OnMatrices))
      return reject(site.method,
                    {"it does not work on matrices; use their columns, such as m.column(0)."});
    const bool hasNumber = operands.back().size() == 1 || operands[0].size() == 1;
    if (op == Mult && !hasNumber) return applyMatrixProduct(operands[0], operands[1], site);
    if (op == Div && isMatrix(operands[1]))
      return reject(site.method, {"a matrix cannot divide; multiply by its inverse()."});
  }
  if (!commonShape(operands, site)) return std::nullopt;
  if (op == ops::find("atan2") && isConstant(operands[0], 0) && isConstant(operands[1], 0))
    return reject(site.method, {"the point (0, 0) has no angle."});
  return byComponent(op, operands);
}

std::optional<Value> Builder::applyMatrixProduct(const Value& a, const Value& b, const Site& site) {
  const int inner = a.shape().isMatrix() ? a.shape().columns : a.shape().rows;
  if (inner != b.shape().rows) return rejectShapes(a.shape(), b.shape(), site);
  return multiply(a, b);
}

std::optional<Value> Builder::compose(const Form& form, const Site& site) {
  const std::string_view kinds = form.operands;
  if (!checkCount(static_cast<int>(kinds.size()), site)) return std::nullopt;
  std::vector<Value> ofOneShape;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const Kind kind{kinds[i]};
    if (!fits(kind, operands_[i], i, site)) return std::nullopt;
    if (kind == Kind::Vector || kind == Kind::NumberOrVector) ofOneShape.push_back(operands_[i]);
  }
  if (!commonShape(ofOneShape, site)) return std::nullopt;
  if (form.rejection) {
    const std::string_view message = form.rejection(operands_);
    if (!message.empty()) return reject(site.method, {message, "."});
  }
  return form.compose(differentiator_, operands_);
}

bool Builder::fits(Kind kind, const Value& operand, std::size_t place, const Site& site) {
  const Shape shape = operand.shape();
  if (isOfKind(kind, shape)) return !isInput(kind) || fitsInput(operand, place, site);
  reject(site.method, {"expected ", kindName(kind), " as ", site.describeOperand(place), ", got ",
                       shapeName(shape), "."});
  return false;
}

bool Builder::fitsInput(const Value& operand, std::size_t place, const Site& site) {
  const auto nodes = operand.nodes();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const bool isRepeated =
        std::find(nodes.begin(), nodes.begin() + i, nodes[i]) != nodes.begin() + i;
    if (graph_.isInput(nodes[i]) && !isRepeated) continue;
    reject(site.method, {site.describeOperand(place),
                         isRepeated ? " must not repeat a component."
                                    : " must be an input such as millis or position.x(), "
                                      "not something computed."});
    return false;
  }
  return true;
}

}  // namespace warpjet
