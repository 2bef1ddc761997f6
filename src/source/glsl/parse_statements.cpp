// Statements.
#include <set>
#include <utility>

#include "source/glsl/parser.hpp"

namespace warpjet::source::glsl {

StatementId Parser::add(Statement statement) {
  tree_.statements.push_back(std::move(statement));
  return static_cast<StatementId>(tree_.statements.size() - 1);
}

StatementId Parser::makeBlock(Location location, std::vector<StatementId> children) {
  return add(Statement{
      .kind = Statement::Kind::Block, .location = location, .children = std::move(children)});
}

// Parses a block from its brace to the counterpart. The caller opens the block's scope.
StatementId Parser::block() {
  const Location location = peek().location;
  if (!expect("{", "the head of this function")) return nothing;
  std::vector<StatementId> children;
  while (!peek().is("}")) {
    if (peek().kind == Kind::End) {
      fail(location, "this { has no }");
      return nothing;
    }
    children.push_back(statement());
  }
  take();
  return makeBlock(location, std::move(children));
}

StatementId Parser::statement(bool opensScope) {
  if (!checkDepth()) return nothing;
  ++depth_;
  const Token& token = peek();
  const StatementId parsed = [&] {
    if (token.is("{")) {
      if (opensScope) scope_.open();
      const StatementId inner = block();
      if (opensScope) scope_.close();
      return inner;
    }
    if (token.is("if")) return ifStatement();
    if (token.is("for")) return forStatement();
    if (token.is("while")) return whileStatement();
    if (token.is("do")) return doStatement();
    if (token.is("switch")) return switchStatement();
    if (token.is("return")) return returnStatement();
    if (token.is("break") || token.is("continue") || token.is("discard")) return jump();
    if ((token.is("case") && !isDeclared(token)) || token.is("default")) {
      fail(token.location, quote(token.text) + " is outside of a switch");
      return nothing;
    }
    return simpleStatement();
  }();
  --depth_;
  return parsed;
}

// Parses a declaration or an expression, up to its semicolon.
StatementId Parser::simpleStatement() {
  const Token& token = peek();
  if (accept(";")) return makeBlock(token.location, {});
  if (token.is("precision")) {
    precision();
    return makeBlock(token.location, {});
  }
  const Qualifiers given = qualifiers();
  // `vec3(…)` and `float[](…)` start an expression.
  const bool isValue =
      peek(1).is("(") || (peek(1).is("[") && (peek(2).is("]") || peek(3).is("]")) &&
                          (peek(3).is("(") || peek(4).is("(")));
  if (given.any() || (startsType() && !isValue)) {
    const Type base = type();
    if (problems_.any()) return nothing;
    if (!given.any() && accept(";")) return makeBlock(token.location, {});
    if (base == voidType) fail(token.location, "a variable cannot be void");
    return problems_.any() ? nothing : declarations(given, base);
  }
  const ExpressionId value = expression();
  if (tree_.types.isBlock(typeOf(value)))
    fail(token.location, "a block of uniforms has no value; read one of its members");
  expect(";", "an expression");
  return add(Statement{
      .kind = Statement::Kind::Evaluate, .expression = value, .location = token.location});
}

StatementId Parser::ifStatement() {
  const Location location = take().location;
  const ExpressionId test = condition("if");
  const auto branch = [&] {
    scope_.open();
    const StatementId parsed = statement(false);
    scope_.close();
    return parsed;
  };
  std::vector<StatementId> children{branch()};
  if (accept("else")) children.push_back(branch());
  return add(Statement{.kind = Statement::Kind::If,
                       .expression = test,
                       .location = location,
                       .children = std::move(children)});
}

StatementId Parser::switchStatement() {
  requireVersion("switch", peek().location);
  const Location location = take().location;
  expect("(", "switch");
  const ExpressionId value = expression();
  expect(")", "the value of a switch");
  if (!problems_.any() && !(typeOf(value).isInteger() && typeOf(value).isScalar()))
    fail(location, "expected an int or uint as the value of this switch, got " +
                       tree_.types.withArticle(typeOf(value)));
  expect("{", "switch ( )");
  scope_.open();
  ++switches_;
  std::vector<StatementId> children;
  bool hasDefault = false;
  std::set<std::int32_t> labels;
  while (!peek().is("}") && peek().kind != Kind::End) {
    const Token& token = peek();
    if (token.is("case") || token.is("default")) {
      take();
      ExpressionId label = nothing;
      if (token.is("case")) {
        label = expression();
        if (problems_.any()) break;
        label = caseLabel(label, typeOf(value), labels, token.location);
      } else if (std::exchange(hasDefault, true)) {
        fail(token.location, "this switch already has a default");
      }
      expect(":", "a case");
      children.push_back(add(Statement{
          .kind = Statement::Kind::Case, .expression = label, .location = token.location}));
    } else if (children.empty()) {
      fail(token.location, "expected a case before this, " + describeNext());
    } else {
      children.push_back(statement());
    }
  }
  if (!problems_.any() && !children.empty() &&
      tree_.statements[children.back()].kind == Statement::Kind::Case)
    fail(tree_.statements[children.back()].location,
         "there is no statement after this label; write break; there");
  expect("}", "the cases of a switch");
  --switches_;
  scope_.close();
  return add(Statement{.kind = Statement::Kind::Switch,
                       .expression = value,
                       .location = location,
                       .children = std::move(children)});
}

// Checks a label, and returns a constant that replaces its expression.
ExpressionId Parser::caseLabel(ExpressionId label, Type wanted, std::set<std::int32_t>& labels,
                               Location location) {
  const auto known = constants_.integer(label);
  if (typeOf(label) != wanted || !known)
    return failExpression(location,
                          "expected a constant " + tree_.types.name(wanted) + " after case");
  const double number =
      wanted == intType ? *known : static_cast<double>(static_cast<std::uint32_t>(*known));
  if (!labels.insert(*known).second) {
    std::string text = std::to_string(static_cast<std::int64_t>(number));
    return failExpression(location, "this switch already has a case " + text + "; remove one");
  }
  return add(
      Expression{.kind = Code::Constant, .type = wanted, .value = number, .location = location});
}

StatementId Parser::returnStatement() {
  hasReturn_ = true;
  const Location location = take().location;
  const Type wanted = current_ == nothing ? voidType : tree_.functions[current_].type;
  ExpressionId value = nothing;
  if (!peek().is(";")) {
    value = expression();
    if (problems_.any()) return nothing;
    if (wanted == voidType) {
      fail(location, "this function is void and returns nothing; write return;");
    } else if (typeOf(value) != wanted) {
      fail(location, "expected this function to return " + tree_.types.withArticle(wanted) +
                         ", got " + tree_.types.withArticle(typeOf(value)));
    }
  } else if (wanted != voidType) {
    fail(location,
         "expected this function to return " + tree_.types.withArticle(wanted) + ", got nothing");
  }
  expect(";", "return");
  return add(Statement{.kind = Statement::Kind::Return, .expression = value, .location = location});
}

StatementId Parser::jump() {
  const Token token = take();
  if (token.is("discard")) {
    fail(token.location, "discard is for fragments; a warp moves vertices and discards none");
  } else if (token.is("break") ? !loops_ && !switches_ : !loops_) {
    fail(token.location, quote(token.text) + " is outside of a loop");
  }
  expect(";", token.text);
  return add(
      Statement{.kind = token.is("break") ? Statement::Kind::Break : Statement::Kind::Continue,
                .location = token.location});
}

}  // namespace warpjet::source::glsl
