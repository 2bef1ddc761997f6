// Expressions, each with its type.
#include <algorithm>

#include "glsl/builtins.hpp"
#include "glsl/constants.hpp"
#include "glsl/parser.hpp"
#include "glsl/typing.hpp"

namespace warpjet::glsl {

namespace {

// Sums of any length, but no tree that the lowering cannot climb.
constexpr int deepestTree = 300;

}  // namespace

Number Parser::add(Expression made) {
  if (problems_.any()) return failed(made.place, "");
  int depth = 0;
  for (std::size_t i = 0; i < made.operands.size(); ++i) {
    const int of = tree_.expressions[made.operands[i]].depth;
    // The left operands of a chain are walked without climbing.
    depth = std::max(depth, made.kind == Code::Binary && i == 0 ? of : of + 1);
  }
  if (depth > deepestTree)
    return failed(made.place, "this expression is nested too deep; split it");
  made.depth = static_cast<std::uint16_t>(depth);
  tree_.expressions.push_back(std::move(made));
  return static_cast<Number>(tree_.expressions.size() - 1);
}

// A number that stands for what could not be read.
Number Parser::failed(Place place, std::string sentence) {
  fail(place, std::move(sentence));
  tree_.expressions.push_back(
      Expression{.kind = Code::Constant, .type = floatType, .place = place});
  return static_cast<Number>(tree_.expressions.size() - 1);
}

std::string Parser::typesOf(const std::vector<Type>& types) const {
  std::string text;
  for (const Type type : types) text += (text.empty() ? "" : ", ") + tree_.types.name(type);
  return text;
}

Number Parser::expression() {
  Number left = assignment();
  while (peek().is(",")) {
    const Place place = take().place;
    const Number right = assignment();
    left = add(Expression{
        .kind = Code::Sequence, .type = typeOf(right), .place = place, .operands = {left, right}});
  }
  return left;
}

Number Parser::assignment() {
  if (!goDeeper()) return failed(peek().place, "");
  ++depth_;
  const Number made = [&] {
    const Number left = choice();
    const Token token = peek();
    const std::string_view text = token.text;
    const bool isPlain = token.is("=");
    if (token.kind != Kind::Symbol || text.size() > 3 || text.empty() || text.back() != '=')
      return left;
    const OperatorRow* row = isPlain ? nullptr : findOperator(text.substr(0, text.size() - 1));
    if (!isPlain && (!row || row->level == 7 || row->level == 8 || findOperator(text))) return left;
    take();
    const Number place = makePlace(left, token.place, text);
    const Number right = assignment();
    if (problems_.any()) return left;
    const Type wanted = typeOf(place), came = typeOf(right);
    if (isPlain ? wanted != came : typeOfBinary(row->op, wanted, came, tree_.types) != wanted)
      return failed(token.place, "" + tree_.types.a(came) + " cannot be assigned by " +
                                     std::string(text) + " to " + tree_.types.a(wanted) +
                                     "; GLSL converts nothing by itself");
    return add(Expression{.kind = Code::Assign,
                          .op = row ? row->op : Operator{},
                          .isCombined = !isPlain,
                          .type = wanted,
                          .place = token.place,
                          .operands = {place, right}});
  }();
  --depth_;
  return made;
}

Number Parser::choice() {
  const Number test = binary(1);
  if (!peek().is("?")) return test;
  const Place place = take().place;
  const Number yes = expression();
  expect(":", "the first value of ? :");
  const Number no = assignment();
  if (problems_.any()) return test;
  if (!typeOf(test).isBool())
    return failed(place,
                  "a bool must stand before ?, but " + tree_.types.a(typeOf(test)) + " does");
  if (typeOf(yes) != typeOf(no) || typeOf(yes) == voidType)
    return failed(place, "both values of ? : must be of one type, but are " +
                             tree_.types.a(typeOf(yes)) + " and " + tree_.types.a(typeOf(no)));
  return add(Expression{
      .kind = Code::Choose, .type = typeOf(yes), .place = place, .operands = {test, yes, no}});
}

Number Parser::binary(int level) {
  Number left = unary();
  for (;;) {
    const OperatorRow* row = peek().kind == Kind::Symbol ? findOperator(peek().text) : nullptr;
    if (!row || row->level < level) return left;
    const Place place = take().place;
    const Number right = binary(row->level + 1);
    if (problems_.any()) return left;
    left = makeBinary(row->op, left, right, place);
  }
}

Number Parser::makeBinary(Operator op, Number left, Number right, Place place) {
  const Type a = typeOf(left), b = typeOf(right);
  const auto type = typeOfBinary(op, a, b, tree_.types);
  if (!type) {
    const bool mixes = a.isNumeric() && b.isNumeric() && a.base != b.base && a.base != Base::Bool &&
                       b.base != Base::Bool;
    return failed(
        place,
        quoted(textOf(op)) + " does not take " + tree_.types.a(a) + " and " + tree_.types.a(b) +
            (mixes ? "; GLSL converts nothing by itself: write 1.0 for 1, or float(x)" : ""));
  }
  return add(Expression{
      .kind = Code::Binary, .op = op, .type = *type, .place = place, .operands = {left, right}});
}

Number Parser::unary() {
  if (!goDeeper()) return failed(peek().place, "");
  ++depth_;
  const Number made = [&] {
    const Token token = peek();
    if (token.kind != Kind::Symbol) return postfix();
    if (token.is("++") || token.is("--")) {
      take();
      return increment(unary(), token.is("++") ? Operator::Add : Operator::Subtract, token.place,
                       false);
    }
    Code kind;
    if (token.is("-")) {
      kind = Code::Negate;
    } else if (token.is("+")) {
      kind = Code::Plus;
    } else if (token.is("!")) {
      kind = Code::Not;
    } else if (token.is("~")) {
      kind = Code::Complement;
    } else {
      return postfix();
    }
    take();
    const Number operand = unary();
    if (problems_.any()) return operand;
    const Type type = typeOf(operand);
    const bool fits = kind == Code::Not          ? type.isBool()
                      : kind == Code::Complement ? type.isWhole()
                                                 : type.isNumeric() && type.base != Base::Bool;
    if (!fits)
      return failed(token.place, quoted(token.text) + " does not take " + tree_.types.a(type));
    return add(Expression{.kind = kind, .type = type, .place = token.place, .operands = {operand}});
  }();
  --depth_;
  return made;
}

// What is assigned to; `what` does it.
Number Parser::makePlace(Number operand, Place place, std::string_view what) {
  if (problems_.any()) return operand;
  const Expression* root = &tree_.expressions[operand];
  while (root->kind != Code::Variable && !root->operands.empty() && root->isPlace)
    root = &tree_.expressions[root->operands[0]];
  if (root->kind == Code::Variable) {
    const Variable& variable = tree_.variables[root->index];
    if (variable.kind == Variable::Kind::Constant)
      return failed(place, quoted(variable.name) + " is a constant and cannot be changed");
    if (variable.kind == Variable::Kind::Uniform || variable.kind == Variable::Kind::Attribute)
      return failed(place, quoted(variable.name) + " is given by the host and cannot be changed");
  }
  const Expression& node = tree_.expressions[operand];
  if (!node.isPlace || root->kind != Code::Variable)
    return failed(place, "what stands before " + std::string(what) +
                             " is a value, nothing that can be changed");
  // The same component twice has two values.
  for (const Expression* part = &node; part->kind == Code::Swizzle;
       part = &tree_.expressions[part->operands[0]]) {
    unsigned seen = 0;
    for (int i = 0; i < part->type.components(); ++i) {
      const unsigned bit = 1u << (part->index >> (2 * i) & 3);
      if (seen & bit) return failed(place, "a component comes twice in what is assigned to");
      seen |= bit;
    }
  }
  return operand;
}

Number Parser::increment(Number operand, Operator op, Place place, bool isPostfix) {
  if (problems_.any()) return operand;
  const std::string_view text = op == Operator::Add ? "++" : "--";
  const Number changed = makePlace(operand, place, text);
  const Type type = typeOf(changed);
  if (!problems_.any() && (!type.isNumeric() || type.base == Base::Bool))
    return failed(place, quoted(text) + " does not take " + tree_.types.a(type));
  return add(Expression{.kind = Code::Increment,
                        .op = op,
                        .type = type,
                        .index = isPostfix,
                        .place = place,
                        .operands = {changed}});
}

Number Parser::postfix() {
  Number operand = primary();
  for (;;) {
    const Token& token = peek();
    if (token.is(".")) {
      operand = member(operand);
    } else if (token.is("[")) {
      operand = element(operand);
    } else if (token.is("++") || token.is("--")) {
      take();
      operand = increment(operand, token.is("++") ? Operator::Add : Operator::Subtract, token.place,
                          true);
    } else {
      return operand;
    }
  }
}

Number Parser::member(Number operand) {
  const Place place = take().place;
  const Token name = peek();
  if (name.kind != Kind::Name) {
    return failed(name.place, "a component or field is missing after the point; " + found());
  }
  take();
  if (problems_.any()) return operand;
  const Type type = typeOf(operand);
  const bool isPlace = tree_.expressions[operand].isPlace;
  if (type.isArray() && name.is("length")) {
    expect("(", "length");
    expect(")", "length(");
    return add(Expression{.kind = Code::Constant,
                          .type = intType,
                          .value = static_cast<double>(type.length),
                          .place = place});
  }
  if (type.isStruct()) {
    const Field* field = tree_.types.structure(type).find(name.text);
    if (!field)
      return failed(name.place, "" + tree_.types.a(type) + " has no field " + quoted(name.text));
    return add(Expression{.kind = Code::Part,
                          .isPlace = isPlace,
                          .type = field->type,
                          .index = field->offset,
                          .place = place,
                          .operands = {operand}});
  }
  const auto packed = type.isVector() ? readSwizzle(name.text, type.rows) : std::nullopt;
  if (!packed)
    return failed(name.place, "" + tree_.types.a(type) + " has no component " + quoted(name.text));
  return add(Expression{.kind = Code::Swizzle,
                        .isPlace = isPlace,
                        .type = vectorType(type.base, static_cast<int>(name.text.size())),
                        .index = *packed,
                        .place = place,
                        .operands = {operand}});
}

Number Parser::element(Number operand) {
  const Place place = take().place;
  const Number index = expression();
  expect("]", "an index");
  if (problems_.any()) return operand;
  const Type type = typeOf(operand);
  if (!type.isArray() && !type.isVector() && !type.isMatrix())
    return failed(place, "" + tree_.types.a(type) + " has no elements");
  if (!typeOf(index).isWhole() || !typeOf(index).isScalar())
    return failed(place, "an index must be an int or uint, but is " + tree_.types.a(typeOf(index)));
  const int count = type.isArray() ? type.length : type.isMatrix() ? type.columns : type.rows;
  if (const auto known = constantInt(tree_, index); known && (*known < 0 || *known >= count))
    return failed(place, "the index " + std::to_string(*known) + " is not one of 0 to " +
                             std::to_string(count - 1));
  const Type element = type.isArray()    ? type.element()
                       : type.isMatrix() ? vectorType(type.base, type.rows)
                                         : scalarOf(type.base);
  return add(Expression{.kind = Code::Element,
                        .isPlace = tree_.expressions[operand].isPlace,
                        .type = element,
                        .place = place,
                        .operands = {operand, index}});
}

Number Parser::primary() {
  const Token token = peek();
  if (token.is("(")) {
    take();
    const Number inner = expression();
    expect(")", "an expression");
    return inner;
  }
  if (token.kind == Kind::Int || token.kind == Kind::Uint || token.kind == Kind::Float)
    return number();
  if (token.kind == Kind::Name) return named();
  return failed(token.place, "a value is missing; " + found());
}

Number Parser::number() {
  const Token token = take();
  Expression made{.kind = Code::Constant, .place = token.place};
  if (token.kind == Kind::Float) {
    made.type = floatType;
    made.value = floatValue(token, problems_);
  } else {
    const std::uint32_t bits = intValue(token, problems_);
    made.type = token.kind == Kind::Int ? intType : uintType;
    made.value =
        token.kind == Kind::Int ? static_cast<std::int32_t>(bits) : static_cast<double>(bits);
  }
  return add(std::move(made));
}

Number Parser::named() {
  const Token name = peek();
  if (name.is("true") || name.is("false")) {
    take();
    return add(Expression{.kind = Code::Constant,
                          .type = boolType,
                          .value = name.is("true") ? 1.0 : 0.0,
                          .place = name.place});
  }
  if (startsType()) {
    const Type made = type();
    return construct(made, name.place);
  }
  if (peek(1).is("(")) {
    take();
    return call(name);
  }
  const Meaning meaning = scope_.find(name.text);
  if (meaning.kind != Meaning::Kind::Variable) {
    const bool isFunction = meaning.kind == Meaning::Kind::Function || isBuiltIn(name.text);
    if (isFunction)
      return failed(name.place, quoted(name.text) + " is a function; call it with ( )");
    return failed(name.place, quoted(name.text) + " is not declared");
  }
  take();
  return add(Expression{.kind = Code::Variable,
                        .isPlace = true,
                        .type = tree_.variables[meaning.index].type,
                        .index = meaning.index,
                        .place = name.place});
}

// From the parenthesis on to the one that closes it.
std::vector<Number> Parser::arguments() {
  std::vector<Number> all;
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

Number Parser::construct(Type type, Place place) {
  if (!problems_.any() && !peek().is("("))
    return failed(place, "a value is missing; a type stands here");
  std::vector<Number> operands = arguments();
  if (problems_.any()) return failed(place, "");
  std::vector<Type> types;
  for (const Number operand : operands) types.push_back(typeOf(operand));
  if (type.length == 0) type.length = static_cast<std::int32_t>(operands.size());
  std::string why = constructorProblem(type, types, tree_.types);
  if (!why.empty()) return failed(place, std::move(why));
  return add(Expression{
      .kind = Code::Construct, .type = type, .place = place, .operands = std::move(operands)});
}

Number Parser::call(const Token& name) {
  const Meaning meaning = scope_.find(name.text);
  std::vector<Number> operands = arguments();
  if (problems_.any()) return failed(name.place, "");
  std::vector<Type> types;
  for (const Number operand : operands) types.push_back(typeOf(operand));
  if (meaning.kind == Meaning::Kind::Function) {
    const Number made = callFunction(name, operands, types);
    if (problems_.any()) return failed(name.place, "");
    if (made != nothing) return made;
  }
  if (meaning.kind == Meaning::Kind::Variable)
    return failed(name.place, quoted(name.text) + " is a variable and cannot be called");
  const auto found = findBuiltIn(name.text, types);
  if (!found) {
    if (meaning.kind == Meaning::Kind::None && !isBuiltIn(name.text))
      return failed(name.place, "there is no function " + quoted(name.text));
    return failed(name.place, quoted(name.text) + " cannot be called with (" + typesOf(types) +
                                  "); GLSL converts nothing by itself");
  }
  const BuiltIn& row = builtIns[found->row];
  for (std::size_t i = 0; i < operands.size(); ++i)
    if (isOut(row, i)) makePlace(operands[i], name.place, "this call");
  if (row.way == Way::Refused)
    return failed(name.place,
                  quoted(name.text) +
                      " has no place in a warp, which needs exact derivatives of what vertices do");
  return add(Expression{.kind = Code::BuiltIn,
                        .type = found->result,
                        .index = found->row,
                        .place = name.place,
                        .operands = std::move(operands)});
}

// One of the text's own; nothing where none of that name fits, for a built-in one may.
Number Parser::callFunction(const Token& name, std::vector<Number> operands,
                            const std::vector<Type>& types) {
  std::string known;
  for (std::size_t i = 0; i < tree_.functions.size(); ++i) {
    const Function& function = tree_.functions[i];
    if (function.name != name.text) continue;
    std::vector<Type> wanted;
    for (const Parameter& parameter : function.parameters) wanted.push_back(parameter.type);
    known += (known.empty() ? "(" : " or (") + typesOf(wanted) + ')';
    if (wanted != types) continue;
    for (std::size_t k = 0; k < operands.size(); ++k)
      if (function.parameters[k].direction != Parameter::Direction::In)
        makePlace(operands[k], name.place, "this call");
    if (current_ != nothing) calls_.push_back({current_, static_cast<Number>(i), name.place});
    if (problems_.any()) return nothing;
    return add(Expression{.kind = Code::Call,
                          .type = function.type,
                          .index = static_cast<Number>(i),
                          .place = name.place,
                          .operands = std::move(operands)});
  }
  if (!findBuiltIn(name.text, types))
    return failed(name.place, quoted(name.text) + " takes " + known + ", but (" + typesOf(types) +
                                  ") came; GLSL converts nothing by itself");
  return nothing;
}

}  // namespace warpjet::glsl
