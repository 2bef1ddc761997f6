#include "source/nearest.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace warpjet::source {

namespace {

constexpr std::size_t maxLength = 40;  // longer names are not compared

// Returns the Damerau-Levenshtein distance, by three rows of the table.
std::size_t distance(std::string_view a, std::string_view b) {
  std::array<std::vector<std::size_t>, 3> rows;
  for (auto& row : rows) row.resize(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) rows[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    auto& row = rows[i % 3];
    const auto &above = rows[(i + 2) % 3], &twoAbove = rows[(i + 1) % 3];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], twoAbove[j - 2] + 1);
    }
  }
  return rows[a.size() % 3][b.size()];
}

}  // namespace

Nearest::Nearest(std::string_view name)
    : name_(name), limit_(std::max<std::size_t>(1, name.size() / 3) + 1) {}

void Nearest::offer(std::string_view name) {
  if (std::max(name.size(), name_.size()) > maxLength) return;
  const std::size_t far = distance(name_, name);
  if (far >= limit_ || far >= name_.size()) return;
  limit_ = far;
  found_ = name;
}

std::string Nearest::question() const {
  return found_.empty() ? std::string() : "; did you mean " + std::string(found_) + '?';
}

}  // namespace warpjet::source
