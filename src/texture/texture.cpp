#include "texture/texture.hpp"

#include <string>

namespace warpjet {

namespace {

constexpr int channels = 4, reach = 4;

// By filter and texel, its weight times the divisor as a polynomial of where the point lies between
// the middle two, from 0 to 1; the highest power first.
constexpr std::int8_t weights[4][reach][4] = {
    {{}, {0, 0, -1, 1}, {0, 0, 1, 0}, {}},
    {{-1, 2, -1, 0}, {3, -5, 0, 2}, {-3, 4, 1, 0}, {1, -1, 0, 0}},
    {{-1, 3, -3, 1}, {3, -6, 0, 4}, {-3, 3, 3, 1}, {1, 0, 0, 0}},
    {{}, {0, 0, 0, 1}, {}, {}}};
constexpr double divisors[] = {1, 2, 6, 1};

// Formulas in half as many bytes of wasm as the operators of Expression take.
struct Calculation {
  Graph& graph;

  NodeId operator()(Op op, NodeId x) const { return graph.apply(op, {x}); }
  NodeId operator()(Op op, NodeId x, NodeId y) const { return graph.apply(op, {x, y}); }
  NodeId operator()(Op op, NodeId x, double y) const { return (*this)(op, x, graph.constant(y)); }
};

constexpr Op add = ops::find("add"), sub = ops::find("sub"), mult = ops::find("mult");

// A whole number of any size as the number of a texel. The half keeps a quotient that a GPU rounds
// away from whole numbers.
NodeId wrapped(Calculation make, NodeId i, NodeId size, Wrap wrap) {
  constexpr Op least = ops::find("min");
  if (wrap == Wrap::Clamp) return make(least, make(ops::find("max"), i, 0.0), make(sub, size, 1.0));
  const NodeId period = make(mult, size, wrap == Wrap::Mirror ? 2.0 : 1.0);
  const NodeId times = make(ops::find("floor"), make(ops::find("div"), make(add, i, 0.5), period));
  const NodeId inside = make(sub, i, make(mult, period, times));
  if (wrap == Wrap::Repeat) return inside;
  return make(least, inside, make(sub, make(sub, period, 1.0), inside));
}

// Along one side of the image, the texels near a point, and how much of each there is.
struct Axis {
  NodeId texels[reach], shares[reach];

  Axis(Calculation make, NodeId x, NodeId size, std::uint32_t filter, Wrap wrap) {
    if (Filter(filter) == Filter::Nearest) x = make(add, x, 0.5);
    const NodeId first = make(ops::find("floor"), x), inside = make(ops::find("fract"), x);
    for (int i = 0; i < reach; ++i) {
      texels[i] = wrapped(make, make(add, first, i - 1.0), size, wrap);
      shares[i] = make.graph.constant(0);
      for (const double weight : weights[filter][i])
        shares[i] = make(add, make(mult, shares[i], inside), weight / divisors[filter]);
    }
  }
};

Sampling unpack(std::uint32_t settings) { return {Filter(settings & 3), Wrap(settings >> 2)}; }

Numbers body(Library& library, std::uint32_t settings, const Numbers& arguments) {
  const auto [filterKind, wrap] = unpack(settings);
  const auto filter = static_cast<std::uint32_t>(filterKind);
  Numbers place = arguments;
  const Calculation make{*place[0].graph};
  const Axis across(make, place[0].id, place[3].id, filter, wrap);
  const Axis down(make, place[1].id, place[4].id, filter, wrap);
  const Definition texel{.function = {texelName, 5, channels, 0}};
  const Expression zero{&make.graph, make.graph.constant(0)};
  Numbers values{zero, zero, zero, zero};
  const auto addTo = [&](Numbers& sums, NodeId share, const Numbers& x) {
    for (int i = 0; i < channels; ++i)
      sums[i].id = make(add, sums[i].id, make(mult, share, x[i].id));
  };
  for (int row = 0; row < reach; ++row) {
    place[1].id = down.texels[row];
    Numbers sums{zero, zero, zero, zero};
    for (int column = 0; column < reach; ++column) {
      place[0].id = across.texels[column];
      addTo(sums, across.shares[column], library.call(texel, place));
    }
    addTo(values, down.shares[row], sums);
  }
  return values;
}

}  // namespace

Definition definitionOf(const Sampling& sampling) {
  const auto filter = static_cast<std::uint32_t>(sampling.filter);
  const auto wrap = static_cast<std::uint32_t>(sampling.wrap);
  const std::string name =
      "warpjet" + capitalized(filterNames[filter]) + capitalized(wrapNames[wrap]);
  return {.function = {name, 5, channels, 2},
          .body = body,
          .settings = filter | wrap << 2,
          .parameters = Definition::imageParameters,
          .maker = samplingFrom};
}

Definition samplingFrom(std::uint32_t settings) { return definitionOf(unpack(settings)); }

}  // namespace warpjet
