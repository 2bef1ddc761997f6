#include "module/messages.hpp"

#include <algorithm>

namespace warpjet {

std::string shapeName(Shape shape) {
  const std::string rows = std::to_string(shape.rows);
  if (shape.isNumber()) return "a single number";
  if (shape == imageShape) return "an image";
  if (shape.isVector()) return "a vec" + rows;
  if (shape.isSquare()) return "a mat" + rows;
  return "a matrix of " + std::to_string(shape.columns) + " columns and " + rows + " rows";
}

std::string argumentCount(int count) {
  if (count == 1) return "1 argument";
  return (count == 0 ? "no" : std::to_string(count)) + " arguments";
}

std::string quoteShort(std::string_view text) {
  std::string line(text.substr(0, 60));
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  return quote(line);
}

}  // namespace warpjet
