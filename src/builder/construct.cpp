// Constructs vectors and matrices, and extracts their parts.
#include <vector>

#include "builder/builder.hpp"
#include "module/messages.hpp"

namespace warpjet {

namespace {

// Converts a condition to 0 or 1, by adding 0.
NodeId toFloat(Graph& graph, NodeId id) {
  return graph.apply(ops::find("add"), {id, graph.constant(0)});
}

}  // namespace

// Returns the components of all operands, concatenated.
std::optional<std::vector<Expression>> Builder::components(const Site& site) {
  std::vector<Expression> all;
  for (std::size_t i = 0; i < operands_.size(); ++i) {
    if (operands_[i].shape().isMatrix()) {
      reject(site.method, {"expected a vector or a number as ", site.describeOperand(i), ", got ",
                           shapeName(operands_[i].shape()), "."});
      return std::nullopt;
    }
    for (const NodeId id : operands_[i].nodes()) all.push_back({&graph_, toFloat(graph_, id)});
  }
  return all;
}

std::optional<Value> Builder::makeVector(int size, const Site& site) {
  const auto parts = components(site);
  if (!parts) return std::nullopt;
  const int count = static_cast<int>(parts->size());
  if (count != size && count != 1)
    return reject(site.method, {"expected ", std::to_string(size), " components, got ",
                                std::to_string(count), "."});
  return fill(graph_, vectorOf(size), [&](int i) { return (*parts)[count == 1 ? 0 : i]; });
}

std::optional<Value> Builder::makeMatrix(int size, bool ofRows, const Site& site) {
  if (!ofRows && operands_.size() == 1 && operands_[0].shape().isMatrix())
    return resize(operands_[0], size);
  const auto parts = components(site);
  if (!parts) return std::nullopt;
  if (parts->size() == 1) return diagonal(size, (*parts)[0]);
  const bool areAllNumbers = operands_.size() == parts->size();
  for (const Value& operand : operands_) {
    if (areAllNumbers || operand.shape() == vectorOf(size)) continue;
    return reject(site.method,
                  {"expected ", std::to_string(size), ofRows ? " rows" : " columns", " of ",
                   std::to_string(size), " components, got ", shapeName(operand.shape()), "."});
  }
  if (static_cast<int>(parts->size()) != size * size)
    return reject(site.method, {"expected ", std::to_string(size * size), " components, got ",
                                std::to_string(parts->size()), "."});
  const Value matrix = fill(graph_, matrixOf(size, size), [&](int i) { return (*parts)[i]; });
  return ofRows ? transpose(matrix) : matrix;
}

// Truncates the matrix, or extends it by the identity matrix, as GLSL does.
Value Builder::resize(const Value& matrix, int size) {
  return fillMatrix(graph_, size, size, [&](int column, int row) {
    if (column < matrix.shape().columns && row < matrix.shape().rows) return matrix.at(column, row);
    return Expression{&graph_, graph_.constant(column == row ? 1 : 0)};
  });
}

std::optional<Value> Builder::takePart(bool isRow, const Site& site) {
  if (!checkCount(2, site) || !fits(Kind::Number, operands_[1], 1, site)) return std::nullopt;
  const Value& matrix = operands_[0];
  const Shape shape = matrix.shape();
  if (!shape.isMatrix())
    return reject(site.method, {"expected a matrix as ", site.describeOperand(0), ", got ",
                                shapeName(shape), "."});
  const int count = isRow ? shape.rows : shape.columns;
  for (int i = 0; i < count; ++i) {
    if (isConstant(operands_[1], i)) return isRow ? matrix.row(i) : matrix.column(i);
  }
  return reject(site.method, {site.describeOperand(1), " must be a whole number from 0 to ",
                              std::to_string(count - 1), "."});
}

}  // namespace warpjet
