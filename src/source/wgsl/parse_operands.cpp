// The operands of operators: names, numbers, and parts of them.
#include "source/typing.hpp"
#include "source/wgsl/keywords.hpp"
#include "source/wgsl/parser.hpp"

namespace warpjet::source::wgsl {

namespace {

// Returns true if no component of a swizzle occurs twice.
bool isDistinct(int packed, int count) {
  unsigned seen = 0;
  for (int i = 0; i < count; ++i) {
    const unsigned bit = 1u << (packed >> (2 * i) & 3);
    if (seen & bit) return false;
    seen |= bit;
  }
  return true;
}

}  // namespace

Operand Parser::postfix(Operand operand) {
  for (;;) {
    const Token& token = peek();
    if (token.is(".")) {
      operand = member(operand);
    } else if (token.is("[")) {
      operand = element(operand);
    } else {
      return operand;
    }
  }
}

Operand Parser::primary() {
  const Token token = peek();
  if (accept("(")) {
    Operand inner = expression();
    expect(")", "an expression");
    return inner;
  }
  if (token.kind == Token::Kind::Number) {
    take();
    const auto number = readNumber(token, problems_);
    if (!number) return failOperand(token.location, "");
    if (number->isAbstract) return {.type = number->type, .known = {number->value}};
    return make({.kind = Code::Constant,
                 .type = number->type,
                 .value = number->value,
                 .location = token.location});
  }
  if (token.kind == Token::Kind::Name) return named();
  if (token.is("++"))
    return failOperand(token.location,
                       quote(token.text) + " is a statement in WGSL; write it on its own");
  return failOperand(token.location, "expected a value, " + describeNext());
}

Operand Parser::named() {
  const Token name = peek();
  if (name.is("true") || name.is("false")) {
    take();
    return make({.kind = Code::Constant,
                 .type = boolType,
                 .value = name.is("true") ? 1.0 : 0.0,
                 .location = name.location});
  }
  if (isKeyword(name.text))
    return failOperand(name.location, "expected a value, " + describeNext());
  if (startsType()) return construct(name.location);
  take();
  if (name.is("bitcast") && !isDeclared(name.text)) return bitcast(name);
  if (peek().is("(")) return call(name);
  const Entity known = resolve(name.text);
  if (problems_.any()) return failOperand(name.location, "");
  switch (known.kind) {
    case Entity::Kind::Value:
      return known.value;
    case Entity::Kind::Unsupported:
      return failOperand(name.location, known.reason);
    case Entity::Kind::Function:
      return failOperand(name.location, quote(name.text) + " is a function; call it with ( )");
    default:
      break;
  }
  if (isBuiltIn(tree_.builtIns, name.text))
    return failOperand(name.location, quote(name.text) + " is a function; call it with ( )");
  return failOperand(name.location, quote(name.text) + " is not declared" + nearestName(name.text));
}

Operand Parser::member(const Operand& given) {
  const Location location = take().location;
  const Token name = peek();
  if (name.kind != Token::Kind::Name)
    return failOperand(name.location,
                       "expected a component or field after the point, " + describeNext());
  take();
  if (problems_.any()) return failOperand(location, "");
  const Operand operand = given.isPointer() ? dereference(given, location) : given;
  const Type type = operand.type;
  if (type.isStruct()) {
    const Field* field = tree_.types.structure(type).find(name.text);
    if (!field || field->name.empty())
      return failOperand(name.location, describe(type) + " has no field " + quote(name.text));
    Operand part = operand;
    part.type = field->type;
    if (operand.id == nothing) {
      part.host += '.' + std::string(name.text);
      return part;
    }
    part.id = add({.kind = Code::Part,
                   .isAssignable = operand.isWritable,
                   .type = field->type,
                   .index = field->offset,
                   .location = location,
                   .operands = {operand.id}});
    return part;
  }
  // WGSL has no s, t, p and q.
  const bool hasLetters = name.text.find_first_not_of("xyzwrgba") == name.text.npos;
  const auto packed =
      type.isVector() && hasLetters ? readSwizzle(name.text, type.rows) : std::nullopt;
  if (!packed)
    return failOperand(name.location, describe(operand) + " has no component " + quote(name.text));
  const Type picked = vectorType(type.base, static_cast<int>(name.text.size()));
  if (operand.isAbstract()) {
    Operand made{.type = picked};
    for (int i = 0; i < picked.rows; ++i)
      made.known.push_back(operand.known[static_cast<std::size_t>(*packed >> (2 * i) & 3)]);
    return made;
  }
  // Components can be assigned unless one of them occurs twice.
  const bool isPart = operand.id != nothing && isDistinct(*packed, picked.rows);
  Operand made = isPart ? operand : load(operand, location);
  made.type = picked;
  made.id = add({.kind = Code::Swizzle,
                 .isAssignable = isPart && operand.isWritable,
                 .type = picked,
                 .index = *packed,
                 .location = location,
                 .operands = {made.id}});
  return made;
}

Operand Parser::element(const Operand& given) {
  const Location location = take().location;
  const Operand index = value();
  expect("]", "an index");
  if (problems_.any()) return failOperand(location, "");
  Operand made =
      elementOf(given.isPointer() ? dereference(given, location) : given, index, location);
  // An array of arrays is represented as an array of structures with a single field.
  const Type type = made.type;
  if (problems_.any() || !type.isStruct() || !tree_.types.structure(type).name.empty()) return made;
  made.type = tree_.types.structure(type).fields[0].type;
  if (made.id != nothing)
    made.id = add({.kind = Code::Part,
                   .isAssignable = made.isWritable,
                   .type = made.type,
                   .location = location,
                   .operands = {made.id}});
  return made;
}

Operand Parser::elementOf(const Operand& whole, const Operand& index, Location location) {
  const Type type = whole.type;
  if (!type.isArray() && !type.isVector() && !type.isMatrix())
    return failOperand(location, describe(whole) + " has no elements");
  if (!canConvert(index, intType) && !canConvert(index, uintType))
    return failOperand(location, "expected an i32 or u32 as index, got " + describe(index));
  const int count = type.isArray() ? type.length : type.isMatrix() ? type.columns : type.rows;
  const auto known = wholeOf(index);
  if (known && (*known < 0 || (*known >= count && count > 0)))
    return failOperand(location, "expected an index from 0 to " + std::to_string(count - 1) +
                                     ", got " + std::to_string(*known));
  const Type one = type.isArray()    ? type.element()
                   : type.isMatrix() ? vectorType(type.base, type.rows)
                                     : scalarOf(type.base);
  if (whole.isAbstract() && known) {
    const auto size = static_cast<std::ptrdiff_t>(tree_.types.size(one));
    const auto first = whole.known.begin() + static_cast<std::ptrdiff_t>(*known) * size;
    return {.type = one, .known = {first, first + size}};
  }
  Operand made = whole;
  made.type = one;
  if (whole.id == nothing && !whole.host.empty() && type.isArray() && known) {
    made.host += '[' + std::to_string(*known) + ']';
    return made;
  }
  if (whole.id == nothing && !whole.host.empty() && type.isArray() && type.length == 0) {
    made.host += "[]";
    made.hostIndices.push_back(concrete(index, location).id);
    return made;
  }
  const Operand from = whole.id == nothing ? concrete(whole, location) : whole;
  if (problems_.any()) return failOperand(location, "");
  made.id = add({.kind = Code::Element,
                 .isAssignable = from.isWritable,
                 .type = one,
                 .location = location,
                 .operands = {from.id, concrete(index, location).id}});
  made.kind = from.kind;
  made.isWritable = from.isWritable;
  made.known.clear();
  made.host.clear();
  return made;
}

Operand Parser::addressOf(const Operand& operand, Location location) {
  if (operand.kind != Operand::Kind::Reference)
    return failOperand(location, "expected a variable after &, got a value");
  if (operand.id != nothing) {
    const Expression& node = tree_.expressions[operand.id];
    const bool isComponent =
        node.kind == Code::Swizzle ||
        (node.kind == Code::Element && tree_.expressions[node.operands[0]].type.isVector());
    if (isComponent)
      return failOperand(location, "a component of a vector has no address; use the whole vector");
  }
  Operand made = operand;
  made.kind = Operand::Kind::Pointer;
  return made;
}

Operand Parser::dereference(const Operand& operand, Location location) {
  if (!operand.isPointer())
    return failOperand(location, "expected a pointer after *, got " + describe(operand));
  Operand made = operand;
  made.kind = Operand::Kind::Reference;
  return made;
}

}  // namespace warpjet::source::wgsl
