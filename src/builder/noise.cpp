// Calls of noise functions.
#include "builder/builder.hpp"
#include "module/messages.hpp"
#include "noise/table.hpp"

namespace warpjet {

// The operands are a point and a seed; for fractal noise, also lacunarity and gain.
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
    if (dimensions < kind.minDimensions || dimensions > kind.maxDimensions)
      return reject(name, {"expected ", kind.points, " as ", site.describeOperand(0), ", got ",
                           shapeName(point.shape()), "."});
    Numbers arguments;
    for (const Value& operand : operands_) {
      for (int i = 0; i < operand.size(); ++i) arguments.push_back(operand[i]);
    }
    // Seeds are hashed, so that neighboring seeds give unrelated fields.
    Expression& seed = arguments[static_cast<std::size_t>(dimensions)];
    const NodeId zero = graph_.constant(0);
    seed = {&graph_, graph_.apply(ops::find("hash"), {zero, seed.id})};

    const Definition definition = definitionOf(noise, dimensions);
    // Functions are differentiated only with respect to the point.
    const bool isPlain = !isFractal(noise.kind) || (graph_.isConstant(arguments.end()[-2].id) &&
                                                    graph_.isConstant(arguments.end()[-1].id));
    const Numbers values = isPlain
                               ? module_.library.call(definition, arguments)
                               : definition.body(module_.library, definition.settings, arguments);
    const int size = static_cast<int>(values.size());
    return fill(graph_, vectorOf(size), [&](int i) { return values[i]; });
  }();
  return addResult(result, before, name);
}

}  // namespace warpjet
