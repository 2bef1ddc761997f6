// The table by number: what the other rooms see of it at run time.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "ops/interval.hpp"
#include "ops/table.hpp"

namespace warpjet {

// An index into the table.
enum class Op : std::uint8_t {};

namespace ops {

inline constexpr std::size_t count = std::tuple_size_v<decltype(table)>;

// A row without its functions and what people read.
struct Info {
  std::string_view name;
  int arity;
  Signature signature;
  Spellings spellings;
  Helpers helpers;
  Traits traits;
  // Without partials, so that it changes only in jumps.
  bool isStep;
};

inline constexpr auto infos = std::apply(
    [](const auto&... row) {
      return std::array{Info{row.title.name, row.arity, row.signature, row.spellings, row.helpers,
                             row.traits, std::tuple_size_v<decltype(row.partials)> == 0}...};
    },
    table);

constexpr const Info& info(Op op) { return infos[static_cast<std::size_t>(op)]; }
constexpr bool has(Op op, Trait trait) { return info(op).traits.has(trait); }
// Of the second and the third operand, by the first.
constexpr bool isChoice(Op op) {
  return info(op).arity == 3 && info(op).signature.operands[0] == Type::Bool;
}

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

// Calls `function` with 0, 1, … as so many arguments, each a constant that a template can take.
template <std::size_t Count, class Function>
constexpr auto numbered(const Function& function) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return function(std::integral_constant<std::size_t, I>{}...);
  }
  (std::make_index_sequence<Count>{});
}

// Applies a row's function to the first `Arity` of `arguments`, then to `extra`.
template <std::size_t Arity, class Function, class Scalar, class... Extra>
auto spread(const Function& function, const Scalar* arguments, const Extra&... extra) {
  return numbered<Arity>([&](auto... i) { return function(arguments[i]..., extra...); });
}

// Whether a row's partial by its operand number K gives the product with that operand's derivative.
template <std::size_t Row, std::size_t K>
inline constexpr bool takesDerivative = numbered<infos[Row].arity>([](auto... i) {
  using Partial = std::tuple_element_t<K, std::decay_t<decltype(std::get<Row>(table).partials)>>;
  constexpr auto types = infos[Row].signature.operands;
  return !std::is_invocable_v<Partial, std::conditional_t<types[i] == Type::Bool, bool, double>...,
                              double>;
});

// That product, where `d` is the derivative of the operand.
template <std::size_t Row, std::size_t K, class Scalar>
auto term(const Scalar* operands, const Scalar& value, const Scalar& d) {
  constexpr auto partial = std::get<K>(std::get<Row>(table).partials);
  if constexpr (takesDerivative<Row, K>) {
    return spread<infos[Row].arity>(partial, operands, value, d);
  } else {
    return spread<infos[Row].arity>(partial, operands, value) * d;
  }
}

// The value of an operation on numbers; conditions are 1 and 0.
double valueOf(Op op, const Operands<double>& operands);

// What it can be where the operands are within theirs.
Interval rangeOf(Op op, const Operands<Interval>& operands);

}  // namespace ops
}  // namespace warpjet
