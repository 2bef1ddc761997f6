#include "source/wgsl/tokens.hpp"

#include <array>
#include <cstdlib>

namespace warpjet::source::wgsl {

namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isHexDigit(char c) { return isDigit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }
// Names may have letters of any language, which are several bytes in UTF-8.
bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

// Longest first.
constexpr std::array symbols{
    std::string_view("<<="), std::string_view("->"), std::string_view("++"), std::string_view("--"),
    std::string_view("<="),  std::string_view("=="), std::string_view("!="), std::string_view("&&"),
    std::string_view("||"),  std::string_view("<<"), std::string_view("+="), std::string_view("-="),
    std::string_view("*="),  std::string_view("/="), std::string_view("%="), std::string_view("&="),
    std::string_view("|="),  std::string_view("^="),
};
constexpr std::string_view single = "()[]{}.,;:+-*/%<>=!~&|^@?";

// Line ends and spaces beyond ASCII: WGSL, section 3.2.
constexpr std::array wideBlanks{std::string_view("\xC2\x85"), std::string_view("\xE2\x80\xA8"),
                                std::string_view("\xE2\x80\xA9"), std::string_view("\xE2\x80\x8E"),
                                std::string_view("\xE2\x80\x8F")};

std::string noCharacter(std::string_view character) {
  if (character == "#") return "WGSL has no preprocessor; write const, or remove this line";
  if (character == "\"" || character == "'") return "WGSL has no strings";
  const std::string what = "WGSL does not allow this character";
  return character[0] == '\0' ? what + " (number 0)" : what + ": " + quote(character);
}

class Reader {
 public:
  Reader(std::string_view source, Problems& problems) : source_(source), problems_(problems) {}

  std::vector<Token> read() {
    std::vector<Token> tokens;
    // A byte order mark, which some editors insert.
    if (source_.starts_with("\xEF\xBB\xBF")) at_ = lineStart_ = 3;
    while (skipSpace(), at_ < source_.size() && !problems_.any()) tokens.push_back(next());
    tokens.push_back({Token::Kind::End, source_.substr(at_, 0), location()});
    return tokens;
  }

 private:
  char peek(std::size_t ahead = 0) const {
    return at_ + ahead < source_.size() ? source_[at_ + ahead] : '\0';
  }

  Location location() const {
    return {line_, static_cast<std::uint32_t>(at_ - lineStart_ + 1), line_};
  }

  void advance() {
    if (peek() == '\n') {
      ++line_;
      lineStart_ = at_ + 1;
    }
    ++at_;
  }

  std::size_t wideBlank() const {
    for (const std::string_view blank : wideBlanks)
      if (source_.substr(at_).starts_with(blank)) return blank.size();
    return 0;
  }

  void skipSpace() {
    while (at_ < source_.size()) {
      const char c = peek();
      if (c == '\n' || c == ' ' || c == '\t' || c == '\v' || c == '\f') {
        advance();
      } else if (const std::size_t size = wideBlank()) {
        at_ += size;
      } else if (c == '/' && peek(1) == '/') {
        while (at_ < source_.size() && peek() != '\n') ++at_;
      } else if (c == '/' && peek(1) == '*') {
        skipComment();
      } else {
        return;
      }
    }
  }

  // Skips a block comment, and those nested in it.
  void skipComment() {
    const Location start = location();
    int depth = 0;
    do {
      if (at_ >= source_.size())
        return problems_.add(start, "this comment never ends; close it by */");
      if (peek() == '/' && peek(1) == '*') {
        ++depth;
        at_ += 2;
      } else if (peek() == '*' && peek(1) == '/') {
        --depth;
        at_ += 2;
      } else {
        advance();
      }
    } while (depth > 0);
  }

  Token token(Token::Kind kind, std::size_t size) {
    const Token found{kind, source_.substr(at_, size), location()};
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
    if (c == '\0' || single.find(c) == single.npos)
      problems_.add(location(), noCharacter(source_.substr(at_, 1)));
    return token(Token::Kind::Symbol, 1);
  }

