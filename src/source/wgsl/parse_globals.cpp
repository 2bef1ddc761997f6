// Declarations outside of functions, and constants.
#include <utility>

#include "source/wgsl/keywords.hpp"
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
  const Location start = peek().place;
  int open = 0;
  while (peek().kind != Token::Kind::End) {
    const Token token = take();
    const bool opens = token.is("(") || token.is("{") || token.is("[");
    const bool closes = token.is(")") || token.is("}") || token.is("]");
    if (closes && open == 0) return fail(token.place, quoted(token.text) + " closes nothing");
    open += opens ? 1 : closes ? -1 : 0;
    if (open == 0 && token.is(end)) return;
  }
  if (!problems_.any())
    fail(end == "}" ? start : peek().place, "expected " + std::string(end) +
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
      return fail(word.place,
                  word.is("let") ? "let is for functions; write const"
                  : isDirective
                      ? quoted(word.text) + " must come before all declarations"
                      : "expected fn, struct, const, var or another declaration, " +
                            describeNext() +
                            (word.is("uniform") || word.is("varying") || word.is("precision") ||
                                     word.is("void") || word.is("float") || word.is("vec3")
                                 ? "; this looks like GLSL, which glslOffset reads"
                                 : ""));
    }
    take();
    if (word.is("var") && accept("<"))
      while (!accept(">") && peek().kind != Token::Kind::End) take();
    const Token name = takeName(word.text);
    if (problems_.any()) return;
    if (!globals_.emplace(name.text, Global{name.text, name.place, start, keyword}).second)
      return fail(name.place, quoted(name.text) + " is already declared");
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

void Parser::declareGlobally(VariableId variable, ExpressionId start) {
  tree_.variables[variable].start = start;
  tree_.globals.push_back(add(Statement{.kind = Statement::Kind::Declare,
                                        .index = variable,
                                        .expression = start,
                                        .place = tree_.variables[variable].place}));
}

// The type of a variable by its declaration or its initial value.
Type Parser::initialType(const std::optional<DeclaredType>& declared, const Operand& value,
                         Location place, std::string_view name) {
  if (problems_.any()) return floatType;
  if (!declared) {
    if (value.type == voidType) fail(place, "expected a value for " + quoted(name) + ", got none");
    return value.type;
  }
  if (!declared->unsupported.empty()) fail(place, declared->unsupported);
  if (!problems_.any() && !canConvert(value, declared->type))
    fail(place, "expected " + describe(declared->type) + " as the value of " + quoted(name) +
                    ", got " + describe(value));
  return declared->type;
}

// A constant stays abstract unless it has a type; `statement` declares it in a function.
Entity Parser::constant(const Token& name, const std::optional<DeclaredType>& declared,
                        Operand value, StatementId* statement) {
  if (!problems_.any() && !value.isAbstract() &&
      (value.id == nothing || !constants_.isConstant(value.id)))
    fail(name.place, quoted(name.text) +
                         " is const, but its value is known only when the shader runs; write let");
  const Type made = initialType(declared, value, name.place, name.text);
  if (problems_.any()) return {};
  Entity entity{.kind = Entity::Kind::Value};
  if (value.isAbstract() && !declared) {
    entity.value = std::move(value);
    return entity;
  }
  const ExpressionId start = convert(value, made, name.place);
  if (problems_.any()) return {};
  if (made.isInteger() && constants_.integers(start).empty())
    fail(name.place, "the value of " + quoted(name.text) + " does not exist");
  const VariableId variable = addVariable(name.text, made, Variable::Kind::Constant, name.place);
  tree_.variables[variable].start = start;
  entity.value.type = made;
  entity.value.id =
      add(Expression{.kind = Code::Variable, .type = made, .index = variable, .place = name.place});
  const StatementId declares = add(Statement{.kind = Statement::Kind::Declare,
                                             .index = variable,
                                             .expression = start,
                                             .place = name.place});
  if (statement)
    *statement = declares;
  else
    tree_.globals.push_back(declares);
  return entity;
}

Entity Parser::globalConstant() {
  const Token name = takeName("a constant");
  std::optional<DeclaredType> declared;
  if (accept(":")) declared = declaredType();
  if (!accept("=")) fail(peek().place, "the constant " + quoted(name.text) + " needs a value");
  Operand given = value();
  expect(";", "a constant");
  return constant(name, declared, std::move(given), nullptr);
}

// The pipeline may set another value than the default one, so it is an input.
Entity Parser::overrideConstant() {
  const Token name = takeName("an override");
  std::optional<DeclaredType> declared;
  if (accept(":")) declared = declaredType();
  Operand given{.type = floatType};
  const bool hasValue = accept("=");
  if (hasValue) {
    given = value();
    const Type made = initialType(declared, given, name.place, name.text);
    if (!declared) declared = DeclaredType{made};
  }
  expect(";", "an override");
  if (!declared && !problems_.any())
    fail(name.place, "the override " + quoted(name.text) + " needs a type or a value");
  if (!problems_.any() && !declared->type.isScalar())
    fail(name.place, "an override is a number or a bool, not " + describe(declared->type));
  if (problems_.any()) return {};
  return {.kind = Entity::Kind::Value,
          .value = {.kind = Operand::Kind::Reference,
                    .type = declared->type,
                    .host = std::string(name.text)}};
}

