#include "diff/partials.hpp"

#include <utility>

namespace warpjet {

namespace {

template <std::size_t Row, std::size_t K>
NodeId partial(Graph& graph, const Arguments& x, Expression v) {
  constexpr auto function = std::get<K>(std::get<Row>(ops::table).partials);
  return toNode(graph, ops::spread<ops::infos[Row].arity>(function, x.data(), v));
}

template <std::size_t Row>
constexpr Partials partialsOfRow() {
  using Functions = decltype(std::get<Row>(ops::table).partials);
  return []<std::size_t... K>(std::index_sequence<K...>) { return Partials{&partial<Row, K>...}; }
  (std::make_index_sequence<std::tuple_size_v<Functions>>{});
}

constexpr auto partials = []<std::size_t... Row>(std::index_sequence<Row...>) {
  return std::array{partialsOfRow<Row>()...};
}
(std::make_index_sequence<ops::count>{});

}  // namespace

const Partials& partialsOf(Op op) { return partials[index(op)]; }

}  // namespace warpjet
