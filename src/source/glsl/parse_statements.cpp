// Statements.
#include <set>
#include <utility>

#include "source/glsl/parser.hpp"

namespace warpjet::source::glsl {

StatementId Parser::add(Statement statement) {
  tree_.statements.push_back(std::move(statement));
  return static_cast<StatementId>(tree_.statements.size() - 1);
}

StatementId Parser::makeBlock(Location place, std::vector<StatementId> children) {
  return add(
      Statement{.kind = Statement::Kind::Block, .place = place, .children = std::move(children)});
}

// Parses from the brace to its counterpart. The caller opens its scope.
StatementId Parser::block() {
  const Location place = peek().place;
  if (!expect("{", "the head of this function")) return nothing;
  std::vector<StatementId> children;
  while (!peek().is("}")) {
    if (peek().kind == Kind::End) {
      fail(place, "this { has no }");
      return nothing;
    }
    children.push_back(statement());
  }
  take();
  return makeBlock(place, std::move(children));
}

StatementId Parser::statement(bool opensScope) {
  if (!goDeeper()) return nothing;
  ++depth_;
  const Token& token = peek();
  const StatementId made = [&] {
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
      fail(token.place, quoted(token.text) + " is outside of a switch");
      return nothing;
    }
    return simpleStatement();
  }();
  --depth_;
  return made;
}

// Parses a declaration or an expression, up to its semicolon.
StatementId Parser::simpleStatement() {
  const Token& token = peek();
  if (accept(";")) return makeBlock(token.place, {});
  if (token.is("precision")) {
    precision();
    return makeBlock(token.place, {});
  }
  const Qualifiers given = qualifiers();
  // `vec3(…)` and `float[](…)` start an expression.
  const bool isValue =
      peek(1).is("(") || (peek(1).is("[") && (peek(2).is("]") || peek(3).is("]")) &&
                          (peek(3).is("(") || peek(4).is("(")));
  if (given.any() || (startsType() && !isValue)) {
    const Type base = type();
    if (problems_.any()) return nothing;
    if (!given.any() && accept(";")) return makeBlock(token.place, {});
    if (base == voidType) fail(token.place, "a variable cannot be void");
    return problems_.any() ? nothing : declarations(given, base);
  }
  const ExpressionId value = expression();
  if (tree_.types.isBlock(typeOf(value)))
    fail(token.place, "a block of uniforms has no value; read one of its members");
  expect(";", "an expression");
  return add(
      Statement{.kind = Statement::Kind::Evaluate, .expression = value, .place = token.place});
}

StatementId Parser::ifStatement() {
  const Location place = take().place;
  const ExpressionId test = condition("if");
  const auto branch = [&] {
    scope_.open();
    const StatementId made = statement(false);
    scope_.close();
    return made;
  };
  std::vector<StatementId> children{branch()};
  if (accept("else")) children.push_back(branch());
  return add(Statement{.kind = Statement::Kind::If,
                       .expression = test,
                       .place = place,
                       .children = std::move(children)});
}

StatementId Parser::switchStatement() {
  requireVersion("switch", peek().place);
  const Location place = take().place;
  expect("(", "switch");
  const ExpressionId value = expression();
  expect(")", "the value of a switch");
  if (!problems_.any() && !(typeOf(value).isInteger() && typeOf(value).isScalar()))
    fail(place, "expected an int or uint as the value of this switch, got " +
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
        label = caseLabel(label, typeOf(value), labels, token.place);
      } else if (std::exchange(hasDefault, true)) {
        fail(token.place, "this switch already has a default");
      }
      expect(":", "a case");
      children.push_back(
          add(Statement{.kind = Statement::Kind::Case, .expression = label, .place = token.place}));
    } else if (children.empty()) {
      fail(token.place, "expected a case before this, " + describeNext());
    } else {
      children.push_back(statement());
    }
  }
  if (!problems_.any() && !children.empty() &&
      tree_.statements[children.back()].kind == Statement::Kind::Case)
    fail(tree_.statements[children.back()].place,
         "there is no statement after this label; write break; there");
  expect("}", "the cases of a switch");
  --switches_;
  scope_.close();
  return add(Statement{.kind = Statement::Kind::Switch,
                       .expression = value,
                       .place = place,
                       .children = std::move(children)});
}

// The label's constant, which replaces the expression.
ExpressionId Parser::caseLabel(ExpressionId label, Type wanted, std::set<std::int32_t>& labels,
                               Location place) {
  const auto known = constants_.integer(label);
  if (typeOf(label) != wanted || !known)
    return failExpression(place, "expected a constant " + tree_.types.name(wanted) + " after case");
  const double number =
      wanted == intType ? *known : static_cast<double>(static_cast<std::uint32_t>(*known));
  if (!labels.insert(*known).second) {
    std::string text = std::to_string(static_cast<std::int64_t>(number));
    return failExpression(place, "this switch already has a case " + text + "; remove one");
  }
  return add(Expression{.kind = Code::Constant, .type = wanted, .value = number, .place = place});
}

StatementId Parser::returnStatement() {
  hasReturn_ = true;
  const Location place = take().place;
  const Type wanted = current_ == nothing ? voidType : tree_.functions[current_].type;
  ExpressionId value = nothing;
  if (!peek().is(";")) {
    value = expression();
    if (problems_.any()) return nothing;
    if (wanted == voidType) {
      fail(place, "this function is void and returns nothing; write return;");
    } else if (typeOf(value) != wanted) {
      fail(place, "expected this function to return " + tree_.types.withArticle(wanted) + ", got " +
                      tree_.types.withArticle(typeOf(value)));
    }
  } else if (wanted != voidType) {
    fail(place,
         "expected this function to return " + tree_.types.withArticle(wanted) + ", got nothing");
  }
  expect(";", "return");
  return add(Statement{.kind = Statement::Kind::Return, .expression = value, .place = place});
}

StatementId Parser::jump() {
  const Token token = take();
  if (token.is("discard")) {
    fail(token.place, "discard is for fragments; a warp moves vertices and discards none");
  } else if (token.is("break") ? !loops_ && !switches_ : !loops_) {
    fail(token.place, quoted(token.text) + " is outside of a loop");
  }
  expect(";", token.text);
  return add(
      Statement{.kind = token.is("break") ? Statement::Kind::Break : Statement::Kind::Continue,
                .place = token.place});
}

}  // namespace warpjet::source::glsl
