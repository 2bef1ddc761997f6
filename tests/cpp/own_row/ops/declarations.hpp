// A copy of the declarations with three more rows.
#pragma once

#define declarations standardDeclarations
#include "../../../../src/ops/declarations.hpp"
#undef declarations

namespace warpjet::ops {

inline constexpr auto declarations = [] {
  constexpr std::size_t count = standardDeclarations.size();
  std::array<Declaration, count + 3> all{};
  for (std::size_t i = 0; i < count; ++i) all[i] = standardDeclarations[i];
  all[count] = unary("cbrt", floats, Increasing);
  all[count + 1] = binary("hypot", floats, Chained, OnMatrices, Commutative);
  all[count + 2] = binary("times", floats, Divides);
  return all;
}();

}  // namespace warpjet::ops
