#include "glsl/condition.hpp"

#include "glsl/operators.hpp"

namespace warpjet::glsl {

namespace {

using Kind = Token::Kind;

constexpr int deepestIf = 200;

// Whole numbers of 32 bits that wrap around.
std::int32_t compute(Operator op, std::int32_t a, std::int32_t b) {
  const auto x = static_cast<std::uint32_t>(a), y = static_cast<std::uint32_t>(b);
  const auto wrapped = [](std::uint32_t value) { return static_cast<std::int32_t>(value); };
  switch (op) {
    case Operator::Or:
      return a || b;
    case Operator::Xor:
      return !a != !b;
    case Operator::And:
      return a && b;
    case Operator::BitOr:
      return a | b;
    case Operator::BitXor:
      return a ^ b;
    case Operator::BitAnd:
      return a & b;
    case Operator::Equal:
      return a == b;
    case Operator::Unequal:
      return a != b;
    case Operator::Less:
      return a < b;
    case Operator::Greater:
      return a > b;
    case Operator::AtMost:
      return a <= b;
    case Operator::AtLeast:
      return a >= b;
    case Operator::ShiftLeft:
      return wrapped(x << (y & 31));
    case Operator::ShiftRight:
      return a >> (y & 31);
    case Operator::Add:
      return wrapped(x + y);
    case Operator::Subtract:
      return wrapped(x - y);
    case Operator::Multiply:
      return wrapped(x * y);
    case Operator::Divide:
      return b == -1 ? wrapped(0 - x) : a / b;
    case Operator::Remainder:
      return b == -1 ? 0 : a % b;
  }
  return 0;
}

class Condition {
 public:
  Condition(const Token& word, std::vector<Token> tokens, Problems& problems)
      : tokens_(std::move(tokens)), problems_(problems) {
    end_.place = tokens_.empty() ? word.place : tokens_.back().place;
  }

  bool evaluate() {
    const std::int32_t value = binary(1);
    if (at_ < tokens_.size())
      problems_.add(peek().place, "this #if has more than one condition; join them by && or ||");
    return value != 0;
  }

 private:
  const Token& peek() const { return at_ < tokens_.size() ? tokens_[at_] : end_; }

  std::int32_t fail(std::string sentence) {
    problems_.add(peek().place, std::move(sentence));
    at_ = tokens_.size();
    return 0;
  }

  std::int32_t binary(int level) {
    std::int32_t left = unary();
    for (;;) {
      const OperatorRow* row = peek().kind == Kind::Symbol ? findOperator(peek().text) : nullptr;
      if (!row || row->level < level) return left;
      ++at_;
      const std::int32_t right = binary(row->level + 1);
      const bool divides = row->op == Operator::Divide || row->op == Operator::Remainder;
      if (divides && right == 0) return fail("this #if divides by zero");
      left = compute(row->op, left, right);
    }
  }

  std::int32_t unary() {
    if (++depth_ > deepestIf) return fail("this #if is nested more than 200 deep");
    const std::int32_t value = primary();
    --depth_;
    return value;
  }

  std::int32_t primary() {
    const Token& token = peek();
    if (token.kind == Kind::Int || token.kind == Kind::Uint) {
      ++at_;
      return static_cast<std::int32_t>(intValue(token, problems_));
    }
    if (token.is("!")) return ++at_, !unary();
    if (token.is("-"))
      return ++at_, static_cast<std::int32_t>(0u - static_cast<std::uint32_t>(unary()));
    if (token.is("+")) return ++at_, unary();
    if (token.is("~")) return ++at_, ~unary();
    if (token.is("(")) {
      ++at_;
      const std::int32_t value = binary(1);
      if (!peek().is(")")) return fail("a ) is missing in this #if");
      ++at_;
      return value;
    }
    // Not in the specification, but every WebGL takes it so.
    if (token.kind == Kind::Name) return ++at_, 0;
    return fail(at_ < tokens_.size() ? quoted(token.text) + " cannot stand in an #if"
                                     : "this #if ends before its condition does");
  }

  std::vector<Token> tokens_;
  Problems& problems_;
  Token end_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

bool evaluateCondition(const Token& word, std::span<const Token> tokens, Macros& macros,
                       Problems& problems) {
  // `defined` is answered before macros are expanded.
  std::vector<Token> answered;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (!tokens[i].is("defined")) {
      answered.push_back(tokens[i]);
      continue;
    }
    const bool hasParenthesis = i + 1 < tokens.size() && tokens[i + 1].is("(");
    const std::size_t name = i + (hasParenthesis ? 2 : 1), last = name + (hasParenthesis ? 1 : 0);
    if (last >= tokens.size() || tokens[name].kind != Kind::Name ||
        (hasParenthesis && !tokens[last].is(")"))) {
      problems.add(tokens[i].place, "defined needs a name");
      return false;
    }
    answered.push_back(
        {Kind::Int, false, true, macros.has(tokens[name].text) ? "1" : "0", tokens[i].place});
    i = last;
  }
  std::vector<Token> expanded;
  macros.expand(answered, expanded);
  return !problems.any() && Condition(word, std::move(expanded), problems).evaluate();
}

}  // namespace warpjet::glsl
