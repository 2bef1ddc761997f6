// Functions: their heads, their parameters and their bodies.
#include "source/wgsl/parser.hpp"

namespace warpjet::source::wgsl {

Parameter Parser::parameter(std::vector<Entity>& entities) {
  attributes();
  const Token name = takeName("a parameter");
  if (accept("=")) fail(name.location, "parameters have no default values");
  if (!expect(":", "the name of a parameter")) return {};
  const DeclaredType made = declaredType();
  if (problems_.any()) return {};
  Entity entity{.kind = Entity::Kind::Value};
  if (!made.unsupported.empty()) {
    entity.kind = Entity::Kind::Unsupported;
    entity.reason = made.unsupported;
  }
  if (made.type.length == 0 && !made.isPointer)
    fail(name.location, "a parameter cannot be an array without a length");
  const bool isWritten = made.isPointer && made.isWritable;
  const VariableId variable =
      addVariable(name.text, made.type, Variable::Kind::Parameter, name.location);
  entity.value.kind = made.isPointer ? Operand::Kind::Pointer : Operand::Kind::Value;
  entity.value.isWritable = isWritten;
  if (made.isPointer) entity.value.space = made.space;
  entity.value.type = made.type;
  entity.value.id = add(Expression{.kind = Code::Variable,
                                   .isAssignable = isWritten,
                                   .type = made.type,
                                   .index = variable,
                                   .location = name.location});
  entities.push_back(std::move(entity));
  return {isWritten ? Parameter::Direction::InOut : Parameter::Direction::In, variable, made.type};
}

// Parses a function up to its body. Bodies are parsed later, since they may call functions that are
// declared below.
Entity Parser::functionHead() {
  const Token name = takeName("a function");
  Function made{name.text, voidType, {}, name.location};
  std::vector<Entity> entities;
  expect("(", "the name of a function");
  while (!peek().is(")") && !problems_.any()) {
    made.parameters.push_back(parameter(entities));
    if (!accept(",")) break;
  }
  expect(")", "the parameters of a function");
  if (accept("->")) {
    attributes();
    const Location location = peek().location;
    const DeclaredType result = declaredType();
    made.type = result.type;
    if (result.isPointer || made.type.length == 0 || made.type == samplerType)
      fail(location, "a function cannot return " + describe(made.type));
  }
  if (!peek().is("{") && !problems_.any())
    fail(peek().location,
         "expected { or -> and the type of the result after the parameters, " + describeNext());
  if (problems_.any()) return {};
  tree_.functions.push_back(std::move(made));
  bodies_.push_back(at_);
  parameters_.push_back(std::move(entities));
  return {.kind = Entity::Kind::Function,
          .index = static_cast<FunctionId>(tree_.functions.size() - 1)};
}

void Parser::functionBody(std::size_t index) {
  at_ = bodies_[index];
  current_ = static_cast<FunctionId>(index);
  const Location end = tree_.functions[index].location;
  scopes_.open();
  for (std::size_t i = 0; i < parameters_[index].size(); ++i) {
    const Variable& variable = tree_.variables[tree_.functions[index].parameters[i].variable];
    declare({Token::Kind::Name, variable.name, variable.location}, parameters_[index][i]);
  }
  const StatementId body = makeBlock(peek().location, blockStatements());
  scopes_.close();
  current_ = nothing;
  if (problems_.any()) return;
  Function& function = tree_.functions[index];
  function.body = body;
  constexpr unsigned next = 1;
  if (function.type != voidType && (behaviorOf(body) & next))
    fail(end, "expected " + quote(function.name) + " to return " + describe(function.type) +
                  " at its end, but it may end without a return");
}

void Parser::rejectRecursion() {
  if (const auto call = findRecursion(tree_.functions.size(), calls_))
    fail(call->location, quote(tree_.functions[call->to].name) +
                             " calls itself, which shaders do not support; write a loop");
}

}  // namespace warpjet::source::wgsl
