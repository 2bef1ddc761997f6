// Declarations outside of functions.
#include <utility>

#include "source/wgsl/parser.hpp"

namespace warpjet::source::wgsl {

// Skips `enable …;`, `requires …;` and `diagnostic(…);`, which come first: WGSL, section 4.
void Parser::directives() {
  while (peek().is("enable") || peek().is("requires") || peek().is("diagnostic")) {
    const Token word = take();
    while (!peek().is(";") && peek().kind != Token::Kind::End) take();
    expect(";", word.text);
  }
}

void Parser::skipTo(std::string_view end) {
  const Location start = peek().location;
  int open = 0;
  while (peek().kind != Token::Kind::End) {
    const Token token = take();
    const bool opens = token.is("(") || token.is("{") || token.is("[");
    const bool closes = token.is(")") || token.is("}") || token.is("]");
    if (closes && open == 0) return fail(token.location, quote(token.text) + " closes nothing");
    open += opens ? 1 : closes ? -1 : 0;
    if (open == 0 && token.is(end)) return;
  }
  if (!problems_.any())
    fail(end == "}" ? start : peek().location,
         "expected " + std::string(end) +
             " at the end of this declaration, got the end of "
             "the source");
}

void Parser::findGlobals() {
  while (peek().kind != Token::Kind::End) {
    if (accept(";")) continue;
    const std::size_t start = at_;
    attributes();
    const Token word = peek();
    const std::size_t keyword = at_;
    const bool isBraced = word.is("fn") || word.is("struct");
    const bool isConstant = word.is("const") || word.is("override") || word.is("alias");
    if (word.is("const_assert")) {
      assertions_.push_back(start);
      skipTo(";");
      continue;
    }
    if (!isBraced && !isConstant && !word.is("var")) {
      const bool isDirective = word.is("enable") || word.is("requires") || word.is("diagnostic");
      return fail(word.location,
                  word.is("let") ? "let is for functions; write const"
                  : isDirective
                      ? quote(word.text) + " must come before all declarations"
                      : "expected fn, struct, const, var or another declaration, " +
                            describeNext() +
                            (word.is("uniform") || word.is("varying") || word.is("precision") ||
                                     word.is("void") || word.is("float") || word.is("vec3")
                                 ? "; this looks like GLSL, which glslOffset and differentiate read"
                                 : ""));
    }
    take();
    if (word.is("var") && accept("<"))
      while (!accept(">") && peek().kind != Token::Kind::End) take();
    const Token name = takeName(word.text);
    if (problems_.any()) return;
    if (!globals_.emplace(name.text, Global{name.text, name.location, start, keyword}).second)
      return fail(name.location, quote(name.text) + " is already declared");
    order_.push_back(name.text);
    skipTo(isBraced ? "}" : ";");
  }
}

void Parser::global(Global& found) {
  attributes();
  const Token word = take();
  found.entity = word.is("fn")         ? functionHead()
                 : word.is("struct")   ? structure()
                 : word.is("alias")    ? alias()
                 : word.is("const")    ? globalConstant()
                 : word.is("override") ? overrideConstant()
                                       : globalVariable();
}

Entity Parser::alias() {
  takeName("an alias");
  expect("=", "the name of an alias");
  const Type made = type();
  expect(";", "an alias");
  return {.kind = Entity::Kind::Type, .type = made};
}

Entity Parser::structure() {
  const Token name = takeName("a structure");
  Structure made{.name = name.text};
  std::string unsupported;
  expect("{", "the name of a structure");
  while (!peek().is("}") && !problems_.any()) {
    attributes();
    // Names of fields may be those of types.
    const Token field = takeName("a field");
    expect(":", "the name of a field");
    const DeclaredType each = declaredType();
    if (!each.unsupported.empty()) unsupported = each.unsupported;
    if (each.isPointer || each.isSampler || each.type == samplerType)
      fail(field.location, "a field cannot be " + describe(each.type));
    if (made.find(field.text))
      fail(field.location, quote(field.text) + " is already a field of this structure");
    if (problems_.any()) return {};
    if (!made.fields.empty() && made.fields.back().type.length == 0)
      fail(field.location, "only the last field of a structure can be an array without a length");
    made.add({field.text, each.type, made.size});
    made.size += tree_.types.size(each.type);
    if (made.size > maxValueSize) fail(field.location, "this structure is too large");
    if (!accept(",")) break;
  }
  if (accept(";")) fail(peek().location, "fields of a structure are separated by commas");
  const Location end = peek().location;
  expect("}", "the fields of a structure");
  if (made.fields.empty()) fail(end, "a structure must have a field");
  if (problems_.any()) return {};
  if (!unsupported.empty())
    return {.kind = Entity::Kind::Unsupported, .reason = std::move(unsupported)};
  Type type;
  type.base = Base::Struct;
  type.structure = tree_.types.add(std::move(made));
  return {.kind = Entity::Kind::Type, .type = type};
}

void Parser::constAssert() {
  attributes();
  const Token word = take();
  const Location location = peek().location;
  const Operand test = value();
  expect(";", "const_assert");
  if (problems_.any()) return;
  if (!test.type.isBool() || test.id == nothing || !constants_.isConstant(test.id))
    return fail(location, "expected a constant bool after const_assert, got " + describe(test));
  if (constants_.numbers(test.id) == std::vector<double>{0})
    fail(word.location, "this const_assert does not hold");
}

}  // namespace warpjet::source::wgsl
