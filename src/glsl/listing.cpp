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

class Lister {
 public:
  Lister(const Recorder& recorder, std::size_t externals, Listing& listing)
      : isNamed(externals), recorder_(recorder), listing_(listing), numbers_(recorder.size()) {}

  void list(std::span<const Id> results) {
    arrange(results);
    sayAll(0);
    for (const Id result : results) listing_.results.push_back(numbers_[index(result)]);
  }

  // By external, whether it is read.
  std::vector<bool> isNamed;

 private:
  // What is needed, by the innermost loop that it stands in, in order.
  void arrange(std::span<const Id> results) {
    std::vector<bool> isNeeded(recorder_.size());
    for (const Id result : results) isNeeded[index(result)] = true;
    for (std::size_t i = recorder_.size(); i-- > 0;)
      if (isNeeded[i])
        for (const Id operand : recorder_.operands(idOf(i))) isNeeded[index(operand)] = true;
    std::vector<std::uint32_t> loops(recorder_.size());
    bodies_.resize(recorder_.loopCount() + 1);
    locals_.resize(bodies_.size());
    for (std::size_t i = 0; i < recorder_.size(); ++i) {
      if (!isNeeded[i]) continue;
      const Operation& operation = recorder_.at(idOf(i));
      if (operation.code == Code::StepNumber || operation.code == Code::State) {
        loops[i] = leafOf(operation).number;
        locals_[loops[i]].push_back(idOf(i));
        continue;
      }
      if (operation.code == Code::Fold) {
        loops[i] = recorder_.loop(loopOf(operation)).outer;
      } else {
        for (const Id operand : recorder_.operands(idOf(i)))
          loops[i] = std::max(loops[i], loops[index(operand)]);
      }
      bodies_[loops[i]].push_back(idOf(i));
    }
  }

  void sayAll(std::uint32_t loop) {
    for (const Id id : bodies_[loop]) sayOne(id);
  }

  void sayOne(Id id) {
    const Operation& operation = recorder_.at(id);
    const auto operands = recorder_.operands(id);
    std::uint32_t& number = numbers_[index(id)];
    switch (operation.code) {
      case Code::SameBits:
        number = numbers_[index(operands[0])];
        return;
      // Names of images are no operations.
      case Code::Image:
        number = leafOf(operation).number;
        isNamed[number] = true;
        return;
      case Code::Fold:
        return sayFold(id);
      // It has its number with the others of its loop.
      case Code::Outcome:
        number = numbers_[index(operands[0])] + leafOf(operation).part;
        return;
      default:
        break;
    }
    number = next_++;
    say(operation.code);
    switch (operation.code) {
      case Code::Constant:
      case Code::Undefined:
        listing_.words.back() = static_cast<std::uint32_t>(codeOfConstant(operation.base));
        say(static_cast<std::uint32_t>(listing_.constants.size()));
        listing_.constants.push_back(operation.value);
        break;
      case Code::Argument:
      case Code::Uniform: {
        const auto [place, part, layout] = leafOf(operation);
        say(place);
        say(part);
        say(layout);
        if (operation.code == Code::Uniform) isNamed[place] = true;
        break;
      }
      case Code::Component:
        say(numbers_[index(operands[0])]);
        say(leafOf(operation).part);
        say(leafOf(operation).layout);
        break;
      default:
        if (!isOfImage(operation.code)) say(operation.count);
        sayNumbers(operands);
    }
  }

  void sayFold(Id id) {
    const std::uint32_t loop = loopOf(recorder_.at(id));
    const auto operands = recorder_.operands(id);
    const std::size_t count = operands.size() / 2;
    say(Code::Fold);
    say(recorder_.loop(loop).steps);
    say(static_cast<std::uint32_t>(count));
    sayNumbers(operands.first(count));
    // The number of the step, then the states.
    const std::uint32_t first = next_;
    next_ += static_cast<std::uint32_t>(count) + 1;
    for (const Id local : locals_[loop]) {
      const Operation& leaf = recorder_.at(local);
      const bool isState = leaf.code == Code::State;
      numbers_[index(local)] = first + (isState ? 1 + leafOf(leaf).part : 0);
    }
    sayAll(loop);
    say(Code::Next);
    sayNumbers(operands.subspan(count));
    numbers_[index(id)] = next_;
    next_ += static_cast<std::uint32_t>(count);
  }

  static Id idOf(std::size_t i) { return Id{static_cast<std::uint32_t>(i)}; }
  static std::uint32_t loopOf(const Operation& fold) {
    return static_cast<std::uint32_t>(fold.value);
  }
  static Leaf leafOf(const Operation& operation) {
    const auto packed = static_cast<std::uint32_t>(operation.value);
    return {packed >> 16, packed >> 8 & 255, packed & 255};
  }

  void say(std::uint32_t word) { listing_.words.push_back(word); }
  void say(Code code) { say(static_cast<std::uint32_t>(code)); }
  void sayNumbers(std::span<const Id> ids) {
    for (const Id id : ids) say(numbers_[index(id)]);
  }

  const Recorder& recorder_;
  Listing& listing_;
  std::vector<std::uint32_t> numbers_;  // by operation
  // By loop; 0 is what stands in none.
  std::vector<std::vector<Id>> bodies_, locals_;
  std::uint32_t next_ = 0;
};

}  // namespace

Listing list(const Lowered& lowered, const Types& types) {
  Listing listing;
  Lister lister(lowered.recorder, lowered.externals.size(), listing);
  lister.list(lowered.results);
  for (std::size_t i = 0; i < lowered.externals.size(); ++i) {
    const auto& [name, type, isAttribute] = lowered.externals[i];
    listing.names += std::string(lister.isNamed[i] ? "" : "-") +
                     (isAttribute ? "in " : "uniform ") + std::to_string(type.columns) + ' ' +
                     std::to_string(type.rows) + ' ' + types.name(type) + ' ' + name + '\n';
  }
  return listing;
}

}  // namespace warpjet::glsl
