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

std::string text(std::string_view characters) {
  std::string quoted = "\"";
  for (const char c : characters) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

std::string truth(bool value) { return value ? "true" : "false"; }

std::string object(std::initializer_list<std::pair<std::string_view, std::string>> fields) {
  std::string joined;
  for (const auto& [name, value] : fields)
    joined += (joined.empty() ? "" : ", ") + text(name) + ": " + value;
  return "{" + joined + "}";
}

template <class List, class Item>
std::string array(const List& items, Item item) {
  std::string joined;
  for (const auto& each : items) joined += (joined.empty() ? "" : ",\n") + item(each);
  return "[" + joined + "]";
}

std::string typeName(ops::Type type) {
  return text(type == ops::Type::Bool ? "bool" : type == ops::Type::Int ? "int" : "float");
}

// The languages that lack a row, and so have it lowered to others.
std::string missingIn(Op op) {
  std::vector<std::string_view> names;
  for (const Dialect* dialect : dialects()) {
    if (ops::spelling(op, dialect->language).isMissing()) names.push_back(dialect->name);
  }
  return array(names, text);
}

std::string row(const ops::Title& title, Op op) {
  const ops::Declaration& info = ops::declaration(op);
  const std::span types(info.signature.operands.data(), static_cast<std::size_t>(info.arity));
  return object(
      {{"name", text(title.name)},
       {"operands", text(title.operands)},
       {"meaning", text(title.meaning)},
       {"types", array(types, typeName)},
       {"result", typeName(info.signature.result)},
       {"missingIn", missingIn(op)},
       {"isChained", truth(info.traits.has(ops::Trait::Chained))},
       {"takesMatrices", truth(info.traits.has(ops::Trait::OnMatrices))},
       {"isHidden", truth(detail::isHidden(info) || info.traits.has(ops::Trait::SourceOnly))}});
}

std::string rows() {
  std::uint8_t i = 0;
  return array(ops::documentation, [&](const ops::Title& title) { return row(title, Op{i++}); });
}

std::string identity(const patterns::Identity& each) {
  constexpr std::string_view precisions[] = {"bits", "value", "rounding"};
  const auto precision = static_cast<std::size_t>(each.keeps.precision);
  const std::string condition = each.hasCondition() ? patterns::text(each.when) : "";
  return object({{"operation", text(ops::declaration(each.from.root().op()).name)},
                 {"from", text(patterns::text(each.from))},
                 {"to", text(patterns::text(each.to))},
                 {"when", text(condition)},
                 {"precision", text(precisions[precision])},
                 {"onlyNumbers", truth(each.keeps.onlyNumbers)}});
}

std::string composition(const Composition& each) {
  return object({{"name", text(each.title.name)},
                 {"operands", text(each.title.operands)},
                 {"meaning", text(each.title.meaning)},
                 {"kinds", text(each.operands)},
                 {"result", text(std::string{static_cast<char>(each.result)})},
                 {"isListed", truth(each.isListed)}});
}

std::string alias(const detail::Alias& each) {
  return object({{"name", text(each.name)}, {"of", text(each.original)}});
}

std::string heading(const Heading& each) {
  return object({{"text", text(each.text)}, {"first", text(each.first)}});
}

std::string language(const Dialect* each) {
  return object({{"name", text(each->name)}, {"source", text(each->sourceKey)}});
}

std::string_view useName(NoiseUse use) {
  constexpr std::string_view names[] = {"base", "plain", "made", "fractal"};
  return names[static_cast<std::size_t>(use)];
}

std::string noise(const NoiseRow& each) {
  return object({{"name", text(each.name)}, {"use", text(useName(each.use))}});
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
                    object({{"name", text(each.name)}, {"kind", text(kindOf(each.get(job)))}})),
         ...);
      },
      jobArrays);
  return "[" + joined + "]";
}

std::string warpResults() {
  std::vector<std::string_view> names(movedResults.begin(), movedResults.end());
  names.push_back(orientationResult);
  names.insert(names.end(), orientedResults.begin(), orientedResults.end());
  return array(names, text);
}

std::string other(const Operation& each) {
  return object({{"name", text(each.name)}, {"isConstructor", truth(each.isConstructor())}});
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
                       {"filters", array(filterNames, text)},
                       {"wraps", array(wrapNames, text)},
                       {"maxSeed", std::to_string(maxSeed)},
                       {"maxOctaves", std::to_string(maxOctaves)},
                       {"failed", std::to_string(Builder::failed)},
                       {"needsPartials", std::to_string(Builder::needsPartials)},
                       {"warpOperands", array(warpOperands, text)},
                       {"warpResults", warpResults()},
                       {"variantCount", std::to_string(orientedResults.size())},
                       {"meshArrays", meshArrays()},
                       {"triangleLimit", std::to_string(triangleLimit)},
                       {"defaultTriangles", std::to_string(defaultTriangles)}})
            << '\n';
}
