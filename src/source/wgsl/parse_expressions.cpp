// Operators and their precedence: WGSL, section 8.19. Operators of some kinds can't be mixed
// without parentheses.
#include <array>

#include "source/wgsl/parser.hpp"

namespace warpjet::source::wgsl {

namespace {

constexpr std::array relations{std::string_view("<"),  std::string_view(">"),
                               std::string_view("<="), std::string_view(">="),
                               std::string_view("=="), std::string_view("!=")};

template <std::size_t size>
bool isOneOf(const std::array<std::string_view, size>& all, std::string_view text) {
  for (const std::string_view each : all)
    if (each == text) return true;
  return false;
}

constexpr std::array bitOperators{std::string_view("&"), std::string_view("|"),
                                  std::string_view("^")};

}  // namespace

// Returns the operator at the current position; >=, >> and >>= consist of several tokens.
std::string_view Parser::peekOperator() const {
  const Token &first = peek(), &second = peek(1);
  if (first.kind != Token::Kind::Symbol) return {};
  if (!first.is(">") || !first.touches(second)) return first.text;
  if (second.is("=")) return ">=";
  if (!second.is(">")) return ">";
  return peek(2).is("=") && second.touches(peek(2)) ? ">>=" : ">>";
}

void Parser::takeOperator(std::string_view text) {
  for (std::size_t i = 0; i < (text[0] == '>' ? text.size() : 1); ++i) take();
}

Operand Parser::value() {
  const Location location = peek().location;
  return load(expression(), location);
}

void Parser::rejectMixed(std::string_view before) {
  const std::string_view next = peekOperator();
  constexpr std::array all{std::string_view("||"), std::string_view("&&"), std::string_view("|"),
                           std::string_view("&"),  std::string_view("^"),  std::string_view("<<"),
                           std::string_view(">>"), std::string_view("+"),  std::string_view("-"),
                           std::string_view("*"),  std::string_view("/"),  std::string_view("%")};
  if (isOneOf(all, next) || isOneOf(relations, next))
    fail(peek().location, "expected parentheses, since WGSL does not define the order of " +
                              std::string(before) + " and " + std::string(next));
  rejectConditional();
}

void Parser::rejectConditional() {
  if (peek().is("?"))
    fail(peek().location, "WGSL has no ? : ; write select(valueIfFalse, valueIfTrue, condition)");
}

Operand Parser::expression() {
  if (!checkDepth()) return failOperand(peek().location, "");
  return withDepth([&]() -> Operand {
    const Operand first = unary();
    const std::string_view symbol = peekOperator();
    if (isOneOf(bitOperators, symbol)) return bitwise(first, symbol);
    Operand left = relational(first);
    const std::string_view logical = peekOperator();
    if (logical == "&&" || logical == "||") {
      while (peekOperator() == logical) {
        const Location location = take().location;
        left = makeBinary(logical == "&&" ? Operator::And : Operator::Or, left, relational(unary()),
                          location);
      }
      rejectMixed(logical);
    }
    rejectConditional();
    return left;
  });
}

Operand Parser::bitwise(Operand left, std::string_view symbol) {
  const Operator op = findOperator(symbol)->op;
  while (peekOperator() == symbol) {
    const Location location = take().location;
    left = makeBinary(op, left, unary(), location);
  }
  rejectMixed(symbol);
  return left;
}

Operand Parser::relational(Operand first) {
  const Operand left = shift(first);
  const std::string_view symbol = peekOperator();
  if (!isOneOf(relations, symbol)) return left;
  const Location location = peek().location;
  takeOperator(symbol);
  const Operand right = shift(unary());
  const std::string_view next = peekOperator();
  if (isOneOf(relations, next) || isOneOf(bitOperators, next)) rejectMixed(symbol);
  return makeBinary(findOperator(symbol)->op, left, right, location);
}

Operand Parser::shift(Operand first) {
  const std::string_view symbol = peekOperator();
  if (symbol == "<<" || symbol == ">>") {
    const Location location = peek().location;
    takeOperator(symbol);
    const Operand parsed = makeBinary(findOperator(symbol)->op, first, unary(), location);
    const std::string_view next = peekOperator();
    if (!isOneOf(relations, next) && next != "&&" && next != "||") rejectMixed(symbol);
    return parsed;
  }
  const Operand left = additive(first);
  const std::string_view next = peekOperator();
  // If `left` is a sum or product, `symbol` is its first operator; -- is a minus.
  if (next != symbol && (next == "<<" || next == ">>" || isOneOf(bitOperators, next)))
    rejectMixed(symbol.substr(0, 1));
  return left;
}

Operand Parser::additive(Operand first) {
  Operand left = multiplicative(first);
  while (peek().is("+") || peek().is("-") || peek().is("--")) {
    const Token token = take();
    // `a--b` is `a - -b`.
    Operand right = unary();
    if (token.is("--"))
      right = makeUnary({token.kind, "-", token.location}, load(right, token.location));
    left = makeBinary(token.is("+") ? Operator::Add : Operator::Subtract, left,
                      multiplicative(right), token.location);
  }
  return left;
}

Operand Parser::multiplicative(Operand first) {
  while (peek().is("*") || peek().is("/") || peek().is("%")) {
    const Token token = take();
    first = makeBinary(findOperator(token.text)->op, first, unary(), token.location);
  }
  return first;
}

Operand Parser::unary() {
  const Token token = peek();
  const bool isDoubleMinus = token.is("--");
  const bool isUnary = isDoubleMinus || token.is("-") || token.is("!") || token.is("~") ||
                       token.is("&") || token.is("*");
  if (!isUnary) return postfix(primary());
  if (!checkDepth()) return failOperand(token.location, "");
  take();
  const Operand operand = withDepth([&] { return unary(); });
  if (problems_.any()) return failOperand(token.location, "");
  if (token.is("&")) return addressOf(operand, token.location);
  if (token.is("*")) return dereference(operand, token.location);
  if (!isDoubleMinus) return makeUnary(token, load(operand, token.location));
  const Token minus{token.kind, "-", token.location};
  return makeUnary(minus, makeUnary(minus, load(operand, token.location)));
}

}  // namespace warpjet::source::wgsl
