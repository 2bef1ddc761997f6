#include "source/typing.hpp"

#include <array>

namespace warpjet::source {

namespace {

bool canCompare(Type type, const Types& types) {
  return type.base != Base::Void && !types.hasSampler(type) && !types.isBlock(type) &&
         type.length != 0;
}

std::optional<Type> arithmetic(Operator op, Type left, Type right) {
  if (!left.isNumeric() || !right.isNumeric() || left.base != right.base) return std::nullopt;
  if (left.base == Base::Bool) return std::nullopt;
  if (left.isScalar()) return right;
  if (right.isScalar()) return left;
  if (op == Operator::Multiply && (left.isMatrix() || right.isMatrix())) {
    // A vector before a matrix is a row vector, after it a column vector.
    const int inner = left.isMatrix() ? left.columns : left.rows;
    if (inner != right.rows) return std::nullopt;
    if (!left.isMatrix()) return vectorType(Base::Float, right.columns);
    if (!right.isMatrix()) return vectorType(Base::Float, left.rows);
    return matrixType(right.columns, left.rows);
  }
  if (left != right) return std::nullopt;
  return left;
}

}  // namespace

std::optional<Type> typeOfBinary(Operator op, Type left, Type right, const Types& types) {
  using enum Operator;
  switch (op) {
    case Or:
    case Xor:
    case And:
      if (left.isBool() && right.isBool()) return boolType;
      return std::nullopt;
    case Equal:
    case Unequal:
      if (left == right && canCompare(left, types)) return boolType;
      return std::nullopt;
    case Less:
    case Greater:
    case AtMost:
    case AtLeast:
      if (left == right && left.isScalar() && left.base != Base::Bool) return boolType;
      return std::nullopt;
    case ShiftLeft:
    case ShiftRight:
      if (!left.isInteger() || !right.isInteger()) return std::nullopt;
      if (!right.isScalar() && right.rows != left.rows) return std::nullopt;
      return left;
    case BitOr:
    case BitXor:
    case BitAnd:
    case Remainder:
      if (!left.isInteger()) return std::nullopt;
      return arithmetic(op, left, right);
    default:
      return arithmetic(op, left, right);
  }
}

std::string constructorProblem(Type type, std::span<const Type> operands, const Types& types) {
  const std::string name = types.name(type);
  const auto count = [](std::size_t n, const char* one) {
    return std::to_string(n) + ' ' + one + (n == 1 ? "" : "s");
  };
  const auto wantsEach = [&](std::size_t wanted, const auto& typeAt, const char* what) {
    if (operands.size() != wanted)
      return "expected " + count(wanted, what) + " for " + name + ", got " +
             std::to_string(operands.size());
    for (std::size_t i = 0; i < wanted; ++i)
      if (operands[i] != typeAt(i))
        return "expected " + types.withArticle(typeAt(i)) + " as " + what + ' ' +
               std::to_string(i + 1) + " of " + name + ", got " + types.withArticle(operands[i]);
    return std::string();
  };
  if (types.hasSampler(type)) return "there is no constructor of " + name;
  if (type.isArray() && operands.empty()) return name + "() needs a value in its parentheses";
  if (type.isArray())
    return wantsEach(
        type.length ? type.length : operands.size(), [&](std::size_t) { return type.element(); },
        "element");
  if (type.isStruct()) {
    const auto& fields = types.structure(type).fields;
    return wantsEach(
        fields.size(), [&](std::size_t i) { return fields[i].type; }, "field");
  }
  if (!type.isNumeric()) return "there is no constructor of " + name;
  if (operands.empty()) return name + "() needs a value in its parentheses";
  for (const Type operand : operands)
    if (!operand.isNumeric())
      return "expected numbers and vectors for " + name + ", got " + types.withArticle(operand);
  if (operands.size() == 1) {
    const Type operand = operands[0];
    if (type.isScalar() || operand.isScalar()) return "";
    if (type.isMatrix() && operand.isMatrix()) return "";
    if (!type.isMatrix() && operand.components() >= type.components()) return "";
    if (type == matrixType(2, 2) && operand.components() == 4) return "";
    if (operand == matrixType(2, 2) && type.isVector() && type.rows == 4) return "";
    return "a " + name + " cannot be constructed from " + types.withArticle(operand) + " alone";
  }
  int provided = 0;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (type.isMatrix() && operands[i].isMatrix())
      return "a matrix is constructed from a single matrix, or from numbers and vectors";
    if (provided >= type.components())
      return name + " has " + std::to_string(type.components()) + " components, and argument " +
             std::to_string(i + 1) + " is one too many";
    provided += operands[i].components();
  }
  if (provided < type.components())
    return "expected " + std::to_string(type.components()) + " components for " + name + ", got " +
           std::to_string(provided);
  // The last argument may have more components than needed.
  return "";
}

std::optional<int> readSwizzle(std::string_view letters, int size) {
  constexpr std::array<std::string_view, 3> sets{"xyzw", "rgba", "stpq"};
  if (letters.empty() || letters.size() > 4) return std::nullopt;
  for (const std::string_view set : sets) {
    int packed = 0;
    std::size_t i = 0;
    for (; i < letters.size(); ++i) {
      const auto component = set.find(letters[i]);
      if (component == set.npos || static_cast<int>(component) >= size) break;
      packed |= static_cast<int>(component) << (2 * i);
    }
    if (i == letters.size()) return packed;
  }
  return std::nullopt;
}

}  // namespace warpjet::source
