// How vectors and matrices are made and taken apart.
#include <vector>

#include "builder/builder.hpp"
#include "module/sentences.hpp"

namespace warpjet {

namespace {

// A condition becomes 0 or 1 here, as it does in any sum.
NodeId toFloat(Graph& graph, NodeId id) {
  return graph.apply(ops::find("add"), {id, graph.constant(0)});
}

}  // namespace

// The components of all operands, one after the other.
std::optional<std::vector<Expression>> Builder::components(const Site& site) {
  std::vector<Expression> all;
  for (std::size_t i = 0; i < operands_.size(); ++i) {
    if (operands_[i].shape().isMatrix()) {
      refuse(site.method, {site.place(i), " is ", shapeName(operands_[i].shape()),
                           ", but must be a vector or a number."});
      return std::nullopt;
    }
    for (const NodeId id : operands_[i].nodes()) all.push_back({&graph_, toFloat(graph_, id)});
  }
  return all;
}

std::optional<Value> Builder::makeVector(int size, const Site& site) {
  const auto parts = components(site);
  if (!parts) return std::nullopt;
  const int given = static_cast<int>(parts->size());
  if (given != size && given != 1)
    return refuse(site.method, {std::to_string(size), " components were expected, but ",
                                std::to_string(given), " came."});
  return fill(graph_, vectorOf(size), [&](int i) { return (*parts)[given == 1 ? 0 : i]; });
}

std::optional<Value> Builder::makeMatrix(int size, bool ofRows, const Site& site) {
  if (!ofRows && operands_.size() == 1 && operands_[0].shape().isMatrix())
    return resize(operands_[0], size);
  const auto parts = components(site);
  if (!parts) return std::nullopt;
  if (parts->size() == 1) return diagonal(size, (*parts)[0]);
  const bool ofNumbers = operands_.size() == parts->size();
  for (const Value& operand : operands_) {
    if (ofNumbers || operand.shape() == vectorOf(size)) continue;
    return refuse(site.method, {std::to_string(size), ofRows ? " rows" : " columns",
                                " of as many components were expected, but ",
                                shapeName(operand.shape()), " came."});
  }
  if (static_cast<int>(parts->size()) != size * size)
    return refuse(site.method, {std::to_string(size * size), " components were expected, but ",
                                std::to_string(parts->size()), " came."});
  const Value matrix = fill(graph_, matrixOf(size, size), [&](int i) { return (*parts)[i]; });
  return ofRows ? transpose(matrix) : matrix;
}

// As GLSL does it: cut off, or filled up from the unit matrix.
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
    return refuse(site.method,
                  {site.place(0), " must be a matrix, but is ", shapeName(shape), "."});
  const int count = isRow ? shape.rows : shape.columns;
  for (int i = 0; i < count; ++i) {
    if (isConstant(operands_[1], i)) return isRow ? matrix.row(i) : matrix.column(i);
  }
  return refuse(site.method, {site.place(1), " must be a whole number from 0 to ",
                              std::to_string(count - 1), "."});
}

}  // namespace warpjet
