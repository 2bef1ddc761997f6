// Statements other than declarations and loops: WGSL, section 9.
#include "source/wgsl/parser.hpp"

namespace warpjet::source::wgsl {

StatementId Parser::add(Statement statement) {
  tree_.statements.push_back(std::move(statement));
  return static_cast<StatementId>(tree_.statements.size() - 1);
}

StatementId Parser::makeBlock(Location location, std::vector<StatementId> children) {
  return add(
      {.kind = Statement::Kind::Block, .location = location, .children = std::move(children)});
}

StatementId Parser::evaluate(ExpressionId expression, Location location) {
  return add({.kind = Statement::Kind::Evaluate, .expression = expression, .location = location});
}

// Parses from the brace to its counterpart. The caller opens its scope.
std::vector<StatementId> Parser::blockStatements() {
  const Location location = peek().location;
  std::vector<StatementId> children;
  if (!expect("{", "this")) return children;
  while (!peek().is("}") && !problems_.any()) {
    if (peek().kind == Token::Kind::End) {
      fail(location, "this { has no }");
      break;
    }
    if (const StatementId child = statement(); child != nothing) children.push_back(child);
  }
  take();
  return children;
}

StatementId Parser::block() {
  const Location location = peek().location;
  scopes_.open();
  std::vector<StatementId> children = blockStatements();
  scopes_.close();
  return makeBlock(location, std::move(children));
}

StatementId Parser::statement() {
  if (!checkDepth()) return nothing;
  return withDepth([&]() -> StatementId {
    if (accept(";")) return nothing;
    attributes();
    const Token token = peek();
    if (token.is("{")) return block();
    if (token.is("if")) return ifStatement();
    if (token.is("for")) return forStatement();
    if (token.is("while")) return whileStatement();
    if (token.is("loop")) return loopStatement();
    if (token.is("switch")) return switchStatement();
    if (token.is("return")) return returnStatement();
    if (token.is("break") || token.is("continue") || token.is("discard")) return jump();
    if (token.is("const_assert")) {
      constAssert();
      return nothing;
    }
    if (token.is("fn") || token.is("struct") || token.is("alias") || token.is("override")) {
      fail(token.location, quote(token.text) + " is for declarations outside of functions");
      return nothing;
    }
    if (token.is("case") || token.is("default") || token.is("continuing") || token.is("else")) {
      fail(token.location,
           token.is("continuing")
               ? "continuing must be the last statement of a loop"
               : quote(token.text) + " belongs to no " + (token.is("else") ? "if" : "switch"));
      return nothing;
    }
    const StatementId parsed = simpleStatement();
    expect(";", "a statement");
    return parsed;
  });
}

ExpressionId Parser::condition(std::string_view after) {
  const Location location = peek().location;
  const Operand test = value();
  if (!problems_.any() && (!test.type.isBool() || test.isPointer()))
    fail(location, "expected a bool as the condition of this " + std::string(after) + ", got " +
                       describe(test));
  return test.id == nothing ? failOperand(location, "").id : test.id;
}

StatementId Parser::ifStatement() {
  const Location location = take().location;
  const ExpressionId test = condition("if");
  std::vector<StatementId> children{block()};
  if (accept("else")) {
    if (!peek().is("if")) {
      children.push_back(block());
    } else if (checkDepth()) {
      children.push_back(withDepth([&] { return ifStatement(); }));
    }
  }
  return add({.kind = Statement::Kind::If,
              .expression = test,
              .location = location,
              .children = std::move(children)});
}

StatementId Parser::returnStatement() {
  const Location location = take().location;
  const Type wanted = tree_.functions[current_].type;
  ExpressionId result = nothing;
  if (isContinuing_) fail(location, "return is not allowed in a continuing block");
  if (!peek().is(";")) {
    const Operand given = value();
    if (problems_.any()) return nothing;
    if (wanted == voidType)
      fail(location, "this function returns nothing; write return; or -> and a type in its head");
    else if (!canConvert(given, wanted))
      fail(location,
           "expected this function to return " + describe(wanted) + ", got " + describe(given));
    result = convert(given, wanted, location);
  } else if (wanted != voidType) {
    fail(location, "expected this function to return " + describe(wanted) + ", got nothing");
  }
  expect(";", "return");
  return add({.kind = Statement::Kind::Return, .expression = result, .location = location});
}

StatementId Parser::jump() {
  const Token token = take();
  if (token.is("discard")) {
    expect(";", token.text);
    const Operand fails =
        unsupported(token.location, voidType,
                    "discard is for fragments; a warp moves vertices and discards none");
    return evaluate(fails.id, token.location);
  }
  const bool isInside = loops_ || (switches_ && token.is("break"));
  if (!isInside && !isContinuing_)
    fail(token.location, quote(token.text) + " is outside of a loop");
  if (!isInside)
    fail(token.location, peek().is("if")
                             ? "break if must be the last statement of a continuing block"
                             : quote(token.text) +
                                   " is not allowed in a continuing block; write "
                                   "break if at its end");
  expect(";", token.text);
  return add({.kind = token.is("break") ? Statement::Kind::Break : Statement::Kind::Continue,
              .location = token.location});
}

}  // namespace warpjet::source::wgsl
