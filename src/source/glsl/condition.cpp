#include "source/glsl/condition.hpp"

#include "source/nearest.hpp"
#include "source/operators.hpp"

namespace warpjet::source::glsl {

using Kind = Token::Kind;

namespace {

constexpr int maxIfDepth = 200;

// Applies an operator to 32-bit integers; results wrap around.
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
      return wrapped(x << y);
    case Operator::ShiftRight:
      return a >> b;
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
  Condition(const Token& directive, std::vector<Token> tokens, const Macros& macros,
            Problems& problems)
      : tokens_(std::move(tokens)), macros_(macros), problems_(problems), what_("#") {
    end_.location = tokens_.empty() ? directive.location : tokens_.back().location;
    what_ += directive.text;
  }

  bool evaluate() {
    const std::int32_t value = next();
    if (!isAtEnd()) fail("this " + what_ + " has more than one condition; join them by && or ||");
    return value != 0;
  }

  std::int32_t next() { return binary(1); }
  bool isAtEnd() const { return at_ >= tokens_.size(); }
  std::int32_t fail(std::string message) {
    problems_.add(peek().location, std::move(message));
    at_ = tokens_.size();
    return 0;
  }

 private:
  const Token& peek() const { return at_ < tokens_.size() ? tokens_[at_] : end_; }

  std::int32_t binary(int level) {
    std::int32_t left = unary();
    for (;;) {
      const OperatorRow* row = peek().kind == Kind::Symbol ? findOperator(peek().text) : nullptr;
      if (!row || row->level < level) return left;
      if (row->op == Operator::Xor) return fail("^^ is not allowed in " + what_ + "; write !=");
      ++at_;
      // If the first operand of && or || decides, the second one doesn't count.
      const bool isLeft =
          row->op == Operator::And ? left == 0 : row->op == Operator::Or && left != 0;
      skipped_ += isLeft;
      const std::int32_t right = binary(row->level + 1);
      skipped_ -= isLeft;
      left = computed(row->op, left, right);
    }
  }

  std::int32_t computed(Operator op, std::int32_t left, std::int32_t right) {
    const bool divides = op == Operator::Divide || op == Operator::Remainder;
    const bool shifts = op == Operator::ShiftLeft || op == Operator::ShiftRight;
    const bool isWrong = (divides && right == 0) || (shifts && (right < 0 || right > 31));
    if (!isWrong) return compute(op, left, right);
    if (skipped_) return 0;
    return fail("this " + what_ +
                (divides ? " divides by zero" : " shifts by less than 0 or more than 31"));
  }

  std::int32_t unary() {
    if (++depth_ > maxIfDepth) return fail("this " + what_ + " is nested more than 200 deep");
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
      if (!peek().is(")")) return fail("expected ) in this " + what_);
      ++at_;
      return value;
    }
    if (token.kind == Kind::Name && skipped_) return ++at_, 0;
    if (token.kind == Kind::Name && what_ == "#line")
      return fail("expected a line number after #line, got " + quote(token.text));
    if (token.kind == Kind::Name) return fail(unknown(token.text));
    return fail(at_ < tokens_.size() ? quote(token.text) + " is not allowed in " + what_
                                     : "the condition of this " + what_ + " is incomplete");
  }

  std::string unknown(std::string_view name) const {
    Nearest nearest(name);
    macros_.each([&](std::string_view other) { nearest.offer(other); });
    return "no #define gives " + quote(name) + " a value; define it, or write defined(" +
           std::string(name) + ")" + nearest.question();
  }

  std::vector<Token> tokens_;
  const Macros& macros_;
  Problems& problems_;
  std::string what_;
  Token end_;
  std::size_t at_ = 0;
  int depth_ = 0;
  // The number of enclosing operands that don't count.
  int skipped_ = 0;
};

}  // namespace

bool evaluateCondition(const Token& directive, std::span<const Token> tokens, Macros& macros,
                       Problems& problems) {
  // `defined` is evaluated before macros are expanded.
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
      problems.add(tokens[i].location, "defined needs a name");
      return false;
    }
    answered.push_back(
        {Kind::Int, false, true, macros.has(tokens[name].text) ? "1" : "0", tokens[i].location});
    i = last;
  }
  std::vector<Token> expanded;
  macros.expand(answered, expanded);
  return !problems.any() && Condition(directive, std::move(expanded), macros, problems).evaluate();
}

LineNumbers evaluateLine(const Token& directive, std::span<const Token> tokens, Macros& macros,
                         Problems& problems) {
  std::vector<Token> expanded;
  macros.expand(tokens, expanded);
  if (expanded.empty()) problems.add(directive.location, "expected a line number after #line");
  for (const Token& token : expanded)
    if (token.kind == Kind::Int && intValue(token, problems) >= 0x7fffffff)
      problems.add(token.location, "this line number is too large");
  Condition reader(directive, std::move(expanded), macros, problems);
  LineNumbers numbers;
  if (!problems.any()) numbers.line = reader.next();
  if (!problems.any() && !reader.isAtEnd()) numbers.file = reader.next();
  if (!problems.any() && !reader.isAtEnd())
    reader.fail("#line takes a line number and a file number, and nothing else");
  return numbers;
}

}  // namespace warpjet::source::glsl
