#include "algebra/matrices.hpp"

#include <array>

#include "algebra/vectors.hpp"

namespace warpjet {

namespace {

// The rows or columns of a matrix that a minor contains, ascending.
struct Remaining {
  std::array<int, 4> indices{};
  int count = 0;

  static Remaining all(int size) {
    Remaining all;
    while (all.count < size) all.add(all.count);
    return all;
  }
  void add(int i) { indices[count++] = i; }
  Remaining without(int place) const {
    Remaining rest;
    for (int i = 0; i < count; ++i) {
      if (i != place) rest.add(indices[i]);
    }
    return rest;
  }
};

// Returns the minor of these rows and columns by Laplace expansion. The rows of a 4x4 matrix are
// paired as (0, 1) and (2, 3), so that all cofactors share the same twelve 2x2 minors.
Expression minor(const Value& m, const Remaining& rows, const Remaining& columns) {
  if (rows.count == 1) return m.at(columns.indices[0], rows.indices[0]);
  const bool expandsByLast = rows.count == 3 && rows.indices[1] == 1 && m.shape().rows == 4;
  const int place = expandsByLast ? 2 : 0;
  Expression total{&m.graph(), m.graph().constant(0)};
  for (int i = 0; i < columns.count; ++i) {
    const Expression term = m.at(columns.indices[i], rows.indices[place]) *
                            minor(m, rows.without(place), columns.without(i));
    total = (place + i) % 2 == 0 ? total + term : total - term;
  }
  return total;
}

Expression cofactor(const Value& m, int column, int row) {
  const Remaining all = Remaining::all(m.shape().rows);
  const Expression value = minor(m, all.without(row), all.without(column));
  return (column + row) % 2 == 0 ? value : -value;
}

Expression inner(const Value& a, const Value& b, int column, int row) {
  Expression total{&a.graph(), a.graph().constant(0)};
  for (int k = 0; k < a.shape().columns; ++k) total = total + a.at(k, row) * b.at(column, k);
  return total;
}

}  // namespace

Value multiply(const Value& a, const Value& b) {
  if (a.shape().isVector()) return multiply(transpose(b), a);
  return fillMatrix(a.graph(), b.shape().columns, a.shape().rows,
                    [&](int column, int row) { return inner(a, b, column, row); });
}

Value transpose(const Value& m) {
  return fillMatrix(m.graph(), m.shape().rows, m.shape().columns,
                    [&](int column, int row) { return m.at(row, column); });
}

Expression determinant(const Value& m) {
  const Remaining all = Remaining::all(m.shape().rows);
  return minor(m, all, all);
}

Value inverse(const Value& m) {
  const Expression scale = 1.0 / determinant(m);
  return fillMatrix(m.graph(), m.shape().columns, m.shape().rows,
                    [&](int column, int row) { return cofactor(m, row, column) * scale; });
}

Value diagonal(int size, Expression value) {
  const Expression zero{value.graph, value.graph->constant(0)};
  return fillMatrix(*value.graph, size, size,
                    [&](int column, int row) { return column == row ? value : zero; });
}

Value rotationAbout(int axis, Expression angle) {
  const int next = (axis + 1) % 3, last = (axis + 2) % 3;
  Value rotation = diagonal(3, {angle.graph, angle.graph->constant(1)});
  rotation.set(next, next, cos(angle));
  rotation.set(next, last, sin(angle));
  rotation.set(last, next, -sin(angle));
  rotation.set(last, last, cos(angle));
  return rotation;
}

Value rotationAbout(const Value& axis, Expression angle) {
  const Value u = normalize(axis);
  const Expression c = cos(angle), s = sin(angle);
  return fillMatrix(axis.graph(), 3, 3, [&](int column, int row) {
    const Expression symmetric = u[column] * u[row] * (1.0 - c);
    if (column == row) return symmetric + c;
    const Expression skew = u[3 - column - row] * s;
    return (column + 1) % 3 == row ? symmetric + skew : symmetric - skew;
  });
}

}  // namespace warpjet
