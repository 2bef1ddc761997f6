#include "mesh/text/lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/messages.hpp"
#include "mesh/text/encoding.hpp"
#include "mesh/text/number.hpp"

namespace warpjet {

namespace {

// Returns true for white space within a line. That includes line breaks, since lines may be joined.
bool isSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// Removes a comment, which starts with #. A # inside of a word is part of the word, as in my#1.mtl
// or 1.#QNAN, except after a digit.
std::string_view withoutComment(std::string_view line) {
  std::size_t end = line.find('#');
  while (end != line.npos && end > 0 && !isSpace(line[end - 1]) &&
         !(line[end - 1] >= '0' && line[end - 1] <= '9'))
    end = line.find('#', end + 1);
  return line.substr(0, end);
}

// Returns true if the line ends with a backslash, which joins the next line.
bool isContinued(std::string_view line) { return line.ends_with('\\') || line.ends_with("\\\r"); }

}  // namespace

std::string_view TextLine::word() {
  // A backslash joins two lines.
  do {
    const auto start = std::find_if_not(rest_.begin(), rest_.end(), isSpace);
    rest_.remove_prefix(static_cast<std::size_t>(start - rest_.begin()));
    if (!rest_.starts_with('\\') || (rest_.size() > 1 && !isSpace(rest_[1]))) break;
    rest_.remove_prefix(1);
  } while (true);
  const auto end = std::find_if(rest_.begin(), rest_.end(), isSpace);
  std::string_view found = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
  rest_.remove_prefix(found.size());
  if (found.ends_with('\\')) found.remove_suffix(1);
  return found;
}

std::string_view TextLine::rest() const {
  std::string_view name = rest_;
  while (!name.empty() && isSpace(name.front())) name.remove_prefix(1);
  while (!name.empty() && isSpace(name.back())) name.remove_suffix(1);
  return name;
}

std::string TextLine::problem(const std::string& what) const {
  return "line " + groupDigits(lineNumber_) + " of the ." + std::string(format_) + ' ' + what +
         "; export the model again.";
}

void TextLine::fail(const std::string& what) const { throw FileProblem(problem(what)); }

float TextLine::parseNumber(std::string_view text) {
  const std::optional<float> number = parseFloat(text);
  if (number && std::isfinite(*number)) return *number;
  if (!number && !isPrintedNonNumber(text))
    fail("has " + quoteText(text) + " where a number belongs");
  if (nonNumber_.empty()) nonNumber_ = text;
  return std::numeric_limits<float>::quiet_NaN();
}

std::string TextLine::problemOfNumber() const {
  const std::string text = quoteText(nonNumber_);
  return problem(isPrintedNonNumber(nonNumber_)
                     ? "has " + text + " where a number belongs"
                     : "has the number " + text + ", which is too large");
}

std::optional<TextLine> TextLines::next() {
  while (rest_.starts_with(utf8Mark)) rest_.remove_prefix(utf8Mark.size());
  if (rest_.empty()) return std::nullopt;
  const std::size_t lineNumber = lineNumber_ += joined_ + 1;
  joined_ = 0;
  std::size_t end = rest_.find(end_);
  for (; end != rest_.npos; end = rest_.find(end_, end + 1)) {
    if (!isContinued(rest_.substr(0, end))) break;
    ++joined_;
  }
  const std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
  return TextLine(withoutComment(line), format_, lineNumber);
}

}  // namespace warpjet