Entity Parser::globalVariable() {
  std::string_view space = "handle";
  bool isWritable = false;
  if (accept("<")) {
    space = take().text;
    if (accept(",")) isWritable = take().text != "read";
    expect(">", "the address space of a var");
  }
  const Token name = takeName("a variable");
  std::optional<DeclaredType> declared;
  if (accept(":")) declared = declaredType();
  std::optional<Operand> start;
  if (accept("=")) start = value();
  expect(";", "a variable");
  if (problems_.any()) return {};
  const auto unsupported = [&](std::string reason) {
    Entity entity{.kind = Entity::Kind::Value,
                  .value = unsupportedMemory(declared->type, name.place, std::move(reason))};
    entity.value.space = space;
    entity.value.texel = declared->texel;
    return entity;
  };
  if (space == "private") {
    if (!declared && !start) fail(name.place, quoted(name.text) + " needs a type or a value");
    if (problems_.any()) return {};
    const Operand given = concrete(start ? *start : zero(declared->type, name.place), name.place);
    const Type made = initialType(declared, start ? *start : given, name.place, name.text);
    const ExpressionId value = declared && start ? convert(*start, made, name.place) : given.id;
    const auto isOverride = [&](VariableId each) {
      return tree_.variables[each].kind == Variable::Kind::Uniform;
    };
    if (!problems_.any() && !constants_.isConstant(value, isOverride))
      fail(name.place, "the value of " + quoted(name.text) +
                           " must be known before the shader runs; assign it in a function");
    if (problems_.any()) return {};
    const Type type = tree_.expressions[value].type;
    const VariableId variable = addVariable(name.text, type, Variable::Kind::Global, name.place);
    declareGlobally(variable, value);
    return {.kind = Entity::Kind::Value,
            .value = {.kind = Operand::Kind::Reference,
                      .isWritable = true,
                      .space = "private",
                      .id = add(Expression{.kind = Code::Variable,
                                           .isAssignable = true,
                                           .type = type,
                                           .index = variable,
                                           .place = name.place}),
                      .type = type}};
  }
  if (!declared) {
    fail(name.place, quoted(name.text) + " needs a type: write : f32, for instance");
    return {};
  }
  if (start) {
    fail(name.place, "the host sets the value of " + quoted(name.text) + "; remove its value");
    return {};
  }
  if (declared->isSampler) {
    // It has no value; only reads of an image name it.
    const VariableId variable =
        addVariable(name.text, voidType, Variable::Kind::Global, name.place);
    return {
        .kind = Entity::Kind::Value,
        .value = {
            .id = add(Expression{
                .kind = Code::Variable, .type = voidType, .index = variable, .place = name.place}),
            .type = voidType}};
  }
  const bool isImage = declared->type == samplerType;
  if (space == "handle" && !isImage) {
    fail(name.place,
         "a variable outside of functions needs an address space: write "
         "var<private> or var<uniform>");
    return {};
  }
  if (!declared->unsupported.empty()) return unsupported(declared->unsupported);
  if (space == "workgroup" || isWritable)
    return unsupported(quoted(name.text) +
                       (isWritable ? " can be written by the shader, so a warp cannot read it; "
                                     "declare it as var<storage, read>"
                                   : " is shared by a workgroup, which vertices do not have"));
  if (space != "uniform" && space != "storage" && space != "handle") {
    fail(name.place,
         "there is no address space " + quoted(space) + " here; write private, uniform or storage");
    return {};
  }
  return {.kind = Entity::Kind::Value,
          .value = {.kind = Operand::Kind::Reference,
                    .space = space,
                    .type = declared->type,
                    .host = std::string(name.text),
                    .texel = declared->texel}};
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
      fail(field.place, "a field cannot be " + describe(each.type));
    if (made.find(field.text))
      fail(field.place, quoted(field.text) + " is already a field of this structure");
    if (problems_.any()) return {};
    if (!made.fields.empty() && made.fields.back().type.length == 0)
      fail(field.place, "only the last field of a structure can be an array without a length");
    made.add({field.text, each.type, made.size});
    made.size += tree_.types.size(each.type);
    if (made.size > maxValueSize) fail(field.place, "this structure is too large");
    if (!accept(",")) break;
  }
  if (accept(";")) fail(peek().place, "fields of a structure are separated by commas");
  const Location end = peek().place;
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
  const Location place = peek().place;
  const Operand test = value();
  expect(";", "const_assert");
  if (problems_.any()) return;
  if (!test.type.isBool() || test.id == nothing || !constants_.isConstant(test.id))
    return fail(place, "expected a constant bool after const_assert, got " + describe(test));
  if (constants_.numbers(test.id) == std::vector<double>{0})
    fail(word.place, "this const_assert does not hold");
}

}  // namespace warpjet::source::wgsl
