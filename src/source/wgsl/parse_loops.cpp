// Loops and switches: WGSL, sections 9.4.3 to 9.4.6.
#include <algorithm>
#include <set>
#include <utility>

#include "source/wgsl/parser.hpp"

namespace warpjet::source::wgsl {

// Parses the block after `continuing`; `breakIf` becomes the condition of a final `break if`.
StatementId Parser::continuing(ExpressionId& breakIf) {
  const Location location = take().location;
  const bool wasContinuing = std::exchange(isContinuing_, true);
  const int loops = std::exchange(loops_, 0), switches = std::exchange(switches_, 0);
  attributes();
  scopes_.open();
  std::vector<StatementId> children;
  expect("{", "continuing");
  while (!peek().is("}") && !problems_.any()) {
    if (peek().is("break") && peek(1).is("if")) {
      take();
      take();
      breakIf = condition("break if");
      expect(";", "break if");
      if (!peek().is("}"))
        fail(peek().location, "break if must be the last statement of a continuing block");
      break;
    }
    if (peek().kind == Token::Kind::End) fail(location, "this continuing has no }");
    if (const StatementId child = statement(); child != nothing) children.push_back(child);
  }
  expect("}", "a continuing block");
  scopes_.close();
  loops_ = loops;
  switches_ = switches;
  isContinuing_ = wasContinuing;
  return makeBlock(location, std::move(children));
}

// Hoists the variables that the continuing block reads: declares them before the loop, and turns
// their declarations in the body into assignments. `sizeBefore` is the size of the tree before the
// continuing block was parsed. Returns the declarations, or `nothing`.
StatementId Parser::hoist(std::vector<StatementId>& body, const TreeSize& sizeBefore,
                          ExpressionId breakIf) {
  std::set<VariableId> read;
  const auto visit = [&](ExpressionId id) {
    if (id == nothing) return;
    const Expression& node = tree_.expressions[id];
    if (node.kind == Code::Variable) read.insert(node.index);
  };
  for (std::size_t i = sizeBefore.expressions; i < tree_.expressions.size(); ++i)
    for (const ExpressionId operand : tree_.expressions[i].operands) visit(operand);
  for (std::size_t i = sizeBefore.statements; i < tree_.statements.size(); ++i)
    visit(tree_.statements[i].expression);
  visit(breakIf);
  std::vector<StatementId> before;
  for (StatementId& child : body) {
    const Statement statement = tree_.statements[child];
    const VariableId variable = statement.index;
    if (statement.kind != Statement::Kind::Declare || !read.contains(variable) ||
        tree_.variables[variable].kind != Variable::Kind::Local)
      continue;
    const Type type = tree_.variables[variable].type;
    before.push_back(add(Statement{
        .kind = Statement::Kind::Declare, .index = variable, .location = statement.location}));
    const ExpressionId target = add(Expression{.kind = Code::Variable,
                                               .isAssignable = true,
                                               .type = type,
                                               .index = variable,
                                               .location = statement.location});
    child = evaluate(add(Expression{.kind = Code::Assign,
                                    .type = type,
                                    .location = statement.location,
                                    .operands = {target, statement.expression}}),
                     statement.location);
  }
  if (before.empty()) return nothing;
  const Location location = tree_.statements[before[0]].location;
  return makeBlock(location, std::move(before));
}

StatementId Parser::loopStatement() {
  const Location location = take().location;
  attributes();
  expect("{", "loop");
  scopes_.open();
  ++loops_;
  const int switches = std::exchange(switches_, 0);
  std::vector<StatementId> body;
  StatementId step = nothing, before = nothing;
  ExpressionId breakIf = nothing;
  while (!peek().is("}") && !problems_.any()) {
    if (peek().kind == Token::Kind::End) fail(location, "this loop has no }");
    if (peek().is("continuing")) {
      const TreeSize sizeBefore{tree_.expressions.size(), tree_.statements.size()};
      step = continuing(breakIf);
      if (!peek().is("}")) fail(peek().location, "continuing must be the last statement of a loop");
      if (!problems_.any()) before = hoist(body, sizeBefore, breakIf);
      break;
    }
    if (const StatementId child = statement(); child != nothing) body.push_back(child);
  }
  expect("}", "the body of a loop");
  switches_ = switches;
  --loops_;
  scopes_.close();
  const ExpressionId test =
      breakIf == nothing
          ? nothing
          : add(Expression{
                .kind = Code::Not, .type = boolType, .location = location, .operands = {breakIf}});
  const StatementId parsed =
      add({.kind = Statement::Kind::Loop,
           .testsAfterBody = breakIf != nothing,
           .expression = test,
           .location = location,
           .children = {before, step, makeBlock(location, std::move(body))}});
  if (!problems_.any() && !(behaviorOf(parsed) & (Next | Returns)))
    fail(location, "this loop never ends; write break, return or break if");
  return parsed;
}

StatementId Parser::forStatement() {
  const Location location = take().location;
  scopes_.open();
  expect("(", "for");
  StatementId start = nothing, step = nothing;
  ExpressionId test = nothing;
  if (!peek().is(";")) start = simpleStatement();
  expect(";", "the first part of a for");
  if (!peek().is(";")) test = condition("for");
  expect(";", "the condition of a for");
  if (!peek().is(")")) step = simpleStatement();
  if (step != nothing && tree_.statements[step].kind == Statement::Kind::Declare)
    fail(tree_.statements[step].location, "the last part of a for cannot declare a variable");
  expect(")", "the head of a for");
  attributes();
  ++loops_;
  const int switches = std::exchange(switches_, 0);
  const StatementId body = block();
  switches_ = switches;
  --loops_;
  scopes_.close();
  return add({.kind = Statement::Kind::Loop,
              .expression = test,
              .location = location,
              .children = {start, step, body}});
}

StatementId Parser::whileStatement() {
  const Location location = take().location;
  const ExpressionId test = condition("while");
  attributes();
  ++loops_;
  const int switches = std::exchange(switches_, 0);
  const StatementId body = block();
  switches_ = switches;
  --loops_;
  return add({.kind = Statement::Kind::Loop,
              .expression = test,
              .location = location,
              .children = {nothing, nothing, body}});
}

// Parses `case 1, 2:` or `default:`.
void Parser::caseLabels(Type type, std::vector<StatementId>& children,
                        std::vector<std::int32_t>& labels, bool& hasDefault) {
  const Token word = take();
  const auto addDefault = [&](Location location) {
    if (std::exchange(hasDefault, true)) fail(location, "this switch already has a default");
    children.push_back(add({.kind = Statement::Kind::Case, .location = location}));
  };
  if (word.is("default")) {
    addDefault(word.location);
  } else {
    do {
      const Token token = peek();
      if (token.is(":") || token.is("{")) break;
      if (accept("default")) {
        addDefault(token.location);
        continue;
      }
      const Operand label = value();
      if (problems_.any()) return;
      const auto constant = constantInteger(label);
      if (!canConvert(label, type) || !constant)
        return fail(token.location,
                    "expected a constant " + nameOf(type) + " after case, got " + describe(label));
      const auto bits = static_cast<std::int32_t>(static_cast<std::uint32_t>(*constant));
      if (std::find(labels.begin(), labels.end(), bits) != labels.end())
        return fail(token.location, "this switch already has a case " + std::to_string(*constant));
      labels.push_back(bits);
      children.push_back(add({.kind = Statement::Kind::Case,
                              .expression = convert(label, type, token.location),
                              .location = token.location}));
    } while (accept(","));
  }
  accept(":");
  attributes();
}

// Parses a switch. Cases don't fall through, so we add a break to the end of each.
StatementId Parser::switchStatement() {
  const Location location = take().location;
  Operand selector = concrete(value(), location);
  if (!problems_.any() && !(selector.type.isScalar() && selector.type.isInteger()))
    fail(location, "expected an i32 or u32 as the value of this switch, got " + describe(selector));
  attributes();
  expect("{", "the value of a switch");
  ++switches_;
  std::vector<StatementId> children;
  std::vector<std::int32_t> labels;
  bool hasDefault = false;
  while (!peek().is("}") && !problems_.any()) {
    if (!peek().is("case") && !peek().is("default")) {
      fail(peek().location, "expected case or default, " + describeNext());
      break;
    }
    caseLabels(selector.type, children, labels, hasDefault);
    const Location end = peek().location;
    children.push_back(block());
    children.push_back(add({.kind = Statement::Kind::Break, .location = end}));
  }
  expect("}", "the cases of a switch");
  --switches_;
  if (!hasDefault) fail(location, "this switch needs a default; write default: {}");
  return add({.kind = Statement::Kind::Switch,
              .expression = selector.id,
              .location = location,
              .children = std::move(children)});
}

}  // namespace warpjet::source::wgsl
