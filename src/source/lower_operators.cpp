// Lowers binary operators, component by component.
#include <algorithm>

#include "source/lower.hpp"

namespace warpjet::source {

Id Lowering::equal(const Value& x, const Value& y) {
  Id all = number(Base::Bool, 1);
  for (std::size_t i = 0; i < x.size(); ++i)
    all = recorder_.logicalAnd(all, scalar(Operator::Equal, recorder_.base(x[i]), x[i], y[i]));
  return all;
}

Lowering::Value Lowering::binary(Operator op, Type a, const Value& x, Type b, const Value& y) {
  if (op == Operator::Equal) return {equal(x, y)};
  if (op == Operator::Unequal) return {recorder_.logicalNot(equal(x, y))};
  const bool isLinear = !a.isScalar() && !b.isScalar() && (a.isMatrix() || b.isMatrix());
  if (op == Operator::Multiply && isLinear) return product(a, x, b, y);
  Value value;
  for (std::size_t i = 0; i < std::max(x.size(), y.size()); ++i)
    value.push_back(scalar(op, a.base, x.size() == 1 ? x[0] : x[i], y.size() == 1 ? y[0] : y[i]));
  return value;
}

Lowering::Value Lowering::product(Type a, const Value& x, Type b, const Value& y) {
  const int rows = a.isMatrix() ? a.rows : 1, inner = a.isMatrix() ? a.columns : a.rows;
  const int columns = b.isMatrix() ? b.columns : 1;
  Value value;
  for (int c = 0; c < columns; ++c)
    for (int r = 0; r < rows; ++r) {
      Id sum{};
      for (int k = 0; k < inner; ++k) {
        const Id left = a.isMatrix() ? x[k * rows + r] : x[k];
        const Id term = scalar(Operator::Multiply, Base::Float, left, y[c * inner + k]);
        sum = k == 0 ? term : scalar(Operator::Add, Base::Float, sum, term);
      }
      value.push_back(sum);
    }
  return value;
}

// Returns x - y trunc(x / y), as in WGSL; GLSL has % for integers only.
Id Lowering::floatRemainder(Id x, Id y) {
  const Id times =
      recorder_.apply(Code::Trunc, Base::Float, {scalar(Operator::Divide, Base::Float, x, y)});
  return scalar(Operator::Subtract, Base::Float, x,
                scalar(Operator::Multiply, Base::Float, y, times));
}

Id Lowering::scalar(Operator op, Base base, Id x, Id y) {
  using enum Operator;
  const auto apply = [&](Code code, Base result, Id a, Id b) {
    return recorder_.apply(code, result, {a, b});
  };
  if (base == Base::Bool) {
    if (op == BitAnd) return recorder_.logicalAnd(x, y);
    if (op == BitOr) return recorder_.logicalOr(x, y);
    const Id same =
        recorder_.logicalOr(recorder_.logicalAnd(x, y),
                            recorder_.logicalAnd(recorder_.logicalNot(x), recorder_.logicalNot(y)));
    return op == Xor || op == Unequal ? recorder_.logicalNot(same) : same;
  }
  const bool isFloat = base == Base::Float, isUint = base == Base::Uint;
  const auto either = [&](Code floatCode, Code intCode) { return isFloat ? floatCode : intCode; };
  const Code less = isUint ? Code::UintLt : Code::IntLt;
  switch (op) {
    case Add:
      return apply(either(Code::Add, Code::IntAdd), base, x, y);
    case Subtract:
      return apply(either(Code::Sub, Code::IntSub), base, x, y);
    case Multiply:
      return apply(either(Code::Mult, Code::IntMult), base, x, y);
    case Divide:
      return apply(isFloat ? Code::Div : isUint ? Code::UintDiv : Code::IntDiv, base, x, y);
    case Remainder:
      if (isFloat) return floatRemainder(x, y);
      return apply(isUint ? Code::UintMod : Code::IntMod, base, x, y);
    case BitAnd:
      return apply(Code::BitAnd, base, x, y);
    case BitOr:
      return apply(Code::BitOr, base, x, y);
    case BitXor:
      return apply(Code::BitXor, base, x, y);
    case ShiftLeft:
      return apply(Code::ShiftLeft, base, x, y);
    case ShiftRight:
      return apply(isUint ? Code::UintShiftRight : Code::ShiftRight, base, x, y);
    case Less:
      return apply(either(Code::Lt, less), Base::Bool, x, y);
    case Greater:
      return isFloat ? apply(Code::Gt, Base::Bool, x, y) : apply(less, Base::Bool, y, x);
    case AtMost:
      return isFloat ? apply(Code::Le, Base::Bool, x, y)
                     : recorder_.logicalNot(apply(less, Base::Bool, y, x));
    case AtLeast:
      return isFloat ? apply(Code::Ge, Base::Bool, x, y)
                     : recorder_.logicalNot(apply(less, Base::Bool, x, y));
    case Equal:
      return apply(either(Code::Eq, Code::IntEq), Base::Bool, x, y);
    case Unequal:
      return isFloat ? apply(Code::Ne, Base::Bool, x, y)
                     : recorder_.logicalNot(apply(Code::IntEq, Base::Bool, x, y));
    default:
      return x;
  }
}

}  // namespace warpjet::source
