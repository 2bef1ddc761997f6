// The rows of the table as template arguments, for code that generates a function per formula.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

#include "ops/ops.hpp"
#include "ops/table.hpp"

namespace warpjet::ops {

struct NameOfRow {
  std::string_view name;
};

static_assert(haveDeclaredNames(std::apply(
                  [](const auto&... row) { return std::array{NameOfRow{row.name}...}; }, table)),
              "table.hpp and declarations.hpp differ");

// Calls `function` with the arguments 0, 1, … Count - 1, each usable as a template argument.
template <std::size_t Count, class Function>
constexpr auto withIndices(const Function& function) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return function(std::integral_constant<std::size_t, I>{}...);
  }
  (std::make_index_sequence<Count>{});
}

// Applies a row's function to the first `Arity` of `arguments`, then to `extra`.
template <std::size_t Arity, class Function, class Scalar, class... Extra>
auto applyTo(const Function& function, const Scalar* arguments, const Extra&... extra) {
  return withIndices<Arity>([&](auto... i) { return function(arguments[i]..., extra...); });
}

// True if the row's partial for operand K returns the product with that operand's derivative.
template <std::size_t Row, std::size_t K>
inline constexpr bool takesDerivative = withIndices<declarations[Row].arity>([](auto... i) {
  using Partial = std::tuple_element_t<K, std::decay_t<decltype(std::get<Row>(table).partials)>>;
  constexpr auto types = declarations[Row].signature.operands;
  return !std::is_invocable_v<Partial, std::conditional_t<types[i] == Type::Bool, bool, double>...,
                              double>;
});

// Returns the product of the partial and `d`, the derivative of the operand.
template <std::size_t Row, std::size_t K, class Scalar>
auto term(const Scalar* operands, const Scalar& value, const Scalar& d) {
  constexpr auto partial = std::get<K>(std::get<Row>(table).partials);
  if constexpr (takesDerivative<Row, K>) {
    return applyTo<declarations[Row].arity>(partial, operands, value, d);
  } else {
    return applyTo<declarations[Row].arity>(partial, operands, value) * d;
  }
}

}  // namespace warpjet::ops
