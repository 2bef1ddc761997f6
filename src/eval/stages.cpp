#include "eval/stages.hpp"

#include "ops/rows.hpp"

namespace warpjet {

namespace {

template <ops::Type type>
auto toOperand(Staged x) {
  if constexpr (type == ops::Type::Bool)
    return asMask(x);
  else
    return x;
}

Staged toLanes(Staged value) { return value; }
Staged toLanes(StagedMask value) { return asLanes(value); }

template <std::size_t Row>
constexpr Stage stageOfRow() {
  constexpr auto& signature = ops::declarations[Row].signature;
  if constexpr (signature.hasInt()) {
    return nullptr;
  } else {
    return ops::withIndices<ops::declarations[Row].arity>([](auto... k) -> Stage {
      constexpr const auto& row = std::get<Row>(ops::table);
      using Value = decltype(row.value);
      if constexpr (std::is_invocable_v<
                        Value, decltype(toOperand<ops::declarations[Row].signature.operands[k]>(
                                   Staged()))...>)
        return [](const Operands<Staged>& x) {
          return ops::withIndices<ops::declarations[Row].arity>([&](auto... i) {
            return toLanes(
                std::get<Row>(ops::table)
                    .value(toOperand<ops::declarations[Row].signature.operands[i]>(x[i])...));
          });
        };
      else
        return nullptr;
    });
  }
}

constexpr auto stages =
    ops::withIndices<ops::count>([](auto... row) { return std::array{stageOfRow<row>()...}; });

}  // namespace

Stage stageOf(Op op) { return stages[index(op)]; }

}  // namespace warpjet
