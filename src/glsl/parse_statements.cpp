// Statements, and declarations of variables.
#include <utility>

#include "glsl/constants.hpp"
#include "glsl/parser.hpp"

namespace warpjet::glsl {

StatementId Parser::add(Statement statement) {
  tree_.statements.push_back(std::move(statement));
  return static_cast<StatementId>(tree_.statements.size() - 1);
}

StatementId Parser::makeBlock(Location place, std::vector<StatementId> children) {
  return add(
      Statement{.kind = Statement::Kind::Block, .place = place, .children = std::move(children)});
}

// From its brace to the one that closes it. Its scope is the caller's.
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
      fail(token.place, quoted(token.text) + " stands outside of a switch");
      return nothing;
    }
    return simpleStatement();
  }();
  --depth_;
  return made;
}

// A declaration or an expression, up to its semicolon.
StatementId Parser::simpleStatement() {
  const Token& token = peek();
  if (accept(";")) return makeBlock(token.place, {});
  if (token.is("precision")) {
    while (peek().kind != Kind::End && !accept(";")) take();
    return makeBlock(token.place, {});
  }
  const Qualifiers given = qualifiers();
  // `vec3(…)` and `float[](…)` begin an expression.
  const bool isValue =
      peek(1).is("(") || (peek(1).is("[") && (peek(2).is("]") || peek(3).is("]")) &&
                          (peek(3).is("(") || peek(4).is("(")));
  if (given.any || (startsType() && !isValue)) {
    const Type base = type();
    if (problems_.any()) return nothing;
    if (base.isStruct() && accept(";")) return makeBlock(token.place, {});
    if (base == voidType) fail(token.place, "a variable cannot be void");
    return problems_.any() ? nothing : declarations(given, base);
  }
  const ExpressionId value = expression();
  expect(";", "an expression");
  return add(
      Statement{.kind = Statement::Kind::Evaluate, .expression = value, .place = token.place});
}

// `float x = 1.0, y;` from its first name on.
StatementId Parser::declarations(Qualifiers given, Type base) {
  const Location place = peek().place;
  std::vector<StatementId> all;
  do {
    const Token name = peek();
    if (!checkFree(name)) return nothing;
    take();
    if (peek().is("(")) {
      fail(name.place, "a function cannot stand inside another one");
      return nothing;
    }
    if (base.isArray() && peek().is("[")) {
      fail(peek().place, "an array of arrays is not in the language");
      return nothing;
    }
    const Type each = peek().is("[") ? arrayOf(base) : base;
    all.push_back(declaration(given, each, name));
  } while (accept(","));
  expect(";", "a declaration");
  return all.size() == 1 ? all[0] : makeBlock(place, std::move(all));
}

StatementId Parser::declaration(Qualifiers given, Type type, const Token& name) {
  using enum Variable::Kind;
  Variable::Kind kind = given.isConst ? Constant : given.kind;
  if (kind == Local && current_ == nothing) kind = Global;
  if (current_ != nothing && given.any && !given.isConst && given.kind != Local) {
    fail(name.place, "only constants and plain variables can be declared in a function");
    return nothing;
  }
  ExpressionId start = nothing;
  if (accept("=")) {
    // A variable is known from here on, not in its own value.
    start = assignment();
    if (problems_.any()) return nothing;
    if (tree_.types.hasArray(typeOf(start))) requireVersion("an assignment of arrays", name.place);
    if (type.length == 0 && typeOf(start).isArray() && typeOf(start).element() == type.element())
      type = typeOf(start);
    if (kind == Uniform || kind == Attribute) {
      fail(name.place, "the host gives " + quoted(name.text) + " its value; leave = out");
    } else if (typeOf(start) != type) {
      fail(name.place, quoted(name.text) + " is " + tree_.types.withArticle(type) + ", but " +
                           tree_.types.withArticle(typeOf(start)) +
                           " came; GLSL converts nothing by itself");
    }
  } else if (given.isConst) {
    fail(name.place, "the constant " + quoted(name.text) + " needs a value");
  }
  if (type.length == 0) fail(name.place, "the array " + quoted(name.text) + " needs a length");
  if (tree_.types.hasSampler(type) && (kind != Uniform || type != samplerType))
    fail(name.place, "an image can only be a uniform sampler2D by itself");
  if (problems_.any()) return nothing;
  const VariableId variable = addVariable(name, type, kind);
  tree_.variables[variable].start = start;
  if (kind == Constant && start != nothing)
    tree_.variables[variable].known = constantNumber(tree_, start);
  return add(Statement{.kind = Statement::Kind::Declare,
                       .index = variable,
                       .expression = start,
                       .place = name.place});
}

