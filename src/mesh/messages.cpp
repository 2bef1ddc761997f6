#include "mesh/messages.hpp"

namespace warpjet {

std::string groupDigits(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, 1, ',');
  return digits;
}

std::string quoteText(std::string_view text) {
  constexpr std::size_t maxLength = 60;
  std::string line = "\"";
  for (const char c : text.substr(0, maxLength)) line += c >= ' ' && c <= '~' ? c : '?';
  if (text.size() > maxLength) line += "...";
  return line + '"';
}

}  // namespace warpjet
