#include "source/builtins.hpp"

#include "source/signatures.hpp"

namespace warpjet::source {

bool isBuiltIn(BuiltIns table, std::string_view name) {
  for (const BuiltIn& row : table)
    if (row.name == name) return true;
  return false;
}

std::optional<Found> findBuiltIn(BuiltIns table, std::string_view name,
                                 std::span<const Type> operands) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table[i].name != name) continue;
    if (const auto result = matchSignature(table[i].signature, operands))
      return Found{static_cast<int>(i), *result};
  }
  return std::nullopt;
}

bool isOut(const BuiltIn& row, std::size_t parameter) {
  return isOutParameter(row.signature, parameter);
}

bool readsImage(const BuiltIn& row) {
  using enum Way;
  return row.way == Texture || row.way == TextureProj || row.way == TextureSize ||
         row.way == TexelFetch;
}

bool hasOffset(const BuiltIn& row) {
  return row.signature.find('S') != row.signature.npos && row.name.ends_with("Offset");
}

}  // namespace warpjet::source
