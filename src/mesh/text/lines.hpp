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
  bool isFinite = true;  // of the numbers that were read
};

class TextLine {
 public:
  // `format` is "obj", for example.
  TextLine(std::string_view text, std::string_view format, std::size_t number)
      : rest_(text), format_(format), number_(number) {}

  // Returns the next word on the line; empty at its end.
  std::string_view word();

  // Returns the rest of the line without spaces around it: a name, which may contain spaces.
  std::string_view rest() const;

  // Parses a number; returns NaN for infinity and for the NaN spellings of other programs. Throws a
  // FileProblem for anything else.
  float number(std::string_view word);

  // Reads up to `maxCount` numbers; ignores the rest.
  template <std::size_t maxCount>
  LineNumbers<maxCount> numbers() {
    LineNumbers<maxCount> numbers;
    for (std::string_view text = word(); !text.empty() && numbers.count < maxCount; text = word()) {
      const float value = number(text);
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
  std::size_t number_;
  std::string_view nonNumber_;
};

// Lines end with LF or CR LF, or with CR if the whole text has no LF. A backslash at the end joins
// the next line; a byte order mark at the start and comments after # are skipped.
class TextLines {
 public:
  TextLines(std::string_view text, std::string_view format)
      : rest_(text), format_(format), end_(text.find('\n') == text.npos ? '\r' : '\n') {}
  std::optional<TextLine> next();

  // Returns the number of the last line that was read.
  std::size_t number() const { return number_; }

 private:
  std::string_view rest_, format_;
  char end_;
  std::size_t number_ = 0;
  std::size_t joined_ = 0;
};

}  // namespace warpjet
