// A number, vector or matrix of nodes that behaves like one: `incident - normal * 2.0`.
//
// Operations are componentwise, and numbers are broadcast to vectors and matrices. Shapes must
// match, which src/builder ensures. `Expression` is the equivalent for single numbers.
#pragma once

#include <array>
#include <span>

#include "graph/expression.hpp"

namespace warpjet {

class Value {
 public:
  Value(Graph& graph, Shape shape) : graph_(&graph), shape_(shape) {}
  Value(Expression number) : graph_(number.graph) { nodes_[0] = number.id; }

  Graph& graph() const { return *graph_; }
  Shape shape() const { return shape_; }
  int size() const { return shape_.size(); }

  // Components of a matrix are stored column by column.
  std::span<const NodeId> nodes() const {
    return std::span(nodes_).first(static_cast<std::size_t>(size()));
  }
  void set(int i, NodeId node) { nodes_[i] = node; }
  void set(int column, int row, Expression entry) { set(column * shape_.rows + row, entry.id); }
  Expression operator[](int i) const { return {graph_, nodes_[i]}; }
  Expression at(int column, int row) const { return (*this)[column * shape_.rows + row]; }

  Value column(int i) const;
  Value row(int i) const;

 private:
  Graph* graph_;
  Shape shape_;
  std::array<NodeId, maxComponents> nodes_{};
};

// Builds a value component by component.
template <class Component>
Value fill(Graph& graph, Shape shape, Component component) {
  Value value(graph, shape);
  for (int i = 0; i < shape.size(); ++i) value.set(i, component(i).id);
  return value;
}

// Builds a matrix from a function of column and row.
template <class Entry>
Value fillMatrix(Graph& graph, int columns, int rows, Entry entry) {
  return fill(graph, matrixOf(columns, rows), [&](int i) { return entry(i / rows, i % rows); });
}

Value byComponent(Op op, std::span<const Value> operands);

inline Value constantLike(const Value& v, double value) {
  return Expression{&v.graph(), v.graph().constant(value)};
}

inline Value operator+(const Value& x, const Value& y) {
  return byComponent(ops::find("add"), std::array{x, y});
}
inline Value operator-(const Value& x, const Value& y) {
  return byComponent(ops::find("sub"), std::array{x, y});
}
inline Value operator*(const Value& x, const Value& y) {
  return byComponent(ops::find("mult"), std::array{x, y});
}
inline Value operator/(const Value& x, const Value& y) {
  return byComponent(ops::find("div"), std::array{x, y});
}
inline Value operator-(const Value& x) { return byComponent(ops::find("neg"), std::array{x}); }
inline Value operator*(const Value& x, double y) { return x * constantLike(x, y); }

}  // namespace warpjet
