// From recorded operations to plain words: those that the results need, in their order.
#include <algorithm>

#include "glsl/glsl.hpp"

namespace warpjet::glsl {

namespace {

struct Leaf {
  std::uint32_t number, part, layout;
};

Code codeOfConstant(Base base) {
  return base == Base::Int || base == Base::Uint ? Code::Whole : Code::Constant;
}

bool isOfImage(Code code) {
  return code == Code::Texel || code == Code::FetchedTexel || code == Code::ImageSize;
}

std::vector<bool> needed(const Recorder& recorder, std::span<const Id> results) {
  std::vector<bool> all(recorder.size());
  for (const Id result : results) all[index(result)] = true;
  for (std::size_t i = recorder.size(); i-- > 0;)
    if (all[i])
      for (const Id operand : recorder.operands(Id{static_cast<std::uint32_t>(i)}))
        all[index(operand)] = true;
  return all;
}

}  // namespace

Listing list(const Lowered& lowered, const Types& types) {
  const Recorder& recorder = lowered.recorder;
  const std::vector<bool> wanted = needed(recorder, lowered.results);
  Listing listing;
  std::vector<std::uint32_t> numbers(recorder.size());
  std::vector<bool> isNamed(lowered.externals.size());
  std::uint32_t next = 0;
  const auto say = [&](std::uint32_t word) { listing.words.push_back(word); };
  const auto leafOf = [&](const Operation& operation) {
    const auto packed = static_cast<std::uint32_t>(operation.value);
    return Leaf{packed >> 16, packed >> 8 & 255, packed & 255};
  };
  for (std::size_t i = 0; i < recorder.size(); ++i) {
    if (!wanted[i]) continue;
    const Id id{static_cast<std::uint32_t>(i)};
    const Operation& operation = recorder.at(id);
    if (operation.code == Code::SameBits) {
      numbers[i] = numbers[index(recorder.operands(id)[0])];
      continue;
    }
    // Names of images are no operations.
    if (operation.code == Code::Image) {
      numbers[i] = leafOf(operation).number;
      isNamed[numbers[i]] = true;
      continue;
    }
    numbers[i] = next++;
    say(static_cast<std::uint32_t>(operation.code));
    switch (operation.code) {
      case Code::Constant:
      case Code::Undefined:
        listing.words.back() = static_cast<std::uint32_t>(codeOfConstant(operation.base));
        say(static_cast<std::uint32_t>(listing.constants.size()));
        listing.constants.push_back(operation.value);
        break;
      case Code::Argument:
      case Code::Uniform: {
        const auto [number, part, layout] = leafOf(operation);
        say(number);
        say(part);
        say(layout);
        if (operation.code == Code::Uniform) isNamed[number] = true;
        break;
      }
      case Code::Component:
        say(numbers[index(recorder.operands(id)[0])]);
        say(leafOf(operation).part);
        say(leafOf(operation).layout);
        break;
      default:
        if (!isOfImage(operation.code)) say(operation.count);
        for (const Id operand : recorder.operands(id)) say(numbers[index(operand)]);
    }
  }
  for (const Id result : lowered.results) listing.results.push_back(numbers[index(result)]);
  for (std::size_t i = 0; i < lowered.externals.size(); ++i) {
    const auto& [name, type, isAttribute] = lowered.externals[i];
    listing.names += std::string(isNamed[i] ? "" : "-") + (isAttribute ? "in " : "uniform ") +
                     std::to_string(type.columns) + ' ' + std::to_string(type.rows) + ' ' +
                     types.name(type) + ' ' + name + '\n';
  }
  return listing;
}

}  // namespace warpjet::glsl