  // Takes all characters that might belong to a number; readNumber checks them.
  Token number() {
    const bool isHex = peek() == '0' && (peek(1) == 'x' || peek(1) == 'X');
    std::size_t size = isHex ? 2 : 0;
    for (;; ++size) {
      const char c = peek(size), before = size ? peek(size - 1) : '\0';
      const bool isExponent =
          isHex ? before == 'p' || before == 'P' : before == 'e' || before == 'E';
      const bool isSign = (c == '+' || c == '-') && isExponent && isDigit(peek(size + 1));
      if (!isDigit(c) && !isLetter(c) && c != '.' && !isSign) break;
    }
    return token(Token::Kind::Number, size);
  }

  std::string_view source_;
  Problems& problems_;
  std::size_t at_ = 0, lineStart_ = 0;
  std::uint32_t line_ = 1;
};

// Skips digits from `at` on and returns how many they are.
template <class IsDigit>
std::size_t skipDigits(std::string_view text, std::size_t& at, const IsDigit& isAllowed) {
  const std::size_t start = at;
  while (at < text.size() && isAllowed(text[at])) ++at;
  return at - start;
}

}  // namespace

std::vector<Token> readTokens(std::string_view source, Problems& problems) {
  return Reader(source, problems).read();
}

std::optional<Number> readNumber(const Token& token, Problems& problems) {
  const std::string_view text = token.text;
  const auto fail = [&](const std::string& why) -> std::optional<Number> {
    problems.add(token.location, quote(text) + why);
    return std::nullopt;
  };
  const bool isHex = text.size() > 1 && text[0] == '0' && (text[1] | 32) == 'x';
  std::size_t at = isHex ? 2 : 0;
  const auto digits = [&] { return skipDigits(text, at, isHex ? isHexDigit : isDigit); };
  const std::size_t whole = digits();
  bool isFloat = false;
  std::size_t fraction = 0;
  if (at < text.size() && text[at] == '.') {
    isFloat = true;
    ++at;
    fraction = digits();
  }
  if (whole + fraction == 0) return fail(" is not a number; write digits after 0x");
  if (at < text.size() && (text[at] | 32) == (isHex ? 'p' : 'e')) {
    isFloat = true;
    at += at + 1 < text.size() && (text[at + 1] == '+' || text[at + 1] == '-') ? 2 : 1;
    if (skipDigits(text, at, isDigit) == 0) return fail(" is not a number; write its exponent");
  }
  const std::string_view suffix = text.substr(at);
  const bool mayBeFloat = !isHex || isFloat;
  if (suffix == "h") return fail(" is an f16, which a warp does not have; write f");
  const bool isKnown = suffix.empty() || (suffix == "f" && mayBeFloat) ||
                       ((suffix == "i" || suffix == "u") && !isFloat);
  if (!isKnown) return fail(" is not a number; letters cannot follow digits");
  if (!isHex && !isFloat && whole > 1 && text[0] == '0')
    return fail(" starts with 0, which WGSL does not allow; remove it");
  if (suffix == "f") isFloat = true;
  Number number{isFloat ? floatType : suffix == "u" ? uintType : intType, suffix.empty(), 0};
  number.value = std::strtod(std::string(text.substr(0, at)).c_str(), nullptr);
  if (isFloat) {
    const double maxFloat = number.isAbstract ? 1.7976931348623157e308 : 3.4028235677973366e38;
    if (!(number.value <= maxFloat)) return fail(" is too large for an f32");
    return number;
  }
  const double maxInt = number.isAbstract         ? 9223372036854775807.0
                        : number.type == uintType ? 4294967295.0
                                                  : 2147483647.0;
  if (number.value > maxInt)
    return fail(number.isAbstract
                    ? " is too large"
                    : " is too large for " + std::string(suffix == "u" ? "a u32" : "an i32"));
  return number;
}

}  // namespace warpjet::source::wgsl
