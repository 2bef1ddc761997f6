// The lines of OBJ, MTL and STL files, and the words and numbers on them. The text ends where it
// ends: nothing needs a zero behind it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace warpjet {

template <std::size_t most>
struct LineNumbers {
  std::array<float, most> values{};
  std::size_t count = 0;
  bool isFinite = true;  // those that were read
};

class TextLine {
 public:
  // `format` is "obj", for example.
  TextLine(std::string_view text, std::string_view format, std::size_t number)
      : rest_(text), format_(format), number_(number) {}

  // The next one on the line; empty at its end.
  std::string_view word();

  // All that is left, without spaces around it, as names have it.
  std::string_view rest() const;

  // A number, or NaN for an infinite one and for what programs print in its place. Throws a
  // FileProblem for anything else.
  float number(std::string_view word);

  // As many as there are, up to `most`; what lies beyond is ignored.
  template <std::size_t most>
  LineNumbers<most> numbers() {
    LineNumbers<most> numbers;
    for (std::string_view text = word(); !text.empty() && numbers.count < most; text = word()) {
      const float value = number(text);
      numbers.isFinite &= value == value;
      numbers.values[numbers.count++] = value;
    }
    return numbers;
  }

  // A sentence: the line and what is wrong with it.
  std::string problem(const std::string& what) const;
  // The sentence about the first number that became NaN.
  std::string problemOfNumber() const;
  // Throws a FileProblem with that sentence.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string_view rest_, format_;
  std::size_t number_;
  std::string_view nonNumber_;
};

// Lines end in LF or CR LF, or in CR where the whole text has no LF. A backslash at the end joins
// the next line to it; a byte order mark at the start and what follows a # are left out.
class TextLines {
 public:
  TextLines(std::string_view text, std::string_view format)
      : rest_(text), format_(format), end_(text.find('\n') == text.npos ? '\r' : '\n') {}
  std::optional<TextLine> next();

  // The number of the last line that was read.
  std::size_t number() const { return number_; }

 private:
  std::string_view rest_, format_;
  char end_;
  std::size_t number_ = 0;
  std::size_t joined_ = 0;
};

}  // namespace warpjet
