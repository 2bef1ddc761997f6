// Operands: loads, conversions of abstract numbers, and names of the host.
#include <algorithm>
#include <cmath>

#include "source/wgsl/parser.hpp"

namespace warpjet::source::wgsl {

namespace {

// Sums may have any length, but trees must not be too deep for the recursion of the lowering.
constexpr int maxTreeDepth = 300;
constexpr double maxFloat = 3.4028235677973366e38;

}  // namespace

ExpressionId Parser::add(Expression made) {
  int depth = 0;
  for (std::size_t i = 0; i < made.operands.size(); ++i) {
    if (made.operands[i] == nothing) made.operands[i] = failOperand(made.location, "").id;
    const int operandDepth = tree_.expressions[made.operands[i]].depth;
    // Left operands of a chain are followed without recursion.
    depth = std::max(depth, made.kind == Code::Binary && i == 0 ? operandDepth : operandDepth + 1);
  }
  if (depth > maxTreeDepth) fail(made.location, "this expression is nested too deep; split it");
  made.depth = static_cast<std::uint16_t>(depth);
  tree_.expressions.push_back(std::move(made));
  return static_cast<ExpressionId>(tree_.expressions.size() - 1);
}

Operand Parser::make(Expression made) {
  const Type type = made.type;
  return {.id = add(std::move(made)), .type = type};
}

// Reports a problem, and returns a placeholder for the expression that couldn't be parsed.
Operand Parser::failOperand(Location location, std::string message) {
  fail(location, std::move(message));
  tree_.expressions.push_back(
      Expression{.kind = Code::Constant, .type = floatType, .location = location});
  return {.id = static_cast<ExpressionId>(tree_.expressions.size() - 1), .type = floatType};
}

Operand Parser::unsupported(Location location, Type type, std::string reason) {
  tree_.reasons.push_back(std::move(reason));
  return make({.kind = Code::Unsupported,
               .type = type,
               .index = static_cast<std::int32_t>(tree_.reasons.size() - 1),
               .location = location});
}

// Makes a variable that a warp can't read: reading it is an error with this reason.
Operand Parser::unsupportedMemory(Type type, Location location, std::string reason) {
  Operand made = unsupported(location, type, std::move(reason));
  made.kind = Operand::Kind::Reference;
  made.isWritable = true;
  tree_.expressions[made.id].isAssignable = true;
  return made;
}

// Declares the uniform with the host's name of this operand. Only parts that are read become
// inputs, since the uniforms of a shader are often one large structure.
Operand Parser::hostVariable(const Operand& operand, Location location) {
  if (operand.type.length == 0 || tree_.types.size(operand.type) == 0)
    return unsupported(location, operand.type,
                       "the length of " + operand.host +
                           " is known only when the shader runs; read its elements by constant "
                           "indices");
  if (!operand.hostIndices.empty()) {
    tree_.made.push_back(operand.host);
    return make({.kind = Code::HostElement,
                 .type = operand.type,
                 .index = static_cast<std::int32_t>(tree_.made.size() - 1),
                 .location = location,
                 .operands = operand.hostIndices});
  }
  const auto known = hostVariables_.find(operand.host);
  if (known == hostVariables_.end()) {
    tree_.made.push_back(operand.host);
    const VariableId variable =
        addVariable(tree_.made.back(), operand.type, Variable::Kind::Uniform, location);
    hostVariables_.emplace(operand.host, variable);
    declareGlobally(variable, nothing);
  }
  return make({.kind = Code::Variable,
               .type = operand.type,
               .index = hostVariables_.at(operand.host),
               .location = location});
}

// Returns the value of a reference; other operands remain as they are.
Operand Parser::load(Operand operand, Location location) {
  if (problems_.any()) return failOperand(location, "");
  if (operand.isPointer()) return operand;
  if (operand.id == nothing && !operand.host.empty()) return hostVariable(operand, location);
  operand.kind = Operand::Kind::Value;
  operand.isWritable = false;
  operand.host.clear();
  operand.hostIndices.clear();
  return operand;
}

// Gives an abstract value its default type, i32 or f32; loads other operands.
Operand Parser::concrete(const Operand& operand, Location location) {
  if (!operand.isAbstract()) return load(operand, location);
  return {.id = convert(operand, operand.type, location), .type = operand.type};
}

bool Parser::canConvert(const Operand& operand, Type type) const {
  if (operand.isPointer()) return false;
  if (!operand.isAbstract()) return operand.type == type;
  Type same = operand.type;
  same.base = type.base;
  if (same != type) return false;
  if (operand.type.base == Base::Float) return type.base == Base::Float;
  return type.base == Base::Float || type.base == Base::Int || type.base == Base::Uint;
}

// Converts an operand to a type, which must be possible; returns the node.
ExpressionId Parser::convert(const Operand& operand, Type type, Location location) {
  if (problems_.any()) return failOperand(location, "").id;
  if (!operand.isAbstract()) return load(operand, location).id;
  for (const double number : operand.known) {
    const bool fits = type.base == Base::Float  ? std::abs(number) <= maxFloat
                      : type.base == Base::Uint ? number >= 0 && number <= 4294967295.0
                                                : number >= -2147483648.0 && number <= 2147483647.0;
    if (fits) continue;
    std::string text = std::to_string(number);
    if (operand.type.base == Base::Int) text = std::to_string(static_cast<std::int64_t>(number));
    return failOperand(location, text + " is not a value of " + nameOf(scalarOf(type.base))).id;
  }
  return constantOf(type, operand.known.data(), location);
}

// Returns the numbers of a scalar, vector, matrix or array of them.
ExpressionId Parser::constantOf(Type type, const double* numbers, Location location) {
  if (type.isScalar())
    return add({.kind = Code::Constant, .type = type, .value = *numbers, .location = location});
  const Type part = type.isArray()    ? type.element()
                    : type.isMatrix() ? vectorType(type.base, type.rows)
                                      : scalarOf(type.base);
  std::vector<ExpressionId> parts;
  const int count = tree_.types.size(type) / tree_.types.size(part);
  for (int i = 0; i < count; ++i)
    parts.push_back(constantOf(part, numbers + i * tree_.types.size(part), location));
  return add(
      {.kind = Code::Construct, .type = type, .location = location, .operands = std::move(parts)});
}

// Returns the zero value of a type; equal parts are one node.
Operand Parser::zero(Type type, Location location) {
  if (problems_.any()) return failOperand(location, "");
  if (type == voidType || type.base == Base::Sampler || type.length == 0)
    return failOperand(location, "there is no value of " + describe(type));
  if (type.isScalar()) return make({.kind = Code::Constant, .type = type, .location = location});
  std::vector<ExpressionId> parts;
  if (type.isArray()) {
    parts.assign(static_cast<std::size_t>(type.length), zero(type.element(), location).id);
  } else if (type.isStruct()) {
    const std::vector<Field> fields = tree_.types.structure(type).fields;
    for (const Field& field : fields) parts.push_back(zero(field.type, location).id);
  } else {
    parts.assign(static_cast<std::size_t>(type.components()),
                 zero(scalarOf(type.base), location).id);
  }
  return make(
      {.kind = Code::Construct, .type = type, .location = location, .operands = std::move(parts)});
}

// Makes an abstract value of computed numbers, which are checked.
Operand Parser::abstractOf(Type type, std::vector<double> numbers, Location location) {
  for (double& number : numbers) {
    if (!std::isfinite(number)) return failOperand(location, "this value is not a finite number");
    if (type.base == Base::Int && std::abs(number) > 9.2e18)
      return failOperand(location, "this whole number is too large");
    // No -0 among whole numbers.
    if (type.base == Base::Int) number += 0.0;
  }
  return {.type = type, .known = std::move(numbers)};
}

// Returns the value of a constant whole number; nullopt if it is unknown.
std::optional<std::int64_t> Parser::constantInteger(const Operand& operand) {
  if (operand.isAbstract())
    return operand.type == intType ? std::optional(static_cast<std::int64_t>(operand.known[0]))
                                   : std::nullopt;
  if (operand.id == nothing || !operand.type.isScalar() || !operand.type.isInteger())
    return std::nullopt;
  const std::vector<double> numbers = constants_.numbers(operand.id);
  return numbers.size() == 1 ? std::optional(static_cast<std::int64_t>(numbers[0])) : std::nullopt;
}

}  // namespace warpjet::source::wgsl
