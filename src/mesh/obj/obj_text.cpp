#include "mesh/obj/obj_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "mesh/sentences.hpp"

namespace warpjet {

namespace {

// Within a line, as joined ones have them.
bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\\'; }

bool isDigit(char c) { return c >= '0' && c <= '9'; }

// Counted from 1 or, if negative, from the end; nothing beyond the list.
std::uint32_t placeOf(std::int64_t number, std::size_t count) {
  const auto length = static_cast<std::int64_t>(count);
  if (number == 0 || number > length || number < -length) return none;
  return static_cast<std::uint32_t>(number > 0 ? number - 1 : length + number);
}

double timesPowerOfTen(std::uint64_t digits, int exponent) {
  // Powers that a double holds exactly, so that one rounding is all; nearly every number of a file.
  constexpr std::array<double, 23> powers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                          1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                          1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  const auto number = static_cast<double>(digits);
  if (exponent >= 0 && exponent <= 22) return number * powers[exponent];
  if (exponent < 0 && exponent >= -22) return number / powers[-exponent];
  // In two steps, since the smallest doubles would be lost on the way.
  const int half = exponent / 2;
  return number * std::pow(10.0, half) * std::pow(10.0, exponent - half);
}

}  // namespace

std::optional<float> parsedFloat(std::string_view text) {
  std::size_t i = 0;
  const bool isNegative = text.starts_with('-');
  if (isNegative || text.starts_with('+')) ++i;

  constexpr std::uint64_t mostDigits = std::uint64_t{1000000000000000000};
  std::uint64_t digits = 0;
  int exponent = 0;
  bool hasDigits = false, isFraction = false;
  for (; i < text.size() && (isDigit(text[i]) || (text[i] == '.' && !isFraction)); ++i) {
    if (text[i] == '.') {
      isFraction = true;
      continue;
    }
    hasDigits = true;
    const bool fits = digits < mostDigits;
    if (fits) digits = digits * 10 + static_cast<std::uint64_t>(text[i] - '0');
    exponent += (fits ? 0 : 1) - (isFraction ? 1 : 0);
  }
  if (!hasDigits) return std::nullopt;

  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    const char* first = text.data() + i + 1;
    const char* const last = text.data() + text.size();
    if (first != last && *first == '+') ++first;
    int written = 0;
    const auto [end, error] = std::from_chars(first, last, written);
    if (error != std::errc() || end != last) return std::nullopt;
    exponent += std::clamp(written, -100000, 100000);
  } else if (i != text.size()) {
    return std::nullopt;
  }
  if (digits == 0) return isNegative ? -0.0f : 0.0f;  // and not 0 times infinity
  const double value = timesPowerOfTen(digits, exponent);
  return static_cast<float>(isNegative ? -value : value);
}

std::string_view ObjLine::word() {
  const auto start = std::find_if_not(rest_.begin(), rest_.end(), isSpace);
  const auto end = std::find_if(start, rest_.end(), isSpace);
  const std::string_view found = rest_.substr(start - rest_.begin(), end - start);
  rest_.remove_prefix(end - rest_.begin());
  return found;
}

void ObjLine::fail(const std::string& what) const {
  throw FileProblem("line " + grouped(number_) + " of the .obj " + what +
                    "; export the model again.");
}

float ObjLine::number(std::string_view text) const {
  const std::optional<float> number = parsedFloat(text);
  if (!number) fail("has " + quotedText(text) + " where a number belongs");
  if (!std::isfinite(*number)) fail("has the number " + quotedText(text) + ", which is too large");
  return *number;
}

std::int64_t ObjLine::cornerNumber(std::string_view text) const {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    fail("has " + quotedText(text) + " where a face's corner belongs");
  return number;
}

bool ObjLine::corners(const ObjCounts& counts, std::vector<ObjCorner>& corners) {
  corners.clear();
  bool hasAll = true;
  for (std::string_view text = word(); !text.empty(); text = word()) {
    std::array<std::string_view, 3> parts;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t length = std::min(text.find('/'), text.size());
      parts[i] = text.substr(0, length);
      text.remove_prefix(std::min(length + 1, text.size()));
    }
    const std::int64_t number = cornerNumber(parts[0]);
    ObjCorner corner{placeOf(number, counts.positions), none, none};
    if (corner.position == none)
      fail("speaks of position " + std::to_string(number) + ", but " +
           (counts.positions == 0 ? "none" : "only " + grouped(counts.positions)) +
           " came before it");
    const auto find = [&](std::string_view part, std::size_t count) {
      if (part.empty()) return none;
      const std::uint32_t place = placeOf(cornerNumber(part), count);
      hasAll &= place != none;
      return place;
    };
    corner.uv = find(parts[1], counts.uvs);
    corner.normal = find(parts[2], counts.normals);
    corners.push_back(corner);
  }
  return hasAll;
}

std::optional<ObjLine> ObjLines::next() {
  if (rest_.empty()) return std::nullopt;
  const std::size_t number = number_ += joined_ + 1;
  joined_ = 0;
  std::size_t end = rest_.find(end_);
  for (; end != rest_.npos; end = rest_.find(end_, end + 1)) {
    const std::string_view line = rest_.substr(0, end);
    const bool isJoined = line.ends_with('\\') || line.ends_with("\\\r");
    if (!isJoined) break;
    ++joined_;
  }
  std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
  return ObjLine(line.substr(0, line.find('#')), number);
}

}  // namespace warpjet
