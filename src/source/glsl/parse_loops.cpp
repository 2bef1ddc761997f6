// Loops, and conditions with declarations.
#include <algorithm>

#include "source/glsl/parser.hpp"

namespace warpjet::source::glsl {

// Parses `bool more = n < 4` as a condition: the variable is assigned in each step.
ExpressionId Parser::declaredCondition(StatementId& declared) {
  const Qualifiers given = qualifiers();
  allowOnly(given, {QualifierRole::Const, QualifierRole::Precision}, "a condition");
  const Type base = type();
  const Token name = peek();
  if (!checkFree(name)) return nothing;
  take();
  if (!accept("=")) fail(peek().location, "expected a value for " + quote(name.text));
  const ExpressionId value = assignment();
  if (problems_.any()) return nothing;
  if (base != boolType || typeOf(value) != boolType) {
    fail(name.location, "expected a bool as condition, got " + quote(name.text) + ", " +
                            tree_.types.withArticle(base != boolType ? base : typeOf(value)));
    return nothing;
  }
  if (given.isConst()) checkStart(Variable::Kind::Constant, value, name);
  const VariableId variable =
      addVariable(name, base, given.isConst() ? Variable::Kind::Constant : Variable::Kind::Local);
  declared = add(
      Statement{.kind = Statement::Kind::Declare, .index = variable, .location = name.location});
  const ExpressionId target = add(Expression{.kind = Code::Variable,
                                             .isAssignable = true,
                                             .type = base,
                                             .index = variable,
                                             .location = name.location});
  return add(Expression{
      .kind = Code::Assign, .type = base, .location = name.location, .operands = {target, value}});
}

ExpressionId Parser::condition(std::string_view after) {
  expect("(", after);
  if (startsType() && !peek(1).is("(")) {
    fail(peek().location, "declare this variable before the " + std::string(after));
    return nothing;
  }
  const Location location = peek().location;
  const ExpressionId value = expression();
  expect(")", "a condition");
  if (!problems_.any() && !typeOf(value).isBool())
    fail(location, "expected a bool as the condition of this " + std::string(after) + ", got " +
                       tree_.types.withArticle(typeOf(value)));
  return value;
}

StatementId Parser::forStatement() {
  const Location location = take().location;
  scope_.open();
  expect("(", "for");
  const StatementId start = simpleStatement();
  ExpressionId test = nothing;
  StatementId step = nothing, declared = nothing;
  const Location testPlace = peek().location;
  if (startsDeclaration()) {
    test = declaredCondition(declared);
  } else if (!peek().is(";")) {
    test = expression();
    if (!problems_.any() && !typeOf(test).isBool())
      fail(testPlace, "expected a bool as the condition of this for, got " +
                          tree_.types.withArticle(typeOf(test)));
  }
  expect(";", "the condition of a for");
  if (!peek().is(")")) {
    const Location stepPlace = peek().location;
    step = add(Statement{
        .kind = Statement::Kind::Evaluate, .expression = expression(), .location = stepPlace});
  }
  expect(")", "the head of a for");
  const std::size_t outer = counters_.size();
  if (!problems_.any()) requireCounting(start, test, step, location);
  ++loops_;
  const StatementId body = statement(false);
  --loops_;
  counters_.resize(outer);
  scope_.close();
  const StatementId first = declared == nothing ? start : makeBlock(location, {start, declared});
  return add(Statement{.kind = Statement::Kind::Loop,
                       .expression = test,
                       .location = location,
                       .children = {first, step, body}});
}

// Returns true if a condition declares a variable; `vec3(…)` starts an expression.
bool Parser::startsDeclaration(std::size_t ahead) const {
  const Token& token = peek(ahead);
  return (startsType(ahead) && peek(ahead + 1).kind == Kind::Name) || token.is("const") ||
         token.is("highp") || token.is("mediump") || token.is("lowp");
}

// Requires version 3.00 for loops that GLSL ES 1.00, appendix A.4, doesn't allow. In 1.00, one
// number counts from a constant to a constant by a constant, and the body doesn't change it.
void Parser::requireCounting(StatementId start, ExpressionId test, StatementId step,
                             Location location) {
  if (text_.version != 100) return;
  const auto counter = [&]() -> VariableId {
    const Statement& declared = tree_.statements[start];
    if (declared.kind != Statement::Kind::Declare || declared.expression == nothing) return nothing;
    const Type type = tree_.variables[declared.index].type;
    const bool isNumber = type == intType || type == floatType;
    return isNumber && constants_.isConstant(declared.expression) ? declared.index : nothing;
  }();
  const auto isCounter = [&](ExpressionId expression) {
    const Expression& node = tree_.expressions[expression];
    return node.kind == Code::Variable && node.index == counter;
  };
  const auto isCompared = [&] {
    if (test == nothing) return false;
    const Expression& node = tree_.expressions[test];
    return node.kind == Code::Binary && node.op >= Operator::Equal &&
           node.op <= Operator::AtLeast && isCounter(node.operands[0]) &&
           constants_.isConstant(node.operands[1]);
  };
  const auto isStepped = [&] {
    if (step == nothing) return false;
    const Expression& node = tree_.expressions[tree_.statements[step].expression];
    if (node.kind == Code::Increment) return isCounter(node.operands[0]);
    return node.kind == Code::Assign && node.isCombined &&
           (node.op == Operator::Add || node.op == Operator::Subtract) &&
           isCounter(node.operands[0]) && constants_.isConstant(node.operands[1]);
  };
  if (counter == nothing || !isCompared() || !isStepped())
    return requireVersion("a for whose counter does not start, end and step by constants",
                          location);
  counters_.push_back(counter);
}

StatementId Parser::whileStatement() {
  requireVersion("while", peek().location);
  const Location location = take().location;
  scope_.open();
  StatementId declared = nothing;
  ExpressionId test = nothing;
  const bool isDeclared = peek().is("(") && startsDeclaration(1);
  if (isDeclared) {
    take();
    test = declaredCondition(declared);
    expect(")", "a condition");
  } else {
    test = condition("while");
  }
  ++loops_;
  const StatementId body = statement(false);
  --loops_;
  scope_.close();
  return add(Statement{.kind = Statement::Kind::Loop,
                       .expression = test,
                       .location = location,
                       .children = {declared, nothing, body}});
}

StatementId Parser::doStatement() {
  requireVersion("do", peek().location);
  const Location location = take().location;
  scope_.open();
  ++loops_;
  const StatementId body = statement(false);
  --loops_;
  scope_.close();
  if (!accept("while"))
    fail(peek().location, "expected while after the body of do, " + describeNext());
  const ExpressionId test = condition("while");
  expect(";", "do … while ( )");
  return add(Statement{.kind = Statement::Kind::Loop,
                       .testsAfterBody = true,
                       .expression = test,
                       .location = location,
                       .children = {nothing, nothing, body}});
}

}  // namespace warpjet::source::glsl
