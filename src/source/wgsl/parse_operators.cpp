// The types and values of operators: WGSL, sections 8.6 to 8.9.
#include <array>

#include "source/typing.hpp"
#include "source/wgsl/abstract.hpp"
#include "source/wgsl/parser.hpp"

namespace warpjet::source::wgsl {

namespace {

bool isShift(Operator op) { return op == Operator::ShiftLeft || op == Operator::ShiftRight; }
bool isComparison(Operator op) { return op >= Operator::Equal && op <= Operator::AtLeast; }

}  // namespace

// Gives two operands the same number type if one or both are abstract. Returns false if that is
// impossible.
bool Parser::unify(Operand& left, Operand& right) {
  if (left.isAbstract() == right.isAbstract()) {
    if (left.isAbstract() && left.type.base != right.type.base)
      left.type.base = right.type.base = Base::Float;
    return true;
  }
  Operand& abstract = left.isAbstract() ? left : right;
  const Operand& other = left.isAbstract() ? right : left;
  Type wanted = abstract.type;
  wanted.base = other.type.base;
  if (!other.type.isNumeric() || !canConvert(abstract, wanted)) return false;
  abstract = {.id = convert(abstract, wanted, peek().location), .type = wanted};
  return true;
}

std::optional<Type> Parser::typeOfBinary(Operator op, Type left, Type right) const {
  using enum Operator;
  if (!left.isNumeric() || !right.isNumeric()) return std::nullopt;
  const bool isSame = left == right;
  const bool isBool = left.base == Base::Bool;
  if (op == And || op == Or)
    return isSame && left.isBool() ? std::optional(boolType) : std::nullopt;
  if (isComparison(op)) {
    if (!isSame || left.isMatrix() || (isBool && op != Equal && op != Unequal)) return std::nullopt;
    return vectorType(Base::Bool, left.rows);
  }
  if (isShift(op)) {
    if (!left.isInteger() || right.base != Base::Uint || left.rows != right.rows)
      return std::nullopt;
    return left;
  }
  if (op == BitAnd || op == BitOr)
    return isSame && (isBool || left.isInteger()) ? std::optional(left) : std::nullopt;
  if (op == BitXor) return isSame && left.isInteger() ? std::optional(left) : std::nullopt;
  const bool hasMatrix = left.isMatrix() || right.isMatrix();
  if (hasMatrix && op != Multiply)
    return isSame && (op == Add || op == Subtract) ? std::optional(left) : std::nullopt;
  // The remainder has the types of a sum.
  return source::typeOfBinary(op == Remainder ? Add : op, left, right, tree_.types);
}

Operand Parser::makeBinary(Operator op, Operand left, Operand right, Location location) {
  left = load(left, location);
  right = load(right, location);
  if (problems_.any()) return failOperand(location, "");
  const Operand a = left, b = right;
  if (isShift(op)) {
    // The count is a u32, whatever the other operand is.
    Type wanted = right.type;
    wanted.base = Base::Uint;
    if (right.isAbstract() && canConvert(right, wanted) && !left.isAbstract())
      right = {.id = convert(right, wanted, location), .type = wanted};
    else if (!right.isAbstract() && left.isAbstract())
      left = concrete(left, location);
  }
  const bool areAbstract = left.isAbstract() && right.isAbstract();
  const bool fits = isShift(op) || unify(left, right);
  if (areAbstract && isShift(op) && right.type.base == Base::Int) right.type.base = Base::Uint;
  const auto type = fits && !a.isPointer() && !b.isPointer()
                        ? typeOfBinary(op, left.type, right.type)
                        : std::nullopt;
  if (problems_.any()) return failOperand(location, "");
  if (!type) {
    const bool mixes = a.type.isNumeric() && b.type.isNumeric() && a.type.base != b.type.base &&
                       a.type.base != Base::Bool && b.type.base != Base::Bool;
    const std::string wanted = nameOf(scalarOf(a.isAbstract() ? b.type.base : a.type.base));
    const std::string advice =
        isShift(op) && a.type.isInteger() ? "; the number of bits must be a u32: write u32(n)"
        : mixes ? "; WGSL has no implicit conversions: write " + wanted + "(x)"
                : "";
    return failOperand(location, quote(textOf(op)) + " does not take " + describe(a) + " and " +
                                     describe(b) + advice);
  }
  if (areAbstract) {
    const auto numbers = foldAbstract(op, left, right, *type);
    if (!numbers)
      return failOperand(location, op == Operator::Divide || op == Operator::Remainder
                                       ? "this divides by zero"
                                       : "this value is too large");
    if (type->base != Base::Bool) return abstractOf(*type, *numbers, location);
    return {.id = constantOf(*type, numbers->data(), location), .type = *type};
  }
  checkKnown(op, right, location);
  if (isComparison(op) && !left.type.isScalar()) return compare(op, left, right, location);
  return make({.kind = Code::Binary,
               .op = op,
               .type = *type,
               .location = location,
               .operands = {left.id, right.id}});
}

// Rejects a constant divisor of zero, and a constant shift by 32 or more.
void Parser::checkKnown(Operator op, const Operand& right, Location location) {
  const bool divides = op == Operator::Divide || op == Operator::Remainder;
  if (!right.type.isInteger() || (!divides && !isShift(op))) return;
  for (const std::int32_t number : constants_.integers(right.id)) {
    if (divides && number == 0) fail(location, "this divides by zero");
    if (isShift(op) && (number < 0 || number > 31))
      fail(location, "expected a shift by 0 to 31 bits");
  }
}

// Compares vectors component by component.
Operand Parser::compare(Operator op, const Operand& left, const Operand& right, Location location) {
  const Type types[]{left.type, right.type};
  const auto found = findBuiltIn(tree_.builtIns, textOf(op), types);
  return make({.kind = Code::BuiltIn,
               .type = found->result,
               .index = found->row,
               .location = location,
               .operands = {left.id, right.id}});
}

Operand Parser::makeUnary(const Token& symbol, Operand operand) {
  const Type type = operand.type;
  const bool isNumbers = type.isNumeric() && !type.isMatrix() && !operand.isPointer();
  const bool fits =
      isNumbers && (symbol.is("!")   ? type.base == Base::Bool
                    : symbol.is("~") ? type.isInteger()
                                     : type.base == Base::Int || type.base == Base::Float);
  if (!fits)
    return failOperand(symbol.location, quote(symbol.text) + " does not take " + describe(operand));
  if (operand.isAbstract()) {
    for (double& number : operand.known) number = symbol.is("-") ? -number : -number - 1;
    return abstractOf(type, std::move(operand.known), symbol.location);
  }
  if (symbol.is("!") && !type.isScalar())
    return make({.kind = Code::BuiltIn,
                 .type = type,
                 .index = findBuiltIn(tree_.builtIns, "!", std::array{type})->row,
                 .location = symbol.location,
                 .operands = {operand.id}});
  return make({.kind = symbol.is("-")   ? Code::Negate
                       : symbol.is("!") ? Code::Not
                                        : Code::Complement,
               .type = type,
               .location = symbol.location,
               .operands = {operand.id}});
}

}  // namespace warpjet::source::wgsl
