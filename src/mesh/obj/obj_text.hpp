// The lines of an OBJ file and the numbers and corners on them. The text ends where it ends:
// nothing needs a zero behind it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "graph/none.hpp"

namespace warpjet {

// Of a face: places in the lists of positions, uvs and normals, counted from 0, or `none`.
struct ObjCorner {
  std::uint32_t position, uv, normal;

  bool operator==(const ObjCorner&) const = default;
};

// How long the lists are so far.
struct ObjCounts {
  std::size_t positions, uvs, normals;
};

template <std::size_t most>
struct ObjNumbers {
  std::array<float, most> values{};
  std::size_t count = 0;
};

class ObjLine {
 public:
  ObjLine(std::string_view text, std::size_t number) : rest_(text), number_(number) {}

  // The next one on the line; empty at its end.
  std::string_view word();

  // As many as there are, up to `most`; what lies beyond is ignored.
  template <std::size_t most>
  ObjNumbers<most> numbers() {
    ObjNumbers<most> numbers;
    for (std::string_view text = word(); !text.empty() && numbers.count < most; text = word())
      numbers.values[numbers.count++] = number(text);
    return numbers;
  }

  // The corners of a face: v, v/vt, v//vn or v/vt/vn, counted from 1 or, if negative, from the end.
  // Answers whether all the uvs and normals that they name are there; a corner goes without those
  // that are not.
  bool corners(const ObjCounts& counts, std::vector<ObjCorner>& corners);

  // Throws a FileProblem: the line and what is wrong with it.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  float number(std::string_view text) const;
  std::int64_t cornerNumber(std::string_view text) const;

  std::string_view rest_;
  std::size_t number_;
};

// A backslash at the end of a line joins the next one to it. Lines end in LF or CR LF, or in CR
// where the whole text has no LF.
class ObjLines {
 public:
  explicit ObjLines(std::string_view text)
      : rest_(text), end_(text.find('\n') == text.npos ? '\r' : '\n') {}
  std::optional<ObjLine> next();

 private:
  std::string_view rest_;
  char end_;
  std::size_t number_ = 0;
  std::size_t joined_ = 0;
};

// A decimal number such as -1.5e3, or nothing. Right to the last bit or next to it: up to 19 digits
// are kept, and powers of ten are multiplied in double.
std::optional<float> parsedFloat(std::string_view text);

}  // namespace warpjet
