// The table by number: what the other rooms see of it at run time.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <utility>

#include "ops/table.hpp"

namespace warpjet {

// An index into the table.
enum class Op : std::uint8_t {};

namespace ops {

// A row without its functions and what people read.
struct Info {
  std::string_view name;
  int arity;
  Signature signature;
  Spellings spellings;
  Helpers helpers;
};

inline constexpr auto infos = std::apply(
    [](const auto&... row) {
      return std::array{
          Info{row.title.name, row.arity, row.signature, row.spellings, row.helpers}...};
    },
    table);

constexpr const Info& info(Op op) { return infos[static_cast<std::size_t>(op)]; }

// Not constexpr, so that reaching it while compiling is an error.
void noSuchOperation();

// The operation of that name. A name that the table lacks does not compile.
consteval Op find(std::string_view name) {
  for (std::size_t i = 0; i < count; ++i) {
    if (infos[i].name == name) return static_cast<Op>(i);
  }
  noSuchOperation();
  return {};
}

// Applies a row's function to the first `Arity` of `arguments`, then to `extra`.
template <std::size_t Arity, class Function, class Scalar, class... Extra>
auto spread(const Function& function, const Scalar* arguments, const Extra&... extra) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return function(arguments[I]..., extra...);
  }
  (std::make_index_sequence<Arity>{});
}

// The value of an operation on numbers; conditions are 1 and 0.
double evaluate(Op op, const std::array<double, maxArity>& operands);

}  // namespace ops
}  // namespace warpjet
