// Prints the tables of operations as JSON, including the descriptions for the docs and the types.
// This program is only built natively, so that the wasm does not contain those descriptions.
#include "noise/table.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <iostream>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "builder/builder.hpp"
#include "builder/operations.hpp"
#include "emit/dialect.hpp"
#include "graph/pattern_text.hpp"
#include "graph/rotations.hpp"
#include "job.hpp"
#include "mesh/refine/subdivide.hpp"
#include "ops/documentation.hpp"
#include "texture/texture.hpp"

namespace warpjet {
namespace {

std::string quote(std::string_view characters) {
  std::string quoted = "\"";
  for (const char c : characters) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

std::string toBoolean(bool value) { return value ? "true" : "false"; }

std::string object(std::initializer_list<std::pair<std::string_view, std::string>> fields) {
  std::string joined;
  for (const auto& [name, value] : fields)
    joined += (joined.empty() ? "" : ", ") + quote(name) + ": " + value;
  return "{" + joined + "}";
}

template <class List, class Item>
std::string array(const List& items, Item item) {
  std::string joined;
  for (const auto& each : items) joined += (joined.empty() ? "" : ",\n") + item(each);
  return "[" + joined + "]";
}

std::string typeName(ops::Type type) {
  return quote(type == ops::Type::Bool ? "bool" : type == ops::Type::Int ? "int" : "float");
}

// Lists the languages that lack this operation: there it is lowered to others.
std::string missingIn(Op op) {
  std::vector<std::string_view> names;
  for (const Dialect* dialect : dialects()) {
    if (ops::spelling(op, dialect->language).isMissing()) names.push_back(dialect->name);
  }
  return array(names, quote);
}

std::string row(const ops::Title& title, Op op) {
  const ops::Declaration& info = ops::declaration(op);
  const std::span types(info.signature.operands.data(), static_cast<std::size_t>(info.arity));
  return object(
      {{"name", quote(title.name)},
       {"operands", quote(title.operands)},
       {"meaning", quote(title.meaning)},
       {"types", array(types, typeName)},
       {"result", typeName(info.signature.result)},
       {"missingIn", missingIn(op)},
       {"isChained", toBoolean(info.traits.has(ops::Trait::Chained))},
       {"takesMatrices", toBoolean(info.traits.has(ops::Trait::OnMatrices))},
       {"isHidden", toBoolean(detail::isHidden(info) || info.traits.has(ops::Trait::SourceOnly))}});
}

std::string rows() {
  std::uint8_t i = 0;
  return array(ops::documentation, [&](const ops::Title& title) { return row(title, Op{i++}); });
}

std::string identity(const patterns::Identity& each) {
  constexpr std::string_view precisions[] = {"bits", "value", "rounding"};
  const auto precision = static_cast<std::size_t>(each.keeps.precision);
  const std::string condition = each.hasCondition() ? patterns::text(each.when) : "";
  return object({{"operation", quote(ops::declaration(each.from.root().op()).name)},
                 {"from", quote(patterns::text(each.from))},
                 {"to", quote(patterns::text(each.to))},
                 {"when", quote(condition)},
                 {"precision", quote(precisions[precision])},
                 {"onlyNumbers", toBoolean(each.keeps.onlyNumbers)}});
}

std::string composition(const Composition& each) {
  return object({{"name", quote(each.title.name)},
                 {"operands", quote(each.title.operands)},
                 {"meaning", quote(each.title.meaning)},
                 {"kinds", quote(each.operands)},
                 {"result", quote(std::string{static_cast<char>(each.result)})},
                 {"isListed", toBoolean(each.isListed)}});
}

std::string alias(const detail::Alias& each) {
  return object({{"name", quote(each.name)}, {"original", quote(each.original)}});
}

std::string heading(const Heading& each) {
  return object({{"text", quote(each.text)}, {"first", quote(each.first)}});
}

std::string language(const Dialect* each) {
  return object({{"name", quote(each->name)}, {"source", quote(each->sourceKey)}});
}

std::string_view useName(NoiseUse use) {
  constexpr std::string_view names[] = {"base", "plain", "made", "fractal"};
  return names[static_cast<std::size_t>(use)];
}

std::string noise(const NoiseRow& each) {
  return object({{"name", quote(each.name)}, {"use", quote(useName(each.use))}});
}

template <class Element>
std::string_view kindOf(const std::vector<Element>&) {
  if constexpr (std::is_same_v<Element, float>) return "float";
  if constexpr (std::is_same_v<Element, std::uint8_t>) return "byte";
  return "index";
}

std::string meshArrays() {
  Job job;
  std::string joined;
  std::apply(
      [&](const auto&... each) {
        ((joined += (joined.empty() ? "" : ",\n") +
                    object({{"name", quote(each.name)}, {"kind", quote(kindOf(each.get(job)))}})),
         ...);
      },
      jobArrays);
  return "[" + joined + "]";
}

std::string warpResults() {
  std::vector<std::string_view> names(movedResults.begin(), movedResults.end());
  names.push_back(orientationResult);
  names.insert(names.end(), orientedResults.begin(), orientedResults.end());
  return array(names, quote);
}

std::string other(const Operation& each) {
  return object({{"name", quote(each.name)}, {"isConstructor", toBoolean(each.isConstructor())}});
}

}  // namespace
}  // namespace warpjet

int main() {
  using namespace warpjet;
  std::cout << object({{"rows", rows()},
                       {"identities", array(patterns::identities, identity)},
                       {"turns", array(patterns::turns, identity)},
                       {"compositions", array(compositions, composition)},
                       {"aliases", array(detail::aliases, alias)},
                       {"others", array(detail::others, other)},
                       {"headings", array(headings, heading)},
                       {"languages", array(dialects(), language)},
                       {"noises", array(noises, noise)},
                       {"filters", array(filterNames, quote)},
                       {"wraps", array(wrapNames, quote)},
                       {"maxSeed", std::to_string(maxSeed)},
                       {"maxOctaves", std::to_string(maxOctaves)},
                       {"failed", std::to_string(Builder::failed)},
                       {"needsPartials", std::to_string(Builder::needsPartials)},
                       {"warpOperands", array(warpOperands, quote)},
                       {"warpResults", warpResults()},
                       {"variantCount", std::to_string(orientedResults.size())},
                       {"meshArrays", meshArrays()},
                       {"triangleLimit", std::to_string(triangleLimit)},
                       {"defaultTriangles", std::to_string(defaultTriangles)}})
            << '\n';
}
