// Spellings and helper functions of the rows of the table.
#include "ops/rows.hpp"

namespace warpjet::ops {

namespace {

constexpr auto spellings =
    std::apply([](const auto&... row) { return std::array{row.spellings...}; }, table);

constexpr auto allHelpers =
    std::apply([](const auto&... row) { return std::array{row.helpers...}; }, table);

}  // namespace

const Spelling& spelling(Op op, Language language) {
  return spellings[static_cast<std::size_t>(op)].in(language);
}

std::string_view helpers(Op op, Language language) {
  return allHelpers[static_cast<std::size_t>(op)][static_cast<std::size_t>(language)];
}

}  // namespace warpjet::ops
