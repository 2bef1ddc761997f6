// Constructors: WGSL, section 17.1.
#include <algorithm>
#include <cmath>

#include "source/wgsl/parser.hpp"

namespace warpjet::source::wgsl {

// Parses the arguments of a call, from the opening to the closing parenthesis.
Parser::Operands Parser::arguments() {
  Operands all;
  // All other callers have already seen the parenthesis.
  expect("(", "bitcast<…>");
  while (!peek().is(")") && !problems_.any()) {
    all.push_back(value());
    if (!accept(",")) break;
  }
  expect(")", "the arguments");
  return all;
}

// Parses a type and its arguments; `vec3(…)` and `array(…)` get their type from the arguments.
Operand Parser::construct(Location location) {
  const Token word = peek();
  const bool isInferred = isGenerator(word.text) && !isDeclared(word.text) && !peek(1).is("<");
  if (isInferred) {
    take();
    if (!peek().is("(")) return failOperand(location, "expected a value, got a type");
    Operands operands = arguments();
    if (problems_.any()) return failOperand(location, "");
    for (const Operand& each : operands)
      if (each.isPointer())
        return failOperand(location, "expected numbers and vectors for " + std::string(word.text) +
                                         ", got a pointer");
    if (word.is("array")) return inferredArray(std::move(operands), location);
    const bool isVector = word.text[0] == 'v';
    const int columns = isVector ? 1 : word.text[3] - '0';
    return inferred(word, columns, word.text[isVector ? 3 : 5] - '0', std::move(operands));
  }
  const Type parsed = type();
  if (problems_.any()) return failOperand(location, "");
  if (!peek().is("(")) return failOperand(location, "expected a value, got a type");
  Operands operands = arguments();
  if (problems_.any()) return failOperand(location, "");
  if (operands.empty()) return zero(parsed, location);
  return constructType(parsed, std::move(operands), location);
}

// Returns the number type that all operands have or can be converted to; nullopt if there is none.
std::optional<Type> Parser::commonType(const Operands& operands) const {
  std::optional<Type> common;
  for (const Operand& each : operands)
    if (!each.isAbstract()) common = scalarOf(each.type.base);
  if (!common) {
    common = intType;
    for (const Operand& each : operands)
      if (each.type.base == Base::Float) common = floatType;
  }
  for (const Operand& each : operands) {
    Type wanted = each.type;
    wanted.base = common->base;
    if (!each.type.isNumeric() || !canConvert(each, wanted)) return std::nullopt;
  }
  return common;
}

// Constructs a vector or matrix whose name lacks the type of its components, as in vec3(…).
Operand Parser::inferred(const Token& word, int columns, int rows, Operands operands) {
  const std::string name(word.text);
  if (operands.empty()) {
    if (columns > 1) return failOperand(word.location, "write " + name + "f() for a zero matrix");
    return abstractOf(vectorType(Base::Int, rows),
                      std::vector<double>(static_cast<std::size_t>(rows)), word.location);
  }
  // Without a component type in the name, only abstract numbers are converted: vec3f(v) accepts a
  // vec3i, but vec3(1f, 2i, 3) is an error.
  const auto common = commonType(operands);
  if (!common)
    return failOperand(word.location, "expected numbers of one type for " + name + ", got (" +
                                          typesOf(operands) +
                                          "); WGSL has no implicit conversions");
  bool areAbstract = columns == 1;
  int count = 0;
  for (const Operand& each : operands) {
    areAbstract = areAbstract && each.isAbstract();
    count += each.type.components();
  }
  const Type type = columns > 1 ? matrixType(columns, rows) : vectorType(common->base, rows);
  if (!areAbstract || (count != rows && !(operands.size() == 1 && count == 1)))
    return constructType(type, std::move(operands), word.location);
  std::vector<double> numbers;
  for (const Operand& each : operands)
    numbers.insert(numbers.end(), each.known.begin(), each.known.end());
  numbers.resize(static_cast<std::size_t>(rows), numbers[0]);
  return abstractOf(type, std::move(numbers), word.location);
}

// Constructs array(…), whose type and length follow from its operands.
Operand Parser::inferredArray(Operands operands, Location location) {
  if (operands.empty())
    return failOperand(location, "an empty array needs its type: write array<f32, 4>()");
  bool areAbstract = true;
  for (const Operand& each : operands)
    areAbstract = areAbstract && each.isAbstract() && !each.type.isArray();
  const auto length = static_cast<std::int32_t>(operands.size());
  Type element = operands[0].type;
  for (const Operand& each : operands) {
    if (!each.isAbstract()) element = each.type;
    if (areAbstract && each.type.base == Base::Float) element.base = Base::Float;
  }
  if (areAbstract) {
    std::vector<double> numbers;
    for (const Operand& each : operands) {
      if (each.type.rows != element.rows)
        return failOperand(location,
                           "expected array elements of one type, got (" + typesOf(operands) + ")");
      numbers.insert(numbers.end(), each.known.begin(), each.known.end());
    }
    return abstractOf(arrayOf(element, length), std::move(numbers), location);
  }
  return constructType(arrayOf(element, length), std::move(operands), location);
}

Operand Parser::constructScalar(Type type, const Operand& operand, Location location) {
  if (!operand.type.isScalar())
    return failOperand(location,
                       "a " + nameOf(type) + " cannot be constructed from " + describe(operand));
  if (!operand.isAbstract())
    return make(
        {.kind = Code::Construct, .type = type, .location = location, .operands = {operand.id}});
  if (type == boolType)
    return make({.kind = Code::Constant,
                 .type = type,
                 .value = operand.known[0] == 0 ? 0.0 : 1.0,
                 .location = location});
  Operand whole = operand;
  if (type.isInteger() && operand.type.base == Base::Float) {
    whole.type.base = Base::Int;
    // A float beyond the range becomes the nearest value.
    const double min = type == intType ? -2147483648.0 : 0;
    const double max = type == intType ? 2147483647.0 : 4294967295.0;
    whole.known[0] = std::trunc(std::clamp(operand.known[0], min, max));
  }
  return {.id = convert(whole, type, location), .type = type};
}

Operand Parser::constructType(Type type, Operands operands, Location location) {
  const std::string name = nameOf(type);
  std::vector<ExpressionId> parts;
  const auto constructFromParts = [&](std::size_t partCount, const auto& typeOfPart,
                                      const char* partName) -> Operand {
    if (operands.size() != partCount)
      return failOperand(location, "expected " + std::to_string(partCount) + " " + partName +
                                       (partCount == 1 ? "" : "s") + " for " + name + ", got " +
                                       std::to_string(operands.size()));
    for (std::size_t i = 0; i < partCount; ++i) {
      if (!canConvert(operands[i], typeOfPart(i)))
        return failOperand(location, "expected " + describe(typeOfPart(i)) + " as " + partName +
                                         ' ' + std::to_string(i + 1) + " of " + name + ", got " +
                                         describe(operands[i]));
      parts.push_back(convert(operands[i], typeOfPart(i), location));
    }
    return make({.kind = Code::Construct,
                 .type = type,
                 .location = location,
                 .operands = std::move(parts)});
  };
  if (type.isArray()) {
    if (type.length == 0)
      return failOperand(location, "this array needs a length: write array<" +
                                       nameOf(type.element()) + ", " +
                                       std::to_string(operands.size()) + ">(…)");
    Type element = type.element();
    // An array in an array is stored as the only field of a structure without a name (see arrayOf).
    const bool isWrappedArray = element.isStruct() && tree_.types.structure(element).name.empty();
    if (isWrappedArray) element = tree_.types.structure(element).fields[0].type;
    return constructFromParts(
        static_cast<std::size_t>(type.length), [&](std::size_t) { return element; }, "element");
  }
  if (type.isStruct()) {
    const std::vector<Field> fields = tree_.types.structure(type).fields;
    return constructFromParts(
        fields.size(), [&](std::size_t i) { return fields[i].type; }, "field");
  }
  for (const Operand& each : operands)
    if (!each.type.isNumeric() || each.isPointer())
      return failOperand(location,
                         "expected numbers and vectors for " + name + ", got " + describe(each));
  if (type.isScalar()) {
    if (operands.size() > 1)
      return failOperand(
          location, "expected one value for " + name + ", got " + std::to_string(operands.size()));
    return constructScalar(type, operands[0], location);
  }
  const Operand& first = operands[0];
  const bool isSingle = operands.size() == 1;
  // Converts a vector or matrix of the same size.
  if (isSingle && !first.isAbstract() && first.type.layout() == type.layout())
    return make(
        {.kind = Code::Construct, .type = type, .location = location, .operands = {first.id}});
  int count = 0;
  bool areColumns = true;
  for (const Operand& each : operands) {
    Type part = each.type;
    part.base = type.base;
    if (each.type.isMatrix() || !canConvert(each, part))
      return failOperand(location, "expected components of type " + nameOf(scalarOf(type.base)) +
                                       " for " + name + ", got " + describe(each));
    areColumns = areColumns && each.type.rows == type.rows;
    count += each.type.components();
    parts.push_back(convert(each, part, location));
  }
  const bool isSplat = isSingle && first.type.isScalar() && type.isVector();
  const bool mixesColumns =
      type.isMatrix() && !areColumns && count != static_cast<int>(operands.size());
  if (count != type.components() && !isSplat)
    return failOperand(location, "expected " + std::to_string(type.components()) +
                                     " components for " + name + ", got " + std::to_string(count));
  if (mixesColumns)
    return failOperand(location, name + " is constructed from its columns, or from numbers");
  return make(
      {.kind = Code::Construct, .type = type, .location = location, .operands = std::move(parts)});
}

}  // namespace warpjet::source::wgsl
