// Prints the tables of operations as JSON, including the descriptions for the docs and the types.
// This program is only built natively, so that the wasm does not contain those descriptions.
#include "noise/table.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <tuple>
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

using Json = nlohmann::json;

template <class List, class Write>
Json array(const List& items, Write write) {
  Json list = Json::array();
  for (const auto& each : items) list.push_back(write(each));
  return list;
}

// Lists the languages that lack this operation. In these, it is lowered to other operations.
Json missingIn(Op op) {
  std::vector<std::string_view> names;
  for (const Dialect* dialect : dialects()) {
    if (ops::spelling(op, dialect->language).isMissing()) names.push_back(dialect->name);
  }
  return names;
}

// Describes an operation with the same keys as `composition`. `kinds` has a letter per operand, see
// Kind. atan2 is the form of `atan` with two operands.
Json row(const ops::Title& title, Op op) {
  const ops::Declaration& info = ops::declaration(op);
  const bool isAtan2 = title.name == "atan2";
  const bool isHidden = detail::isHidden(info) || info.traits.has(ops::Trait::SourceOnly);
  constexpr char kind = static_cast<char>(Kind::NumberOrVector);
  return {{"name", isAtan2 ? "atan" : title.name},
          {"operands", title.operands},
          {"meaning", title.meaning},
          {"kinds", std::string(static_cast<std::size_t>(info.arity), kind)},
          {"result", std::string{kind}},
          {"isListed", !isHidden || isAtan2},
          {"isChained", info.traits.has(ops::Trait::Chained)},
          {"takesMatrices", info.traits.has(ops::Trait::OnMatrices)},
          {"missingIn", missingIn(op)}};
}

Json rows() {
  std::uint8_t i = 0;
  return array(ops::documentation, [&](const ops::Title& title) { return row(title, Op{i++}); });
}

Json identity(const patterns::Identity& each) {
  constexpr std::string_view precisions[] = {"bits", "value", "rounding"};
  const auto precision = static_cast<std::size_t>(each.keeps.precision);
  const std::string condition = each.hasCondition() ? patterns::text(each.when) : "";
  return {{"operation", ops::declaration(each.from.root().op()).name},
          {"from", patterns::text(each.from)},
          {"to", patterns::text(each.to)},
          {"when", condition},
          {"precision", precisions[precision]},
          {"onlyNumbers", each.keeps.onlyNumbers}};
}

Json composition(const Composition& each) {
  return {{"name", each.title.name},
          {"operands", each.title.operands},
          {"meaning", each.title.meaning},
          {"kinds", each.operands},
          {"result", std::string{static_cast<char>(each.result)}},
          {"isListed", each.isListed},
          {"isChained", false},
          {"takesMatrices", false},
          {"missingIn", Json::array()}};
}

Json alias(const detail::Alias& each) { return {{"name", each.name}, {"original", each.original}}; }

Json heading(const Heading& each) { return {{"text", each.text}, {"first", each.first}}; }

Json language(const Dialect* each) { return {{"name", each->name}, {"source", each->sourceKey}}; }

std::string_view useName(NoiseUse use) {
  constexpr std::string_view names[] = {"base", "plain", "made", "fractal"};
  return names[static_cast<std::size_t>(use)];
}

Json noise(const NoiseRow& each) { return {{"name", each.name}, {"use", useName(each.use)}}; }

template <class Element>
std::string_view kindOf(const std::vector<Element>&) {
  if constexpr (std::is_same_v<Element, float>) return "float";
  if constexpr (std::is_same_v<Element, std::uint8_t>) return "byte";
  return "index";
}

Json meshArrays() {
  Job job;
  Json list;
  std::apply(
      [&](const auto&... each) {
        (list.push_back({{"name", each.name}, {"kind", kindOf(each.get(job))}}), ...);
      },
      jobArrays);
  return list;
}

Json warpResults() {
  std::vector<std::string_view> names(movedResults.begin(), movedResults.end());
  names.push_back(orientationResult);
  names.insert(names.end(), orientedResults.begin(), orientedResults.end());
  return names;
}

std::string_view name(const Operation& each) { return each.name; }

}  // namespace
}  // namespace warpjet

int main() {
  using namespace warpjet;
  std::cout << Json{{"rows", rows()},
                    {"identities", array(patterns::identities, identity)},
                    {"turns", array(patterns::turns, identity)},
                    {"compositions", array(compositions, composition)},
                    {"aliases", array(detail::aliases, alias)},
                    {"others", array(detail::vectorOperations, name)},
                    {"headings", array(headings, heading)},
                    {"languages", array(dialects(), language)},
                    {"noises", array(noises, noise)},
                    {"filters", filterNames},
                    {"wraps", wrapNames},
                    {"maxSeed", maxSeed},
                    {"maxOctaves", maxOctaves},
                    {"failed", Builder::failed},
                    {"needsPartials", Builder::needsPartials},
                    {"warpOperands", warpOperands},
                    {"warpResults", warpResults()},
                    {"variantCount", orientedResults.size()},
                    {"meshArrays", meshArrays()},
                    {"triangleLimit", triangleLimit},
                    {"defaultTriangles", defaultTriangles}}
            << '\n';
}
