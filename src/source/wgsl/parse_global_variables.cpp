// Variables and constants outside of functions.
#include "source/wgsl/parser.hpp"

namespace warpjet::source::wgsl {

void Parser::declareGlobally(VariableId variable, ExpressionId start) {
  tree_.variables[variable].start = start;
  tree_.globals.push_back(add(Statement{.kind = Statement::Kind::Declare,
                                        .index = variable,
                                        .expression = start,
                                        .location = tree_.variables[variable].location}));
}

// Returns the type of a variable: that of its declaration, or of its initial value if the
// declaration has no type.
Type Parser::initialType(const std::optional<DeclaredType>& declared, const Operand& value,
                         Location location, std::string_view name) {
  if (problems_.any()) return floatType;
  if (!declared) {
    if (value.type == voidType)
      fail(location, "expected a value for " + quote(name) + ", got none");
    return value.type;
  }
  if (!declared->unsupported.empty()) fail(location, declared->unsupported);
  if (!problems_.any() && !canConvert(value, declared->type))
    fail(location, "expected " + describe(declared->type) + " as the value of " + quote(name) +
                       ", got " + describe(value));
  return declared->type;
}

// Makes a constant, which stays abstract unless it has a type. In a function, `statement` becomes
// its declaration.
Entity Parser::constant(const Token& name, const std::optional<DeclaredType>& declared,
                        Operand value, StatementId* statement) {
  if (!problems_.any() && !value.isAbstract() &&
      (value.id == nothing || !constants_.isConstant(value.id)))
    fail(name.location,
         quote(name.text) +
             " is const, but its value is known only when the shader runs; write let");
  const Type made = initialType(declared, value, name.location, name.text);
  if (problems_.any()) return {};
  Entity entity{.kind = Entity::Kind::Value};
  if (value.isAbstract() && !declared) {
    entity.value = std::move(value);
    return entity;
  }
  const ExpressionId start = convert(value, made, name.location);
  if (problems_.any()) return {};
  if (made.isInteger() && constants_.integers(start).empty())
    fail(name.location, "the value of " + quote(name.text) + " does not exist");
  const VariableId variable = addVariable(name.text, made, Variable::Kind::Constant, name.location);
  tree_.variables[variable].start = start;
  entity.value.type = made;
  entity.value.id = add(Expression{
      .kind = Code::Variable, .type = made, .index = variable, .location = name.location});
  const StatementId declares = add(Statement{.kind = Statement::Kind::Declare,
                                             .index = variable,
                                             .expression = start,
                                             .location = name.location});
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
  if (!accept("=")) fail(peek().location, "the constant " + quote(name.text) + " needs a value");
  Operand given = value();
  expect(";", "a constant");
  return constant(name, declared, std::move(given), nullptr);
}

// Parses an override. It is an input, since the pipeline may set another value than the default.
Entity Parser::overrideConstant() {
  const Token name = takeName("an override");
  std::optional<DeclaredType> declared;
  if (accept(":")) declared = declaredType();
  Operand given{.type = floatType};
  const bool hasValue = accept("=");
  if (hasValue) {
    given = value();
    const Type made = initialType(declared, given, name.location, name.text);
    if (!declared) declared = DeclaredType{made};
  }
  expect(";", "an override");
  if (!declared && !problems_.any())
    fail(name.location, "the override " + quote(name.text) + " needs a type or a value");
  if (!problems_.any() && !declared->type.isScalar())
    fail(name.location, "an override is a number or a bool, not " + describe(declared->type));
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
                  .value = unsupportedMemory(declared->type, name.location, std::move(reason))};
    entity.value.space = space;
    entity.value.texel = declared->texel;
    return entity;
  };
  if (space == "private") {
    if (!declared && !start) fail(name.location, quote(name.text) + " needs a type or a value");
    if (problems_.any()) return {};
    const Operand given =
        concrete(start ? *start : zero(declared->type, name.location), name.location);
    const Type made = initialType(declared, start ? *start : given, name.location, name.text);
    const ExpressionId value = declared && start ? convert(*start, made, name.location) : given.id;
    const auto isOverride = [&](VariableId each) {
      return tree_.variables[each].kind == Variable::Kind::Uniform;
    };
    if (!problems_.any() && !constants_.isConstant(value, isOverride))
      fail(name.location, "the value of " + quote(name.text) +
                              " must be known before the shader runs; assign it in a function");
    if (problems_.any()) return {};
    const Type type = tree_.expressions[value].type;
    const VariableId variable = addVariable(name.text, type, Variable::Kind::Global, name.location);
    declareGlobally(variable, value);
    return {.kind = Entity::Kind::Value,
            .value = {.kind = Operand::Kind::Reference,
                      .isWritable = true,
                      .space = "private",
                      .id = add(Expression{.kind = Code::Variable,
                                           .isAssignable = true,
                                           .type = type,
                                           .index = variable,
                                           .location = name.location}),
                      .type = type}};
  }
  if (!declared) {
    fail(name.location, quote(name.text) + " needs a type: write : f32, for instance");
    return {};
  }
  if (start) {
    fail(name.location, "the host sets the value of " + quote(name.text) + "; remove its value");
    return {};
  }
  if (declared->isSampler) {
    // A sampler has no value; only reads of an image name it.
    const VariableId variable =
        addVariable(name.text, voidType, Variable::Kind::Global, name.location);
    return {.kind = Entity::Kind::Value,
            .value = {.id = add(Expression{.kind = Code::Variable,
                                           .type = voidType,
                                           .index = variable,
                                           .location = name.location}),
                      .type = voidType}};
  }
  const bool isImage = declared->type == samplerType;
  if (space == "handle" && !isImage) {
    fail(name.location,
         "a variable outside of functions needs an address space: write "
         "var<private> or var<uniform>");
    return {};
  }
  if (!declared->unsupported.empty()) return unsupported(declared->unsupported);
  if (space == "workgroup" || isWritable)
    return unsupported(quote(name.text) +
                       (isWritable ? " can be written by the shader, so a warp cannot read it; "
                                     "declare it as var<storage, read>"
                                   : " is shared by a workgroup, which vertices do not have"));
  if (space != "uniform" && space != "storage" && space != "handle") {
    fail(name.location,
         "there is no address space " + quote(space) + " here; write private, uniform or storage");
    return {};
  }
  return {.kind = Entity::Kind::Value,
          .value = {.kind = Operand::Kind::Reference,
                    .space = space,
                    .type = declared->type,
                    .host = std::string(name.text),
                    .texel = declared->texel}};
}

}  // namespace warpjet::source::wgsl
