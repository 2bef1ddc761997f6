// The operands of operators: names, numbers, calls, constructors, and parts of them.
#include <algorithm>

#include "source/glsl/built_in_table.hpp"
#include "source/glsl/parser.hpp"
#include "source/nearest.hpp"
#include "source/typing.hpp"

namespace warpjet::source::glsl {

std::string Parser::typesOf(const std::vector<Type>& types) const {
  std::string text;
  for (const Type type : types) text += (text.empty() ? "" : ", ") + tree_.types.name(type);
  return text;
}

ExpressionId Parser::postfix() {
  ExpressionId operand = primary();
  for (;;) {
    const Token& token = peek();
    if (token.is(".")) {
      operand = member(operand);
    } else if (token.is("[")) {
      operand = element(operand);
    } else if (token.is("++") || token.is("--")) {
      take();
      operand = increment(operand, token.is("++") ? Operator::Add : Operator::Subtract,
                          token.location, true);
    } else {
      return operand;
    }
  }
}

ExpressionId Parser::member(ExpressionId operand) {
  const Location location = take().location;
  const Token name = peek();
  if (name.kind != Kind::Name) {
    return failExpression(name.location,
                          "expected a component or field after the point, " + describeNext());
  }
  take();
  if (problems_.any()) return operand;
  const Type type = typeOf(operand);
  const bool isAssignable = tree_.expressions[operand].isAssignable;
  if (type.isArray() && name.is("length")) {
    expect("(", "length");
    expect(")", "length(");
    requireVersion(".length()", location);
    return add(Expression{.kind = Code::Constant,
                          .type = intType,
                          .value = static_cast<double>(type.length),
                          .location = location});
  }
  if (type.isStruct()) {
    const Field* field = tree_.types.structure(type).find(name.text);
    if (!field)
      return failExpression(
          name.location, "" + tree_.types.withArticle(type) + " has no field " + quote(name.text));
    return add(Expression{.kind = Code::Part,
                          .isAssignable = isAssignable,
                          .type = field->type,
                          .index = field->offset,
                          .location = location,
                          .operands = {operand}});
  }
  const auto packed = type.isVector() ? readSwizzle(name.text, type.rows) : std::nullopt;
  if (!packed)
    return failExpression(name.location, "" + tree_.types.withArticle(type) + " has no component " +
                                             quote(name.text));
  return add(Expression{.kind = Code::Swizzle,
                        .isAssignable = isAssignable,
                        .type = vectorType(type.base, static_cast<int>(name.text.size())),
                        .index = *packed,
                        .location = location,
                        .operands = {operand}});
}

ExpressionId Parser::element(ExpressionId operand) {
  const Location location = take().location;
  const ExpressionId index = expression();
  expect("]", "an index");
  if (problems_.any()) return operand;
  const Type type = typeOf(operand);
  if (!type.isArray() && !type.isVector() && !type.isMatrix())
    return failExpression(location, "" + tree_.types.withArticle(type) + " has no elements");
  if (!typeOf(index).isInteger() || !typeOf(index).isScalar())
    return failExpression(location, "expected an int or uint as index, got " +
                                        tree_.types.withArticle(typeOf(index)));
  const auto isCounter = [&](VariableId each) {
    return std::find(counters_.begin(), counters_.end(), each) != counters_.end();
  };
  if (!constants_.isConstant(index, isCounter) && !isUniform(operand))
    requireVersion("an index that is not constant", location);
  if (tree_.types.isBlock(type) && !constants_.isConstant(index))
    return failExpression(location, "the index of a block of uniforms must be a constant");
  const int count = type.isArray() ? type.length : type.isMatrix() ? type.columns : type.rows;
  if (const auto known = constants_.integer(index); known && (*known < 0 || *known >= count))
    return failExpression(location, "expected an index from 0 to " + std::to_string(count - 1) +
                                        ", got " + std::to_string(*known));
  const Type element = type.isArray()    ? type.element()
                       : type.isMatrix() ? vectorType(type.base, type.rows)
                                         : scalarOf(type.base);
  return add(Expression{.kind = Code::Element,
                        .isAssignable = tree_.expressions[operand].isAssignable,
                        .type = element,
                        .location = location,
                        .operands = {operand, index}});
}

// Returns true for a uniform or a part of one: in vertex shaders of GLSL ES 1.00, only those allow
// an index that isn't constant (appendix A.5).
bool Parser::isUniform(ExpressionId operand) const {
  const Expression* root = &tree_.expressions[operand];
  while (root->kind != Code::Variable && !root->operands.empty())
    root = &tree_.expressions[root->operands[0]];
  return root->kind == Code::Variable &&
         tree_.variables[root->index].kind == Variable::Kind::Uniform;
}

ExpressionId Parser::primary() {
  const Token token = peek();
  if (token.is("(")) {
    take();
    const ExpressionId inner = expression();
    expect(")", "an expression");
    return inner;
  }
  if (token.kind == Kind::Int || token.kind == Kind::Uint || token.kind == Kind::Float)
    return number();
  if (token.kind == Kind::Name) return named();
  return failExpression(token.location, "expected a value, " + describeNext());
}

ExpressionId Parser::number() {
  const Token token = take();
  Expression parsed{.kind = Code::Constant, .location = token.location};
  if (token.kind == Kind::Float) {
    parsed.type = floatType;
    parsed.value = floatValue(token);
    if (token.text.back() == 'f' || token.text.back() == 'F')
      requireVersion("a number with an f", token.location);
  } else {
    if (token.kind == Kind::Uint) requireVersion("a whole number with a u", token.location);
    const std::uint32_t bits = intValue(token, problems_);
    parsed.type = token.kind == Kind::Int ? intType : uintType;
    parsed.value =
        token.kind == Kind::Int ? static_cast<std::int32_t>(bits) : static_cast<double>(bits);
  }
  return add(std::move(parsed));
}

ExpressionId Parser::named() {
  const Token name = peek();
  if (name.is("true") || name.is("false")) {
    take();
    return add(Expression{.kind = Code::Constant,
                          .type = boolType,
                          .value = name.is("true") ? 1.0 : 0.0,
                          .location = name.location});
  }
  if (startsType()) {
    if (peek(1).is("[")) requireVersion("an array made in one expression", name.location);
    const Type parsed = type();
    return construct(parsed, name.location);
  }
  if (peek(1).is("(")) {
    take();
    return call(name);
  }
  const Meaning meaning = scope_.find(name.text);
  if (meaning.kind != Meaning::Kind::Variable) {
    const bool isFunction =
        meaning.kind == Meaning::Kind::Function || isBuiltIn(builtIns, name.text);
    if (isFunction)
      return failExpression(name.location, quote(name.text) + " is a function; call it with ( )");
    Nearest nearest(name.text);
    scope_.each(Meaning::Kind::Variable, [&](std::string_view other) { nearest.offer(other); });
    return failExpression(name.location,
                          quote(name.text) + " is not declared" + nearest.question());
  }
  take();
  if (name.text.starts_with("gl_")) requireVersion(name.text, name.location);
  return add(Expression{.kind = Code::Variable,
                        .isAssignable = true,
                        .type = tree_.variables[meaning.index].type,
                        .index = meaning.index,
                        .location = name.location});
}

// Parses the arguments of a call, from the parenthesis to its counterpart.
std::vector<ExpressionId> Parser::arguments() {
  std::vector<ExpressionId> all;
  expect("(", "this");
  if (accept(")")) return all;
  if (peek().is("void") && peek(1).is(")")) {
    take();
    take();
    return all;
  }
  do {
    all.push_back(assignment());
  } while (accept(","));
  expect(")", "the arguments");
  return all;
}

ExpressionId Parser::construct(Type type, Location location) {
  if (!problems_.any() && !peek().is("("))
    return failExpression(location, "expected a value, got a type");
  std::vector<ExpressionId> operands = arguments();
  if (problems_.any()) return failExpression(location, "");
  std::vector<Type> types;
  for (const ExpressionId operand : operands) types.push_back(typeOf(operand));
  if (type.length == 0) type.length = static_cast<std::int32_t>(operands.size());
  std::string why = constructorProblem(type, types, tree_.types);
  if (!why.empty()) return failExpression(location, std::move(why));
  return add(Expression{.kind = Code::Construct,
                        .type = type,
                        .location = location,
                        .operands = std::move(operands)});
}

ExpressionId Parser::call(const Token& name) {
  const Meaning meaning = scope_.find(name.text);
  std::vector<ExpressionId> operands = arguments();
  if (problems_.any()) return failExpression(name.location, "");
  std::vector<Type> types;
  for (const ExpressionId operand : operands) types.push_back(typeOf(operand));
  if (meaning.kind == Meaning::Kind::Function) {
    const ExpressionId parsed = callFunction(name, operands, types);
    if (problems_.any()) return failExpression(name.location, "");
    if (parsed != nothing) return parsed;
  }
  if (meaning.kind == Meaning::Kind::Variable)
    return failExpression(name.location, quote(name.text) + " is a variable and cannot be called");
  const auto found = findBuiltIn(builtIns, name.text, types);
  if (!found) {
    if (meaning.kind == Meaning::Kind::None && !isBuiltIn(builtIns, name.text)) {
      Nearest nearest(name.text);
      for (const BuiltIn& row : builtIns) nearest.offer(row.name);
      scope_.each(Meaning::Kind::Function, [&](std::string_view other) { nearest.offer(other); });
      return failExpression(name.location,
                            "there is no function " + quote(name.text) + nearest.question());
    }
    return failExpression(name.location, quote(name.text) + " cannot be called with (" +
                                             typesOf(types) +
                                             "); GLSL has no implicit conversions");
  }
  const BuiltIn& row = builtIns[found->row];
  requireVersion(name.text, name.location);
  requireVersion(builtInFeature(row), name.location);
  if (hasOffset(row)) checkOffset(row, operands.back(), name.location);
  for (std::size_t i = 0; i < operands.size(); ++i)
    if (isOut(row, i)) makeAssignable(operands[i], name.location, "this call");
  if (row.way == Way::Unsupported)
    return failExpression(
        name.location,
        quote(name.text) + " cannot be used in a warp, which needs exact derivatives per vertex");
  return add(Expression{.kind = Code::BuiltIn,
                        .type = found->result,
                        .index = found->row,
                        .location = name.location,
                        .operands = std::move(operands)});
}

// Checks that an offset in texels is constant and in range: GLSL ES 3.00, section 8.8.
void Parser::checkOffset(const BuiltIn& row, ExpressionId offset, Location location) {
  if (problems_.any()) return;
  const auto numbers = constants_.integers(offset);
  const bool fits = !numbers.empty() && std::all_of(numbers.begin(), numbers.end(),
                                                    [](int n) { return n >= -8 && n <= 7; });
  if (!fits)
    fail(location, "the offset of " + std::string(row.name) +
                       " must be a constant with whole numbers from -8 to 7");
}

// Parses a call of a function that the source defines. Returns `nothing` if only a built-in
// function of that name matches the arguments.
ExpressionId Parser::callFunction(const Token& name, std::vector<ExpressionId> operands,
                                  const std::vector<Type>& types) {
  std::string known;
  for (const FunctionId i : overloads_[name.text]) {
    const Function& function = tree_.functions[i];
    std::vector<Type> wanted;
    for (const Parameter& parameter : function.parameters) wanted.push_back(parameter.type);
    known += (known.empty() ? "(" : " or (") + typesOf(wanted) + ')';
    if (wanted != types) continue;
    for (std::size_t k = 0; k < operands.size(); ++k)
      if (function.parameters[k].direction != Parameter::Direction::In)
        makeAssignable(operands[k], name.location, "this call");
    if (current_ != nothing) calls_.push_back({current_, i, name.location});
    if (problems_.any()) return nothing;
    return add(Expression{.kind = Code::Call,
                          .type = function.type,
                          .index = i,
                          .location = name.location,
                          .operands = std::move(operands)});
  }
  if (!findBuiltIn(builtIns, name.text, types))
    return failExpression(name.location, quote(name.text) + " expected " + known + ", got (" +
                                             typesOf(types) +
                                             "); GLSL has no implicit conversions");
  return nothing;
}

}  // namespace warpjet::source::glsl
