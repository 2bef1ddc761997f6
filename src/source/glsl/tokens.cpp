#include "source/glsl/tokens.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

namespace warpjet::source::glsl {

namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isHexDigit(char c) { return isDigit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

// Longest first.
constexpr std::array symbols{
    std::string_view("<<="), std::string_view(">>="), std::string_view("++"),
    std::string_view("--"),  std::string_view("<="),  std::string_view(">="),
    std::string_view("=="),  std::string_view("!="),  std::string_view("&&"),
    std::string_view("||"),  std::string_view("^^"),  std::string_view("<<"),
    std::string_view(">>"),  std::string_view("+="),  std::string_view("-="),
    std::string_view("*="),  std::string_view("/="),  std::string_view("%="),
    std::string_view("&="),  std::string_view("|="),  std::string_view("^="),
};
constexpr std::string_view single = "()[]{}.,;:?+-*/%<>=!~&|^#";

std::string noCharacter(std::string_view character) {
  if (character == "\"")
    return "GLSL has no strings; replace an #include with the source in the file";
  const std::string what = "shaders do not allow this character";
  return character[0] == '\0' ? what + " (number 0)" : what + ": " + quote(character);
}

class Reader {
 public:
  Reader(std::string_view source, Problems& problems, std::span<const std::size_t> joins)
      : source_(source), problems_(problems), joins_(joins) {}

  std::vector<Token> read() {
    std::vector<Token> tokens;
    // A byte order mark, which some editors insert.
    if (source_.starts_with("\xEF\xBB\xBF")) at_ = lineStart_ = 3;
    while (skipSpace(), at_ < source_.size() && !problems_.any()) {
      tokens.push_back(next());
      startsLine_ = followsSpace_ = false;
    }
    tokens.push_back({Token::Kind::End, true, true, {}, location()});
    return tokens;
  }

 private:
  char peek(std::size_t ahead = 0) const {
    return at_ + ahead < source_.size() ? source_[at_ + ahead] : '\0';
  }

  Location location() {
    findLine();
    return {line_, static_cast<std::uint32_t>(at_ - lineStart_ + 1), line_};
  }

  void findLine() {
    for (; !joins_.empty() && joins_[0] <= at_; joins_ = joins_.subspan(1)) {
      ++line_;
      lineStart_ = joins_[0];
    }
  }

  // Skips the end of a line.
  void newLine() {
    findLine();
    ++line_;
    lineStart_ = ++at_;
  }

  void skipSpace() {
    for (;; followsSpace_ = true) {
      const char c = peek();
      if (at_ >= source_.size()) return;
      if (c == '\n') {
        newLine();
        startsLine_ = true;
      } else if (c == ' ' || c == '\t' || c == '\v' || c == '\f') {
        ++at_;
      } else if (c == '/' && peek(1) == '/') {
        while (at_ < source_.size() && peek() != '\n') ++at_;
      } else if (c == '/' && peek(1) == '*') {
        skipComment();
      } else {
        return;
      }
    }
  }

  void skipComment() {
    const Location start = location();
    const auto end = source_.find("*/", at_ + 2);
    if (end == source_.npos) {
      problems_.add(start, "this comment never ends; close it by */");
      at_ = source_.size();
      return;
    }
    while (at_ < end + 2) {
      if (peek() == '\n') {
        newLine();
      } else {
        ++at_;
      }
    }
  }

  Token token(Token::Kind kind, std::size_t size) {
    const Token found{kind, startsLine_, followsSpace_, source_.substr(at_, size), location()};
    at_ += size;
    return found;
  }

  Token next() {
    const char c = peek();
    if (isLetter(c)) {
      std::size_t size = 1;
      while (isLetter(peek(size)) || isDigit(peek(size))) ++size;
      return token(Token::Kind::Name, size);
    }
    if (isDigit(c) || (c == '.' && isDigit(peek(1)))) return number();
    for (const std::string_view symbol : symbols)
      if (source_.substr(at_).starts_with(symbol)) return token(Token::Kind::Symbol, symbol.size());
    if (single.find(c) != single.npos && c != '\0') return token(Token::Kind::Symbol, 1);
    std::size_t size = 1;
    while ((static_cast<unsigned char>(peek(size)) & 0xC0) == 0x80) ++size;
    return token(Token::Kind::Other, size);
  }

  Token number() {
    using enum Token::Kind;
    std::size_t size = 0;
    Token::Kind kind = Int;
    if (peek() == '0' && (peek(1) == 'x' || peek(1) == 'X')) {
      size = 2;
      while (isHexDigit(peek(size))) ++size;
    } else {
      while (isDigit(peek(size))) ++size;
      if (peek(size) == '.') {
        kind = Float;
        ++size;
        while (isDigit(peek(size))) ++size;
      }
      if (peek(size) == 'e' || peek(size) == 'E') {
        const std::size_t sign = peek(size + 1) == '+' || peek(size + 1) == '-';
        if (isDigit(peek(size + 1 + sign))) {
          kind = Float;
          size += 1 + sign;
          while (isDigit(peek(size))) ++size;
        }
      }
    }
    if (kind == Int && (peek(size) == 'u' || peek(size) == 'U')) {
      kind = Uint;
      ++size;
    } else if (kind == Float && (peek(size) == 'f' || peek(size) == 'F')) {
      ++size;
    }
    const std::size_t end = size;
    while (isLetter(peek(size)) || isDigit(peek(size))) ++size;
    return token(size > end ? Other : kind, size);
  }

  std::string_view source_;
  Problems& problems_;
  std::span<const std::size_t> joins_;
  std::size_t at_ = 0, lineStart_ = 0;
  std::uint32_t line_ = 1;
  bool startsLine_ = true, followsSpace_ = false;
};

}  // namespace

std::vector<Token> readTokens(std::string_view source, Problems& problems,
                              std::span<const std::size_t> joins) {
  return Reader(source, problems, joins).read();
}

std::string problemOf(const Token& other) {
  if (isDigit(other.text[0]) || other.text[0] == '.')
    return quote(other.text) + " is not a number; letters cannot follow digits";
  return noCharacter(other.text);
}

std::uint32_t intValue(const Token& token, Problems& problems) {
  std::string_view digits = token.text;
  if (token.kind == Token::Kind::Uint) digits.remove_suffix(1);
  unsigned base = 10;
  if (digits.size() > 1 && digits[0] == '0') {
    const bool isHex = digits[1] == 'x' || digits[1] == 'X';
    base = isHex ? 16 : 8;
    digits.remove_prefix(isHex ? 2 : 1);
  }
  std::uint64_t value = 0;
  bool isValid = !digits.empty();
  for (const char c : digits) {
    const unsigned digit =
        isDigit(c) ? static_cast<unsigned>(c - '0') : static_cast<unsigned>((c | 32) - 'a') + 10;
    value = value * base + digit;
    isValid = isValid && digit < base && value <= 0xFFFFFFFF;
    if (!isValid) break;
  }
  if (!isValid)
    problems.add(token.location, quote(token.text) + " is not a whole number of 32 bits");
  return static_cast<std::uint32_t>(value);
}

// Returns the value as a double. Beyond 3.4e38, it is an infinite float: GLSL ES 3.00, section
// 4.1.4.
double floatValue(const Token& token) {
  return std::strtod(std::string(token.text).c_str(), nullptr);
}

}  // namespace warpjet::source::glsl
