// Calls of noise functions.
#include "builder/builder.hpp"
#include "module/sentences.hpp"
#include "noise/table.hpp"

namespace warpjet {

// The operands are a point and a seed, and of a fractal lacunarity and gain.
int Builder::callNoise(const Noise& noise, bool isMethod) {
  const std::size_t before = graph_.size();
  const NoiseRow& kind = row(noise.kind);
  const std::string_view name = kind.name;
  const Site site{name, isMethod};
  const auto result = [&]() -> std::optional<Value> {
    for (std::size_t i = 0; i < operands_.size(); ++i) {
      const Kind wanted = i == 0 ? Kind::NumberOrVector : Kind::Number;
      if (!fits(wanted, operands_[i], i, site)) return std::nullopt;
    }
    const Value& point = operands_[0];
    const int dimensions = point.size();
    if (dimensions < kind.fewest || dimensions > kind.most)
      return refuse(name, {site.place(0), " must be ", kind.points, ", but is ",
                           shapeName(point.shape()), "."});
    Numbers arguments;
    for (const Value& operand : operands_) {
      for (int i = 0; i < operand.size(); ++i) arguments.push_back(operand[i]);
    }
    // A hash, so that neighbouring seeds give fields that are far from each other.
    Expression& seed = arguments[static_cast<std::size_t>(dimensions)];
    const NodeId zero = graph_.constant(0);
    seed = {&graph_, graph_.apply(ops::find("hash"), {zero, seed.id})};

    const Definition definition = definitionOf(noise, dimensions);
    // Derivatives of a function are by its point alone.
    const bool isPlain = !isFractal(noise.kind) || (graph_.isConstant(arguments.end()[-2].id) &&
                                                    graph_.isConstant(arguments.end()[-1].id));
    const Numbers values = isPlain
                               ? module_.library.call(definition, arguments)
                               : definition.body(module_.library, definition.settings, arguments);
    const int size = static_cast<int>(values.size());
    return fill(graph_, vectorOf(size), [&](int i) { return values[i]; });
  }();
  return finish(result, before, name);
}

}  // namespace warpjet
