#include "texture/texture.hpp"

#include <string>

namespace warpjet {

namespace {

constexpr int channels = 4, reach = 4;

// The weights by filter and texel, times the divisor, as polynomials of the position between the
// two middle texels, from 0 to 1; the highest power first.
constexpr std::int8_t weights[5][reach][4] = {
    {{}, {0, 0, -1, 1}, {0, 0, 1, 0}, {}},
    {{-1, 2, -1, 0}, {3, -5, 0, 2}, {-3, 4, 1, 0}, {1, -1, 0, 0}},
    {{-1, 3, -3, 1}, {3, -6, 0, 4}, {-3, 3, 3, 1}, {1, 0, 0, 0}},
    {{}, {0, 0, 0, 1}, {}, {}},
    {{}, {0, 0, -1, 1}, {0, 0, 1, 0}, {}}};
constexpr double divisors[] = {1, 2, 6, 1, 1};

// Builds formulas, in half as many bytes of wasm as the operators of Expression take.
struct Calculation {
  Graph& graph;

  NodeId operator()(Op op, NodeId x) const { return graph.apply(op, {x}); }
  NodeId operator()(Op op, NodeId x, NodeId y) const { return graph.apply(op, {x, y}); }
  NodeId operator()(Op op, NodeId x, double y) const { return (*this)(op, x, graph.constant(y)); }
};

constexpr Op add = ops::find("add"), sub = ops::find("sub"), mult = ops::find("mult");
constexpr Op minOp = ops::find("min"), maxOp = ops::find("max");

NodeId clampIndex(Calculation make, NodeId i, NodeId size) {
  return make(minOp, make(maxOp, i, 0.0), make(sub, size, 1.0));
}

// Returns i modulo the period. Adding a half guards against quotients that a GPU rounds to below an
// integer.
NodeId repeatIndex(Calculation make, NodeId i, NodeId period) {
  const NodeId times = make(ops::find("floor"), make(ops::find("div"), make(add, i, 0.5), period));
  return make(sub, i, make(mult, period, times));
}

// Reflects an index from 0 to 2 size - 1: the second half runs backwards, the first is unchanged.
NodeId mirrorIndex(Calculation make, NodeId inside, NodeId size) {
  return make(minOp, inside, make(sub, make(sub, make(mult, size, 2.0), 1.0), inside));
}

// Wraps by the host's `mode`: 0 clamps, 1 repeats and 2 mirrors.
NodeId wrapByHost(Calculation make, NodeId i, NodeId size, NodeId mode) {
  const NodeId clamps = make(maxOp, make(sub, make.graph.constant(1), mode), 0.0);
  const NodeId clamped = make(add, i, make(mult, clamps, make(sub, clampIndex(make, i, size), i)));
  const NodeId period = make(mult, size, make(maxOp, mode, 1.0));
  return mirrorIndex(make, repeatIndex(make, clamped, period), size);
}

// Wraps an integer of any size to the index of a texel.
NodeId wrapIndex(Calculation make, NodeId i, NodeId size, Wrap wrap, NodeId mode) {
  switch (wrap) {
    case Wrap::Clamp:
      return clampIndex(make, i, size);
    case Wrap::Repeat:
      return repeatIndex(make, i, size);
    case Wrap::Mirror:
      return mirrorIndex(make, repeatIndex(make, i, make(mult, size, 2.0)), size);
    case Wrap::Host:
      return wrapByHost(make, i, size, mode);
    case Wrap::Sampler:
      break;
  }
  return i;
}

struct HostSettings {
  NodeId wrapX{}, wrapY{}, isNearest{};
};

// The texels near a point along one axis of the image, and the weight of each.
struct Axis {
  NodeId texels[reach], texelWeights[reach];

  // `x` is the position in texels along the axis.
  Axis(Calculation make, NodeId x, NodeId size, Sampling sampling, NodeId mode, NodeId isNearest) {
    const auto [filterKind, wrap] = sampling;
    const auto filter = static_cast<std::size_t>(filterKind);
    constexpr Op floor = ops::find("floor");
    if (filterKind == Filter::Nearest) x = make(add, x, 0.5);
    const NodeId first = make(floor, x);
    NodeId inside = make(ops::find("fract"), x);
    if (filterKind == Filter::Host) {
      const NodeId nearest = make(floor, make(add, inside, 0.5));
      inside = make(add, inside, make(mult, isNearest, make(sub, nearest, inside)));
    }
    for (int i = 0; i < reach; ++i) {
      texels[i] = wrapIndex(make, make(add, first, i - 1.0), size, wrap, mode);
      texelWeights[i] = make.graph.constant(0);
      for (const double coefficient : weights[filter][i])
        texelWeights[i] =
            make(add, make(mult, texelWeights[i], inside), coefficient / divisors[filter]);
    }
  }
};

Sampling unpack(std::uint32_t settings) { return {Filter(settings & 7), Wrap(settings >> 3)}; }

Numbers body(Library& library, std::uint32_t settings, const Numbers& arguments) {
  const Sampling sampling = unpack(settings);
  const Calculation make{*arguments[0].graph};
  const HostSettings host = sampling.isByHost()
                                ? HostSettings{arguments[5].id, arguments[6].id, arguments[7].id}
                                : HostSettings{};
  const Axis across(make, arguments[0].id, arguments[3].id, sampling, host.wrapX, host.isNearest);
  const Axis down(make, arguments[1].id, arguments[4].id, sampling, host.wrapY, host.isNearest);
  Numbers texelArguments{arguments[0], arguments[1], arguments[2], arguments[3], arguments[4]};
  const char* name = sampling.wrap == Wrap::Sampler ? sampledTexelName : texelName;
  const Definition texel{.function = {name, 5, channels, 0}};
  const Expression zero{&make.graph, make.graph.constant(0)};
  Numbers values{zero, zero, zero, zero};
  const auto addTo = [&](Numbers& sums, NodeId weight, const Numbers& x) {
    for (int i = 0; i < channels; ++i)
      sums[i].id = make(add, sums[i].id, make(mult, weight, x[i].id));
  };
  for (int row = 0; row < reach; ++row) {
    texelArguments[1].id = down.texels[row];
    Numbers sums{zero, zero, zero, zero};
    for (int column = 0; column < reach; ++column) {
      texelArguments[0].id = across.texels[column];
      addTo(sums, across.texelWeights[column], library.call(texel, texelArguments));
    }
    addTo(values, down.texelWeights[row], sums);
  }
  return values;
}

}  // namespace

Definition definitionOf(const Sampling& sampling) {
  const auto filter = static_cast<std::uint32_t>(sampling.filter);
  const auto wrap = static_cast<std::uint32_t>(sampling.wrap);
  const std::string name =
      "warpjet" + capitalize(filterNames[filter]) + capitalize(wrapNames[wrap]);
  return {.function = {name, sampling.isByHost() ? 8 : 5, channels, 2},
          .body = body,
          .settings = filter | wrap << 3,
          .parameters = Definition::imageParameters,
          .maker = samplingFrom};
}

Definition samplingFrom(std::uint32_t settings) { return definitionOf(unpack(settings)); }

}  // namespace warpjet