ExpressionId Parser::condition(std::string_view after) {
  expect("(", after);
  if (startsType() && !peek(1).is("(")) {
    fail(peek().place, "declare this variable before the " + std::string(after));
    return nothing;
  }
  const Location place = peek().place;
  const ExpressionId value = expression();
  expect(")", "a condition");
  if (!problems_.any() && !typeOf(value).isBool())
    fail(place, "the condition of this " + std::string(after) + " must be a bool, but is " +
                    tree_.types.withArticle(typeOf(value)));
  return value;
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

StatementId Parser::forStatement() {
  const Location place = take().place;
  scope_.open();
  expect("(", "for");
  const StatementId start = simpleStatement();
  ExpressionId test = nothing;
  StatementId step = nothing;
  const Location testPlace = peek().place;
  if (!peek().is(";")) {
    test = expression();
    if (!problems_.any() && !typeOf(test).isBool())
      fail(testPlace, "the condition of this for must be a bool, but is " +
                          tree_.types.withArticle(typeOf(test)));
  }
  expect(";", "the condition of a for");
  if (!peek().is(")")) {
    const Location stepPlace = peek().place;
    step = add(Statement{
        .kind = Statement::Kind::Evaluate, .expression = expression(), .place = stepPlace});
  }
  expect(")", "the head of a for");
  const std::size_t outer = counters_.size();
  if (!problems_.any()) requireCounting(start, test, step, place);
  ++loops_;
  const StatementId body = statement(false);
  --loops_;
  counters_.resize(outer);
  scope_.close();
  return add(Statement{.kind = Statement::Kind::Loop,
                       .expression = test,
                       .place = place,
                       .children = {start, step, body}});
}

// The loops that GLSL ES 1.00 has, appendix A.4: one number counts from a constant to a constant by
// a constant, and its body leaves it alone.
void Parser::requireCounting(StatementId start, ExpressionId test, StatementId step,
                             Location place) {
  if (text_.version != 100) return;
  const auto counter = [&]() -> VariableId {
    const Statement& declared = tree_.statements[start];
    if (declared.kind != Statement::Kind::Declare || declared.expression == nothing) return nothing;
    const Type type = tree_.variables[declared.index].type;
    const bool isNumber = type == intType || type == floatType;
    return isNumber && isConstant(tree_, declared.expression) ? declared.index : nothing;
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
           isConstant(tree_, node.operands[1]);
  };
  const auto isStepped = [&] {
    if (step == nothing) return false;
    const Expression& node = tree_.expressions[tree_.statements[step].expression];
    if (node.kind == Code::Increment) return isCounter(node.operands[0]);
    return node.kind == Code::Assign && node.isCombined &&
           (node.op == Operator::Add || node.op == Operator::Subtract) &&
           isCounter(node.operands[0]) && isConstant(tree_, node.operands[1]);
  };
  if (counter == nothing || !isCompared() || !isStepped())
    return requireVersion("a for whose counter does not start, end and step by constants", place);
  counters_.push_back(counter);
}

StatementId Parser::whileStatement() {
  requireVersion("while", peek().place);
  const Location place = take().place;
  const ExpressionId test = condition("while");
  scope_.open();
  ++loops_;
  const StatementId body = statement(false);
  --loops_;
  scope_.close();
  return add(Statement{.kind = Statement::Kind::Loop,
                       .expression = test,
                       .place = place,
                       .children = {nothing, nothing, body}});
}

StatementId Parser::doStatement() {
  requireVersion("do", peek().place);
  const Location place = take().place;
  scope_.open();
  ++loops_;
  const StatementId body = statement(false);
  --loops_;
  scope_.close();
  if (!accept("while")) fail(peek().place, "a while is missing after the body of do; " + found());
  const ExpressionId test = condition("while");
  expect(";", "do … while ( )");
  return add(Statement{.kind = Statement::Kind::Loop,
                       .isLate = true,
                       .expression = test,
                       .place = place,
                       .children = {nothing, nothing, body}});
}

StatementId Parser::switchStatement() {
  requireVersion("switch", peek().place);
  const Location place = take().place;
  expect("(", "switch");
  const ExpressionId value = expression();
  expect(")", "the value of a switch");
  if (!problems_.any() && !(typeOf(value).isWhole() && typeOf(value).isScalar()))
    fail(place, "a switch goes by an int or uint, but " + tree_.types.withArticle(typeOf(value)) +
                    " came");
  expect("{", "switch ( )");
  scope_.open();
  ++switches_;
  std::vector<StatementId> children;
  bool hasDefault = false;
  while (!peek().is("}") && peek().kind != Kind::End) {
    const Token& token = peek();
    if (token.is("case") || token.is("default")) {
      take();
      ExpressionId label = nothing;
      if (token.is("case")) {
        label = expression();
        if (problems_.any()) break;
        if (typeOf(label) != typeOf(value) || !constantInt(tree_, label))
          fail(token.place, "a case needs a constant " + tree_.types.name(typeOf(value)));
      } else if (std::exchange(hasDefault, true)) {
        fail(token.place, "this switch has a default already");
      }
      expect(":", "a case");
      children.push_back(
          add(Statement{.kind = Statement::Kind::Case, .expression = label, .place = token.place}));
    } else if (children.empty()) {
      fail(token.place, "a case is missing before this; " + found());
    } else {
      children.push_back(statement());
    }
  }
  expect("}", "the cases of a switch");
  --switches_;
  scope_.close();
  return add(Statement{.kind = Statement::Kind::Switch,
                       .expression = value,
                       .place = place,
                       .children = std::move(children)});
}

StatementId Parser::returnStatement() {
  const Location place = take().place;
  const Type wanted = current_ == nothing ? voidType : tree_.functions[current_].type;
  ExpressionId value = nothing;
  if (!peek().is(";")) {
    value = expression();
    if (problems_.any()) return nothing;
    if (wanted == voidType) {
      fail(place, "this function is void and gives nothing back; write return;");
    } else if (typeOf(value) != wanted) {
      fail(place, "this function gives " + tree_.types.withArticle(wanted) + ", but returns " +
                      tree_.types.withArticle(typeOf(value)));
    }
  } else if (wanted != voidType) {
    fail(place, "this function gives " + tree_.types.withArticle(wanted) + ", but returns nothing");
  }
  expect(";", "return");
  return add(Statement{.kind = Statement::Kind::Return, .expression = value, .place = place});
}

StatementId Parser::jump() {
  const Token token = take();
  if (token.is("discard")) {
    fail(token.place, "discard is for fragments; a warp moves vertices and leaves out none");
  } else if (token.is("break") ? !loops_ && !switches_ : !loops_) {
    fail(token.place, quoted(token.text) + " stands outside of a loop");
  }
  expect(";", token.text);
  return add(
      Statement{.kind = token.is("break") ? Statement::Kind::Break : Statement::Kind::Continue,
                .place = token.place});
}

}  // namespace warpjet::glsl
