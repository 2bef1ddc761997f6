#include "module/syntax.hpp"

#include <algorithm>
#include <array>

namespace warpjet {

namespace {

std::size_t wordLength(std::string_view text) {
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), isWordPart) -
                                  text.begin());
}

std::size_t digitsLength(std::string_view text) {
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), isDigit) -
                                  text.begin());
}

// Returns the length of a number such as 12, 1.5, .5, 1e-3 or 2u.
std::size_t numberLength(std::string_view text) {
  std::size_t length = digitsLength(text);
  if (text.substr(length).starts_with('.')) length += 1 + digitsLength(text.substr(length + 1));
  std::string_view rest = text.substr(length);
  if (!rest.empty() && (rest[0] == 'e' || rest[0] == 'E')) {
    const bool hasSign = rest.size() > 1 && (rest[1] == '+' || rest[1] == '-');
    const std::size_t digits = digitsLength(rest.substr(hasSign ? 2 : 1));
    if (digits > 0) length += (hasSign ? 2 : 1) + digits;
  }
  rest = text.substr(length);
  if (!rest.empty() && (rest[0] == 'u' || rest[0] == 'f')) ++length;
  return length;
}

constexpr std::array<std::string_view, 9> pairs{"<=", ">=", "==", "!=", "&&",
                                                "||", "^^", "<<", ">>"};

bool isPair(std::string_view two) {
  return std::find(pairs.begin(), pairs.end(), two) != pairs.end();
}

bool startsNumber(std::string_view text, bool operandDue) {
  return isDigit(text[0]) || (text[0] == '.' && operandDue && text.size() > 1 && isDigit(text[1]));
}

std::size_t tokenLength(std::string_view text, bool operandDue) {
  if (startsNumber(text, operandDue)) return numberLength(text);
  if (isWordStart(text[0])) return wordLength(text);
  return isPair(text.substr(0, 2)) ? 2 : 1;
}

// Parses an expression from left to right. Operands and operators alternate, and every bracket and
// question mark requires its counterpart.
class Reader {
 public:
  Reader(std::string_view text, std::string_view operators) : rest_(text), operators_(operators) {}

  std::string problem() {
    while (!rest_.empty()) {
      if (rest_[0] == ' ') {
        rest_.remove_prefix(1);
        continue;
      }
      if (std::string found = readToken(); !found.empty()) return found;
    }
    if (!awaited_.empty()) return quote({&awaited_.back(), 1}) + " is missing in it";
    return operandDue_ ? operandMissing : std::string();
  }

 private:
  static constexpr const char* operandMissing = "an operand is missing in it";
  static constexpr const char* operatorMissing = "an operator is missing in it";

  std::string readToken() {
    const char c = rest_[0];
    const std::size_t length = tokenLength(rest_, operandDue_);
    if (startsNumber(rest_, operandDue_)) {
      if (isWordPart(peek(length)) || peek(length) == '.') return operatorMissing;
      return readOperand(length, false);
    }
    if (isWordStart(c)) return readOperand(length, true);
    switch (c) {
      case '(':
      case '[':
        return readOpening(c);
      case ')':
      case ']':
        return readClosing(c);
      case '.':
        return readMember();
      default:
        return readOperator();
    }
  }

  std::string readOperand(std::size_t length, bool isName) {
    if (!operandDue_) return operatorMissing;
    operandDue_ = false;
    afterName_ = isName;
    rest_.remove_prefix(length);
    return {};
  }

  std::string readOpening(char c) {
    if (c == '[' && operandDue_) return operandMissing;
    const bool isCall = c == '(' && !operandDue_;
    if (isCall && !afterName_) return operatorMissing;
    awaited_ += c == '(' ? ')' : ']';
    rest_.remove_prefix(1);
    const std::size_t next = rest_.find_first_not_of(' ');
    const bool isEmptyCall = isCall && next != rest_.npos && rest_[next] == ')';
    operandDue_ = !isEmptyCall;
    afterName_ = false;
    return {};
  }

  std::string readClosing(char c) {
    if (operandDue_) return operandMissing;
    if (awaited_.empty() || awaited_.back() != c)
      return "the brackets in it do not match at " + quote({&c, 1});
    awaited_.pop_back();
    rest_.remove_prefix(1);
    afterName_ = false;
    return {};
  }

  std::string readMember() {
    if (operandDue_ || !isWordStart(peek(1))) return operandMissing;
    rest_.remove_prefix(1);
    rest_.remove_prefix(wordLength(rest_));
    afterName_ = true;
    return {};
  }

  std::string readOperator() {
    constexpr std::array<std::string_view, 4> forbidden{"//", "/*", "++", "--"};
    constexpr std::string_view singles = "+-*/%<>!&|^~?:,", prefixes = "+-!~";
    const std::string_view two = rest_.substr(0, 2), single = rest_.substr(0, 1);

    const bool isLogical = two == "&&" || two == "||" || two == "^^";
    const bool isShift = two == "<<" || two == ">>";
    // ^^ exists only in GLSL, like ?:
    const std::string_view needed = two == "^^" ? "?" : isShift ? "&" : isLogical ? "" : single;
    if (optionalOperators.find(needed) != optionalOperators.npos &&
        operators_.find(needed) == operators_.npos)
      return quote(single) + " is not allowed in it";
    if (std::find(forbidden.begin(), forbidden.end(), two) != forbidden.end())
      return quote(two) + " is not allowed in it";
    const bool isTwo = isPair(two);
    if (single[0] < ' ' || single[0] > '~') return "only ASCII characters are allowed in it";
    if (!isTwo && singles.find(single) == singles.npos)
      return quote(single) + " is not allowed in it";
    if (operandDue_ && (isTwo || prefixes.find(single) == prefixes.npos)) return operandMissing;
    if (!operandDue_ && (single == "!" || single == "~") && !isTwo) return operatorMissing;

    if (single == "?") awaited_ += ':';
    if (single == ":" || single == ",") {
      const char partner = single == ":" ? ':' : ')';
      if (awaited_.empty() || awaited_.back() != partner)
        return quote(single) + " is not allowed there";
      if (single == ":") awaited_.pop_back();
    }
    operandDue_ = true;
    rest_.remove_prefix(isTwo ? 2 : 1);
    return {};
  }

  char peek(std::size_t ahead) const { return ahead < rest_.size() ? rest_[ahead] : '\0'; }

  std::string_view rest_;
  std::string awaited_;
  std::string_view operators_;
  bool operandDue_ = true;
  bool afterName_ = false;
};

}  // namespace

std::vector<std::string_view> tokensOf(std::string_view text) {
  std::vector<std::string_view> found;
  bool operandDue = true;
  for (std::size_t i = text.find_first_not_of(' '); i < text.size();
       i = text.find_first_not_of(' ', i)) {
    const std::string_view rest = text.substr(i);
    found.push_back(rest.substr(0, tokenLength(rest, operandDue)));
    const char last = found.back().back();
    operandDue = !isWordPart(last) && last != ')' && last != ']';
    i += found.back().size();
  }
  return found;
}

std::vector<std::string_view> identifiers(std::string_view text) {
  std::vector<std::string_view> found;
  for (std::size_t i = 0; i < text.size();) {
    if (!isWordPart(text[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && isWordPart(text[end])) ++end;
    const bool isMember = i > 0 && text[i - 1] == '.';
    if (isWordStart(text[i]) && !isMember) found.push_back(text.substr(i, end - i));
    i = end;
  }
  return found;
}

std::string syntaxProblem(std::string_view text, std::string_view operators) {
  return Reader(text, operators).problem();
}

}  // namespace warpjet
