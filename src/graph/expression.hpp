// A graph node that behaves like a number, so that C++ formulas build graphs: `cos(x) * 2.0`. The
// rows of the operation table and the warp formulas are written with it.
#pragma once

#include <concepts>

#include "graph/graph.hpp"

namespace warpjet {

struct Expression {
  Graph* graph;
  NodeId id;
};

template <class T>
concept Operand = std::same_as<T, Expression> || std::same_as<T, double>;

template <class... T>
concept SomeExpression = (Operand<T> && ...) && (std::same_as<T, Expression> || ...);

inline NodeId toNode(Graph&, Expression x) { return x.id; }
inline NodeId toNode(Graph& graph, double x) { return graph.constant(x); }

inline Graph* graphOf(Expression x) { return x.graph; }
inline Graph* graphOf(double) { return nullptr; }

template <class... T>
Expression build(Op op, T... operands) {
  Graph* graph = nullptr;
  ((graph = graph ? graph : graphOf(operands)), ...);
  return {graph, graph->apply(op, {toNode(*graph, operands)...})};
}

inline Expression operator-(Expression x) { return build(ops::find("neg"), x); }

template <class X, class Y>
requires SomeExpression<X, Y> Expression operator+(X x, Y y) {
  return build(ops::find("add"), x, y);
}

template <class X, class Y>
requires SomeExpression<X, Y> Expression operator-(X x, Y y) {
  return build(ops::find("sub"), x, y);
}

template <class X, class Y>
requires SomeExpression<X, Y> Expression operator*(X x, Y y) {
  return build(ops::find("mult"), x, y);
}

template <class X, class Y>
requires SomeExpression<X, Y> Expression operator/(X x, Y y) {
  return build(ops::find("div"), x, y);
}

inline Expression sin(Expression x) { return build(ops::find("sin"), x); }

inline Expression cos(Expression x) { return build(ops::find("cos"), x); }

inline Expression atan(Expression x) { return build(ops::find("atan"), x); }

inline Expression asin(Expression x) { return build(ops::find("asin"), x); }

inline Expression acos(Expression x) { return build(ops::find("acos"), x); }

inline Expression sinh(Expression x) { return build(ops::find("sinh"), x); }

inline Expression cosh(Expression x) { return build(ops::find("cosh"), x); }

inline Expression exp(Expression x) { return build(ops::find("exp"), x); }

inline Expression log(Expression x) { return build(ops::find("log"), x); }

inline Expression sqrt(Expression x) { return build(ops::find("sqrt"), x); }

inline Expression inversesqrt(Expression x) { return build(ops::find("inversesqrt"), x); }

inline Expression abs(Expression x) { return build(ops::find("abs"), x); }

inline Expression sign(Expression x) { return build(ops::find("sign"), x); }

inline Expression floor(Expression x) { return build(ops::find("floor"), x); }

template <class X, class Y>
requires SomeExpression<X, Y> Expression pow(X x, Y y) { return build(ops::find("pow"), x, y); }

template <class X, class Y>
requires SomeExpression<X, Y> Expression atan2(X x, Y y) { return build(ops::find("atan2"), x, y); }

template <class X, class Y>
requires SomeExpression<X, Y> Expression mod(X x, Y y) { return build(ops::find("mod"), x, y); }

template <class X, class Y>
requires SomeExpression<X, Y> Expression min(X x, Y y) { return build(ops::find("min"), x, y); }

template <class X, class Y>
requires SomeExpression<X, Y> Expression max(X x, Y y) { return build(ops::find("max"), x, y); }

template <class X, class Y>
requires SomeExpression<X, Y> Expression step(X x, Y y) { return build(ops::find("step"), x, y); }

template <class X, class Y>
requires SomeExpression<X, Y> Expression lt(X x, Y y) { return build(ops::find("lt"), x, y); }

template <class X, class Y>
requires SomeExpression<X, Y> Expression le(X x, Y y) { return build(ops::find("le"), x, y); }

template <class X, class Y>
requires SomeExpression<X, Y> Expression gt(X x, Y y) { return build(ops::find("gt"), x, y); }

template <class X, class Y>
requires SomeExpression<X, Y> Expression eq(X x, Y y) { return build(ops::find("eq"), x, y); }

template <class X, class Y>
requires SomeExpression<X, Y> Expression ne(X x, Y y) { return build(ops::find("ne"), x, y); }

inline Expression logicalAnd(Expression x, Expression y) { return build(ops::find("and"), x, y); }

inline Expression logicalOr(Expression x, Expression y) { return build(ops::find("or"), x, y); }

inline bool canBeInfinite(Expression x) {
  const Interval range = x.graph->range(x.id);
  return range.canBeInfinite() || range.canBeNaN;
}

inline Expression intDifference(Expression x, Expression y) {
  return build(ops::find("intSub"), x, y);
}

inline Expression intProduct(Expression x, Expression y) {
  return build(ops::find("intMult"), x, y);
}

inline Expression intQuotient(Expression x, Expression y) {
  return build(ops::find("intDiv"), x, y);
}

template <Operand Yes, Operand No>
Expression ifElse(Expression condition, Yes yes, No no) {
  return build(ops::find("ifElse"), condition, yes, no);
}

// Returns a term of a derivative, which contains `factor`. If the factor may be infinite, the
// result is 0 where the condition is false.
inline Expression maskTerm(Expression condition, Expression factor, Expression term) {
  const bool always = condition.graph->range(condition.id).low != 0;
  return always || !canBeInfinite(factor) ? term : ifElse(condition, term, 0.0);
}

}  // namespace warpjet
