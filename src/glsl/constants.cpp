#include "glsl/constants.hpp"

#include <algorithm>
#include <cmath>

namespace warpjet::glsl {

namespace {

// All as doubles, which hold every int and uint; a result is wrapped to 32 bits.
std::optional<double> evaluate(const Tree& tree, ExpressionId number, int depth);

double wrapped(Base base, double value) {
  if (base == Base::Float) return static_cast<float>(value);
  if (base == Base::Bool) return value != 0;
  const auto bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(value));
  return base == Base::Int ? static_cast<double>(static_cast<std::int32_t>(bits)) : bits;
}

std::optional<double> binary(const Tree& tree, const Expression& node, int depth) {
  const auto a = evaluate(tree, node.operands[0], depth),
             b = evaluate(tree, node.operands[1], depth);
  if (!a || !b) return std::nullopt;
  const bool isFloat = node.type.base == Base::Float;
  const auto x = static_cast<std::int64_t>(*a), y = static_cast<std::int64_t>(*b);
  switch (node.op) {
    case Operator::Add:
      return *a + *b;
    case Operator::Subtract:
      return *a - *b;
    // Exact modulo 2^32 where a double is not.
    case Operator::Multiply:
      if (isFloat) return *a * *b;
      return static_cast<double>(static_cast<std::uint32_t>(x) * static_cast<std::uint32_t>(y));
    case Operator::Divide:
      if (isFloat) return *a / *b;
      return y == 0 ? std::nullopt : std::optional(static_cast<double>(x / y));
    case Operator::Remainder:
      return y == 0 ? std::nullopt : std::optional(static_cast<double>(x % y));
    case Operator::ShiftLeft:
      return static_cast<double>(static_cast<std::uint32_t>(x) << (y & 31));
    case Operator::ShiftRight:
      return static_cast<double>(x >> (y & 31));
    case Operator::BitAnd:
      return static_cast<double>(x & y);
    case Operator::BitOr:
      return static_cast<double>(x | y);
    case Operator::BitXor:
      return static_cast<double>(x ^ y);
    case Operator::Less:
      return *a < *b;
    case Operator::Greater:
      return *a > *b;
    case Operator::AtMost:
      return *a <= *b;
    case Operator::AtLeast:
      return *a >= *b;
    case Operator::Equal:
      return *a == *b;
    case Operator::Unequal:
      return *a != *b;
    case Operator::And:
      return *a != 0 && *b != 0;
    case Operator::Or:
      return *a != 0 || *b != 0;
    case Operator::Xor:
      return (*a != 0) != (*b != 0);
  }
  return std::nullopt;
}

std::optional<double> computed(const Tree& tree, const Expression& node, int depth) {
  using enum Expression::Kind;
  const auto operand = [&](std::size_t i) { return evaluate(tree, node.operands[i], depth + 1); };
  switch (node.kind) {
    case Constant:
      return node.value;
    case Variable:
      return tree.variables[node.index].known;
    case Plus:
      return operand(0);
    case Negate:
      if (const auto x = operand(0)) return -*x;
      return std::nullopt;
    case Not:
      if (const auto x = operand(0)) return *x == 0;
      return std::nullopt;
    case Complement:
      if (const auto x = operand(0)) return -*x - 1;
      return std::nullopt;
    case Choose:
      if (const auto x = operand(0)) return operand(*x != 0 ? 1 : 2);
      return std::nullopt;
    case Construct:
      if (node.operands.size() != 1) return std::nullopt;
      if (const auto x = operand(0); x && node.type.isWhole())
        return std::abs(*x) < 4294967296.0 ? std::optional(std::trunc(*x)) : std::nullopt;
      else
        return x;
    case Binary:
      return binary(tree, node, depth + 1);
    default:
      return std::nullopt;
  }
}

std::optional<double> evaluate(const Tree& tree, ExpressionId number, int depth) {
  const Expression& node = tree.expressions[number];
  if (!node.type.isScalar() || depth > 100) return std::nullopt;
  const auto value = computed(tree, node, depth);
  if (!value || !(std::abs(*value) < 9e15)) return std::nullopt;
  return wrapped(node.type.base, *value);
}

}  // namespace

std::optional<double> constantNumber(const Tree& tree, ExpressionId expression) {
  return evaluate(tree, expression, 0);
}

std::optional<std::int32_t> constantInt(const Tree& tree, ExpressionId expression) {
  if (!tree.expressions[expression].type.isWhole()) return std::nullopt;
  const auto value = evaluate(tree, expression, 0);
  if (!value) return std::nullopt;
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::int64_t>(*value)));
}

bool isConstant(const Tree& tree, ExpressionId expression, std::span<const VariableId> others) {
  using enum Expression::Kind;
  std::vector<ExpressionId> open{expression};
  while (!open.empty()) {
    const Expression& node = tree.expressions[open.back()];
    open.pop_back();
    switch (node.kind) {
      case Variable: {
        // A parameter that is const has no value yet.
        const auto& variable = tree.variables[node.index];
        const bool isKnown = variable.kind == Variable::Kind::Constant && variable.start != nothing;
        if (!isKnown && std::find(others.begin(), others.end(), node.index) == others.end())
          return false;
        break;
      }
      case Call:
      case Assign:
      case Increment:
        return false;
      default:
        open.insert(open.end(), node.operands.begin(), node.operands.end());
    }
  }
  return true;
}

}  // namespace warpjet::glsl
