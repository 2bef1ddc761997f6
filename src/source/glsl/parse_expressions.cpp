// Operators, with the types of their results.
#include <algorithm>

#include "source/glsl/parser.hpp"
#include "source/typing.hpp"

namespace warpjet::source::glsl {

namespace {

// Sums may have any length, but trees must not be too deep for the recursion of the lowering.
constexpr int maxTreeDepth = 300;

}  // namespace

ExpressionId Parser::add(Expression made) {
  if (problems_.any()) return failExpression(made.location, "");
  int depth = 0;
  for (std::size_t i = 0; i < made.operands.size(); ++i) {
    const int operandDepth = tree_.expressions[made.operands[i]].depth;
    // Left operands of a chain are followed without recursion.
    depth = std::max(depth, made.kind == Code::Binary && i == 0 ? operandDepth : operandDepth + 1);
  }
  if (depth > maxTreeDepth)
    return failExpression(made.location, "this expression is nested too deep; split it");
  made.depth = static_cast<std::uint16_t>(depth);
  tree_.expressions.push_back(std::move(made));
  return static_cast<ExpressionId>(tree_.expressions.size() - 1);
}

// Reports a problem, and returns a placeholder for the expression that couldn't be parsed.
ExpressionId Parser::failExpression(Location location, std::string message) {
  fail(location, std::move(message));
  tree_.expressions.push_back(
      Expression{.kind = Code::Constant, .type = floatType, .location = location});
  return static_cast<ExpressionId>(tree_.expressions.size() - 1);
}

ExpressionId Parser::expression() {
  ExpressionId left = assignment();
  while (peek().is(",")) {
    const Location location = take().location;
    const ExpressionId right = assignment();
    for (const ExpressionId each : {left, right})
      if (text_.version == 300 && (typeOf(each) == voidType || tree_.types.hasArray(typeOf(each))))
        fail(location, tree_.types.withArticle(typeOf(each)) +
                           " is not allowed in a comma expression; write two statements");
    left = add(Expression{.kind = Code::Sequence,
                          .type = typeOf(right),
                          .location = location,
                          .operands = {left, right}});
  }
  return left;
}

ExpressionId Parser::assignment() {
  if (!checkDepth()) return failExpression(peek().location, "");
  ++depth_;
  const ExpressionId made = [&] {
    const ExpressionId left = choice();
    const Token token = peek();
    const std::string_view text = token.text;
    const bool isPlain = token.is("=");
    if (token.kind != Kind::Symbol || text.size() > 3 || text.empty() || text.back() != '=')
      return left;
    const OperatorRow* row = isPlain ? nullptr : findOperator(text.substr(0, text.size() - 1));
    if (!isPlain && (!row || row->level == 7 || row->level == 8 || findOperator(text))) return left;
    take();
    const ExpressionId location = makeAssignable(left, token.location, text);
    if (row) requireVersion(textOf(row->op), token.location);
    const ExpressionId right = assignment();
    if (problems_.any()) return left;
    const Type wanted = typeOf(location), got = typeOf(right);
    if (tree_.types.hasArray(wanted)) requireVersion("an assignment of arrays", token.location);
    if (tree_.types.hasSampler(wanted))
      return failExpression(token.location,
                            "an image cannot be assigned; read it here by texture()");
    if (isPlain ? wanted != got : typeOfBinary(row->op, wanted, got, tree_.types) != wanted)
      return failExpression(token.location, "" + tree_.types.withArticle(got) +
                                                " cannot be assigned by " + std::string(text) +
                                                " to " + tree_.types.withArticle(wanted) +
                                                "; GLSL has no implicit conversions");
    return add(Expression{.kind = Code::Assign,
                          .op = row ? row->op : Operator{},
                          .isCombined = !isPlain,
                          .type = wanted,
                          .location = token.location,
                          .operands = {location, right}});
  }();
  --depth_;
  return made;
}

ExpressionId Parser::choice() {
  const ExpressionId test = binary(1);
  if (!peek().is("?")) return test;
  const Location location = take().location;
  const ExpressionId yes = expression();
  expect(":", "the first value of ? :");
  const ExpressionId no = assignment();
  if (problems_.any()) return test;
  if (!typeOf(test).isBool())
    return failExpression(location,
                          "expected a bool before ?, got " + tree_.types.withArticle(typeOf(test)));
  if (typeOf(yes) != typeOf(no) || (typeOf(yes) == voidType && text_.version == 300))
    return failExpression(location, "expected two values of the same type in ? :, got " +
                                        tree_.types.withArticle(typeOf(yes)) + " and " +
                                        tree_.types.withArticle(typeOf(no)));
  if (tree_.types.hasSampler(typeOf(yes)))
    return failExpression(
        location, "an image cannot be chosen by ? :; choose between the results of texture()");
  if (text_.version && (typeOf(yes).isArray() || typeOf(yes).base == Base::Struct))
    return failExpression(location,
                          "browsers do not support ? : of arrays or structures; write if");
  return add(Expression{.kind = Code::Choose,
                        .type = typeOf(yes),
                        .location = location,
                        .operands = {test, yes, no}});
}

ExpressionId Parser::binary(int level) {
  ExpressionId left = unary();
  for (;;) {
    const OperatorRow* row = peek().kind == Kind::Symbol ? findOperator(peek().text) : nullptr;
    if (!row || row->level < level) return left;
    const Location location = take().location;
    requireVersion(textOf(row->op), location);
    const ExpressionId right = binary(row->level + 1);
    if (problems_.any()) return left;
    left = makeBinary(row->op, left, right, location);
  }
}

ExpressionId Parser::makeBinary(Operator op, ExpressionId left, ExpressionId right,
                                Location location) {
  const Type a = typeOf(left), b = typeOf(right);
  const auto type = typeOfBinary(op, a, b, tree_.types);
  if (!type) {
    const bool mixes = a.isNumeric() && b.isNumeric() && a.base != b.base && a.base != Base::Bool &&
                       b.base != Base::Bool;
    return failExpression(
        location,
        quote(textOf(op)) + " does not take " + tree_.types.withArticle(a) + " and " +
            tree_.types.withArticle(b) +
            (mixes ? "; GLSL has no implicit conversions: write 1.0 for 1, or float(x)" : ""));
  }
  if (tree_.types.hasArray(a)) requireVersion("a comparison of arrays", location);
  return add(Expression{.kind = Code::Binary,
                        .op = op,
                        .type = *type,
                        .location = location,
                        .operands = {left, right}});
}

ExpressionId Parser::unary() {
  if (!checkDepth()) return failExpression(peek().location, "");
  ++depth_;
  const ExpressionId made = [&] {
    const Token token = peek();
    if (token.kind != Kind::Symbol) return postfix();
    if (token.is("++") || token.is("--")) {
      take();
      return increment(unary(), token.is("++") ? Operator::Add : Operator::Subtract, token.location,
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
      requireVersion(token.text, token.location);
    } else {
      return postfix();
    }
    take();
    const ExpressionId operand = unary();
    if (problems_.any()) return operand;
    const Type type = typeOf(operand);
    const bool fits = kind == Code::Not          ? type.isBool()
                      : kind == Code::Complement ? type.isInteger()
                                                 : type.isNumeric() && type.base != Base::Bool;
    if (!fits)
      return failExpression(token.location,
                            quote(token.text) + " does not take " + tree_.types.withArticle(type));
    return add(
        Expression{.kind = kind, .type = type, .location = token.location, .operands = {operand}});
  }();
  --depth_;
  return made;
}

// Returns the operand of an assignment, after checking that it can be assigned; `what` is the
// assigning operator.
ExpressionId Parser::makeAssignable(ExpressionId operand, Location location,
                                    std::string_view what) {
  if (problems_.any()) return operand;
  const Expression* root = &tree_.expressions[operand];
  while (root->kind != Code::Variable && !root->operands.empty() && root->isAssignable)
    root = &tree_.expressions[root->operands[0]];
  if (root->kind == Code::Variable) {
    const Variable& variable = tree_.variables[root->index];
    if (variable.kind == Variable::Kind::Constant)
      return failExpression(location,
                            quote(variable.name) + " is a constant and cannot be changed");
    if (variable.kind == Variable::Kind::Uniform || variable.kind == Variable::Kind::Attribute ||
        variable.kind == Variable::Kind::Fragment)
      return failExpression(location,
                            quote(variable.name) + " is given by the host and cannot be changed");
    if (std::find(counters_.begin(), counters_.end(), root->index) != counters_.end())
      requireVersion("changing a loop's counter in its body", location);
  }
  const Expression& node = tree_.expressions[operand];
  if (!node.isAssignable || root->kind != Code::Variable)
    return failExpression(location, "expected a variable before " + std::string(what) +
                                        ", got a value that cannot be changed");
  // A component that occurs twice would have two values.
  for (const Expression* part = &node; part->kind == Code::Swizzle;
       part = &tree_.expressions[part->operands[0]]) {
    unsigned seen = 0;
    for (int i = 0; i < part->type.components(); ++i) {
      const unsigned bit = 1u << (part->index >> (2 * i) & 3);
      if (seen & bit)
        return failExpression(location, "a component occurs twice in the target of the assignment");
      seen |= bit;
    }
  }
  return operand;
}

ExpressionId Parser::increment(ExpressionId operand, Operator op, Location location,
                               bool isPostfix) {
  if (problems_.any()) return operand;
  const std::string_view text = op == Operator::Add ? "++" : "--";
  const ExpressionId changed = makeAssignable(operand, location, text);
  const Type type = typeOf(changed);
  if (!problems_.any() && (!type.isNumeric() || type.base == Base::Bool))
    return failExpression(location,
                          quote(text) + " does not take " + tree_.types.withArticle(type));
  return add(Expression{.kind = Code::Increment,
                        .op = op,
                        .type = type,
                        .index = isPostfix,
                        .location = location,
                        .operands = {changed}});
}

}  // namespace warpjet::source::glsl
