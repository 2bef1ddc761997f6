#include "source/problems.hpp"

#include <algorithm>

namespace warpjet::source {

namespace {

constexpr std::size_t maxPieceLength = 40, maxLineLength = 100;

bool isControl(char c) { return static_cast<unsigned char>(c) < 32 || c == 127; }

// Replaces control characters, except tabs, so that the caret stays aligned.
std::string printable(std::string_view piece) {
  std::string text(piece);
  for (char& c : text)
    if (isControl(c) && c != '\t') c = '?';
  return text;
}

std::string_view lineOf(std::string_view source, std::uint32_t number) {
  std::size_t start = 0;
  for (std::uint32_t line = 1; line < number && start < source.size(); ++line) {
    const auto end = source.find('\n', start);
    start = end == source.npos ? source.size() : end + 1;
  }
  return source.substr(start, source.find('\n', start) - start);
}

// Returns true for a continuation byte of UTF-8.
bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

}  // namespace

Lines::Lines(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
    const char c = text[i] == '\r' ? '\n' : text[i];
    lines += c;
    if (c == '\n' && joined.ends_with('\\')) {
      joined.pop_back();
      joins.push_back(joined.size());
    } else {
      joined += c;
    }
  }
}

std::string quote(std::string_view piece) {
  std::string text = printable(piece.substr(0, maxPieceLength));
  while (!text.empty() && piece.size() > maxPieceLength && continues(piece[text.size()]))
    text.pop_back();
  return '"' + text + (piece.size() > maxPieceLength ? "…\"" : "\"");
}

std::string Problems::message(std::string_view source) const {
  const auto& [location, what] = *found_;
  std::string_view line = lineOf(source, location.line);
  std::size_t before = std::min<std::size_t>(location.column - 1, line.size());
  std::string dots;
  if (line.size() > maxLineLength) {
    std::size_t start = before > maxLineLength / 2 ? before - maxLineLength / 2 : 0;
    while (start < before && continues(line[start])) ++start;
    std::size_t end = std::min(line.size(), start + maxLineLength);
    while (end > before && end < line.size() && continues(line[end])) --end;
    if (start > 0) dots = "…";
    before -= start;
    line = line.substr(start, end - start);
  }
  std::string caret = dots.empty() ? "" : " ";
  for (std::size_t i = 0; i < before; ++i)
    if (!continues(line[i])) caret += line[i] == '\t' ? '\t' : ' ';
  return "line " + std::to_string(location.shown) + ", column " + std::to_string(location.column) +
         ": " + what + (what.ends_with('?') ? "\n  " : ".\n  ") + dots + printable(line) + "\n  " +
         caret + '^';
}

}  // namespace warpjet::source
