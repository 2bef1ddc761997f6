// The lines of OBJ, MTL and STL files, and the words and numbers on them. The text needs no
// terminating zero.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace warpjet {

template <std::size_t maxCount>
struct LineNumbers {
  std::array<float, maxCount> values{};
  std::size_t count = 0;
  bool isFinite = true;  // true if all numbers read are finite
};

class TextLine {
 public:
  // `format` is "obj", for example.
  TextLine(std::string_view text, std::string_view format, std::size_t lineNumber)
      : rest_(text), format_(format), lineNumber_(lineNumber) {}

  // Returns the next word on the line; empty at its end.
  std::string_view word();

  // Returns the rest of the line without spaces around it: a name, which may contain spaces.
  std::string_view rest() const;

  // Parses a number. Returns NaN for numbers that are not finite in float32, and for the spellings
  // of NaN and infinity in other programs. Throws a FileProblem for anything else.
  float parseNumber(std::string_view word);

  // Reads up to `maxCount` numbers; ignores the rest.
  template <std::size_t maxCount>
  LineNumbers<maxCount> parseNumbers() {
    LineNumbers<maxCount> numbers;
    for (std::string_view text = word(); !text.empty() && numbers.count < maxCount; text = word()) {
      const float value = parseNumber(text);
      numbers.isFinite &= value == value;
      numbers.values[numbers.count++] = value;
    }
    return numbers;
  }

  // Returns a message with the number of the line and this problem.
  std::string problem(const std::string& what) const;
  // Returns the message about the first number that was read as NaN.
  std::string problemOfNumber() const;
  // Throws a FileProblem with the message of `problem`.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string_view rest_, format_;
  std::size_t lineNumber_;
  std::string_view nonNumber_;
};

// Lines end with LF or CR LF, or with CR if the whole text has no LF. A backslash at the end joins
// the next line; a byte order mark at the start and comments after # are skipped.
class TextLines {
 public:
  TextLines(std::string_view text, std::string_view format)
      : rest_(text), format_(format), end_(text.find('\n') == text.npos ? '\r' : '\n') {}
  std::optional<TextLine> next();

 private:
  std::string_view rest_, format_;
  char end_;
  std::size_t lineNumber_ = 0;
  std::size_t joined_ = 0;
};

}  // namespace warpjet
