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

}  // namespace

// Returns the operator at the current position; >=, >> and >>= consist of several tokens.
std::string_view Parser::operatorHere() const {
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
  const std::string_view next = operatorHere();
  constexpr std::array all{std::string_view("||"), std::string_view("&&"), std::string_view("|"),
                           std::string_view("&"),  std::string_view("^"),  std::string_view("<<"),
                           std::string_view(">>"), std::string_view("+"),  std::string_view("-"),
                           std::string_view("*"),  std::string_view("/"),  std::string_view("%")};
  if (isOneOf(all, next) || isOneOf(relations, next))
    fail(peek().location, "put parentheses around one of " + std::string(before) + " and " +
                              std::string(next) + ", whose order WGSL does not define");
  if (peek().is("?"))
    fail(peek().location, "WGSL has no ? : ; write select(valueIfFalse, valueIfTrue, condition)");
}

Operand Parser::expression() {
  if (!goDeeper()) return failOperand(peek().location, "");
  return deeper([&]() -> Operand {
    const Operand first = unary();
    const std::string_view symbol = operatorHere();
    if (symbol == "&" || symbol == "|" || symbol == "^") return bitwise(first, symbol);
    Operand left = relational(first);
    const std::string_view logical = operatorHere();
    if (logical == "&&" || logical == "||") {
      while (operatorHere() == logical) {
        const Location location = take().location;
        left = makeBinary(logical == "&&" ? Operator::And : Operator::Or, left, relational(unary()),
                          location);
      }
      rejectMixed(logical);
    }
    if (peek().is("?")) rejectMixed("");
    return left;
  });
}

Operand Parser::bitwise(Operand left, std::string_view symbol) {
  const Operator op = findOperator(symbol)->op;
  while (operatorHere() == symbol) {
    const Location location = take().location;
    left = makeBinary(op, left, unary(), location);
  }
  rejectMixed(symbol);
  return left;
}

Operand Parser::relational(Operand first) {
  const Operand left = shift(first);
  const std::string_view symbol = operatorHere();
  if (!isOneOf(relations, symbol)) return left;
  const Location location = peek().location;
  takeOperator(symbol);
  const Operand right = shift(unary());
  if (isOneOf(relations, operatorHere())) rejectMixed(symbol);
  return makeBinary(findOperator(symbol)->op, left, right, location);
}

Operand Parser::shift(Operand first) {
  const std::string_view symbol = operatorHere();
  if (symbol == "<<" || symbol == ">>") {
    const Location location = peek().location;
    takeOperator(symbol);
    const Operand parsed = makeBinary(findOperator(symbol)->op, first, unary(), location);
    const std::string_view next = operatorHere();
    if (!isOneOf(relations, next) && next != "&&" && next != "||") rejectMixed(symbol);
    return parsed;
  }
  const Operand left = additive(first);
  const std::string_view next = operatorHere();
  if (next == "<<" || next == ">>" || next == "&" || next == "|" || next == "^")
    rejectMixed("this");
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
  const bool isTwice = token.is("--");
  const bool isUnary =
      isTwice || token.is("-") || token.is("!") || token.is("~") || token.is("&") || token.is("*");
  if (!isUnary) return postfix(primary());
  if (!goDeeper()) return failOperand(token.location, "");
  take();
  const Operand operand = deeper([&] { return unary(); });
  if (problems_.any()) return failOperand(token.location, "");
  if (token.is("&")) return addressOf(operand, token.location);
  if (token.is("*")) return dereference(operand, token.location);
  if (!isTwice) return makeUnary(token, load(operand, token.location));
  const Token minus{token.kind, "-", token.location};
  return makeUnary(minus, makeUnary(minus, load(operand, token.location)));
}

}  // namespace warpjet::source::wgsl
