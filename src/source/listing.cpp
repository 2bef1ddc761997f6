// Converts recorded operations to plain words: those that the results need, in order.
#include <algorithm>

#include "source/source.hpp"

namespace warpjet::source {

namespace {

struct Leaf {
  std::uint32_t number, part, layout;
};

Code codeOfConstant(Base base) {
  return base == Base::Int || base == Base::Uint ? Code::Whole : Code::Constant;
}

// Replaces infinities by the largest floats, since some languages have no literal for infinity.
double finite(double value) {
  constexpr double largest = 3.4028234663852886e38;
  return std::clamp(value, -largest, largest);
}

bool isOfImage(Code code) {
  return code == Code::Texel || code == Code::FetchedTexel || code == Code::ImageSize;
}

class Lister {
 public:
  Lister(const Lowered& lowered, Listing& listing)
      : isNamed(lowered.externals.size()),
        recorder_(lowered.recorder),
        routines_(lowered.routines),
        listing_(listing),
        uses_(routines_.size()),
        numbers_(recorder_.size()),
        loops_(recorder_.size()),
        bodies_(recorder_.loopCount() + 1),
        locals_(bodies_.size()) {}

  void list(std::span<const Id> results) {
    const std::vector<Id> needed = recorder_.neededBy(results);
    findUses(needed);
    for (std::size_t i = routines_.size(); i-- > 0;) {
      if (!uses_[i].isCalled) continue;
      uses_[i].needed = recorder_.neededBy(routines_[i].results);
      findUses(uses_[i].needed);
    }
    std::uint32_t defined = 0;
    for (std::size_t i = 0; i < routines_.size(); ++i) {
      if (!uses_[i].isCalled) continue;
      uses_[i].number = defined++;
      define(routines_[i], uses_[i]);
    }
    writeNeeded(needed);
    for (const Id result : results) listing_.results.push_back(numbers_[index(result)]);
  }

  // True for externals that are read.
  std::vector<bool> isNamed;

 private:
  // The calls of a function. Arguments that differ between calls, or aren't constant, come first:
  // derivatives are needed only with respect to these.
  struct Use {
    bool isCalled = false;
    std::vector<bool> varies{};
    std::vector<Id> needed{};
    std::uint32_t number = 0;
    std::uint32_t variables = 0;
    std::vector<std::uint32_t> indices{};  // by argument
  };

  void findUses(std::span<const Id> ids) {
    for (const Id id : ids) {
      const Operation& operation = recorder_.at(id);
      if (operation.code != Code::Call) continue;
      const auto arguments = recorder_.operands(id);
      Use& use = uses_[static_cast<std::size_t>(operation.value)];
      use.isCalled = true;
      use.varies.resize(arguments.size());
      for (std::size_t i = 0; i < arguments.size(); ++i)
        if (!recorder_.isConstant(arguments[i])) use.varies[i] = true;
    }
  }

  void define(const Routine& routine, Use& use) {
    use.indices.resize(use.varies.size());
    std::uint32_t count = 0;
    for (const bool varies : {true, false}) {
      for (std::size_t i = 0; i < use.varies.size(); ++i)
        if (use.varies[i] == varies) use.indices[i] = count++;
      if (varies) use.variables = count;
    }
    write(Code::Define);
    write(count);
    write(use.variables);
    listing_.routines.push_back(routine.name);
    routine_ = &routine;
    next_ = 0;
    writeNeeded(use.needed);
    routine_ = nullptr;
    next_ = 0;
    write(Code::End);
    write(static_cast<std::uint32_t>(routine.results.size()));
    writeNumbers(routine.results);
  }

  // Writes the operations, each in the innermost loop whose step number or states it depends on.
  void writeNeeded(std::span<const Id> needed) {
    std::vector<std::uint32_t> used{0};
    for (const Id id : needed) {
      const Operation& operation = recorder_.at(id);
      std::uint32_t& loop = loops_[index(id)] = 0;
      if (operation.code == Code::StepNumber || operation.code == Code::State) {
        loop = leafOf(operation).number;
        locals_[loop].push_back(id);
        used.push_back(loop);
        continue;
      }
      if (operation.code == Code::Fold) {
        loop = recorder_.loop(loopOf(operation)).outer;
      } else {
        for (const Id operand : recorder_.operands(id))
          loop = std::max(loop, loops_[index(operand)]);
      }
      bodies_[loop].push_back(id);
      used.push_back(loop);
    }
    writeAll(0);
    for (const std::uint32_t loop : used) {
      bodies_[loop].clear();
      locals_[loop].clear();
    }
  }

  void writeAll(std::uint32_t loop) {
    for (const Id id : bodies_[loop]) writeOne(id);
  }

  void writeOne(Id id) {
    const Operation& operation = recorder_.at(id);
    const auto operands = recorder_.operands(id);
    std::uint32_t& number = numbers_[index(id)];
    switch (operation.code) {
      case Code::SameBits:
        number = numbers_[index(operands[0])];
        return;
      // Names of images are not operations.
      case Code::Image:
        number = leafOf(operation).number;
        isNamed[number] = true;
        return;
      case Code::Fold:
        return writeFold(id);
      case Code::Call:
        return writeCall(id);
      case Code::Uniform:
        if (!routine_) break;
        number = next_++;
        return writeParameter(parameterOutside(id));
      case Code::Parameter:
        number = next_++;
        return writeParameter(leafOf(operation).part);
      // Numbered together with the other results of its loop or call.
      case Code::Outcome:
      case Code::Result:
        number = numbers_[index(operands[0])] + leafOf(operation).part;
        return;
      default:
        break;
    }
    number = next_++;
    write(operation.code);
    switch (operation.code) {
      case Code::Constant:
      case Code::Undefined:
        listing_.words.back() = static_cast<std::uint32_t>(codeOfConstant(operation.base));
        write(static_cast<std::uint32_t>(listing_.constants.size()));
        listing_.constants.push_back(finite(operation.value));
        break;
      case Code::Argument:
      case Code::Uniform: {
        const auto [input, part, layout] = leafOf(operation);
        write(input);
        write(part);
        write(layout);
        if (operation.code == Code::Uniform) isNamed[input] = true;
        break;
      }
      case Code::Component:
        write(numbers_[index(operands[0])]);
        write(leafOf(operation).part);
        write(leafOf(operation).layout);
        break;
      default:
        if (!isOfImage(operation.code)) write(operation.count);
        writeNumbers(operands);
    }
  }

  std::size_t parameterOutside(Id id) const {
    const auto& outside = routine_->outside;
    return routine_->parameters +
           static_cast<std::size_t>(std::find(outside.begin(), outside.end(), id) -
                                    outside.begin());
  }

  void writeParameter(std::size_t argument) {
    write(Code::Parameter);
    write(uses_[static_cast<std::size_t>(routine_ - routines_.data())].indices[argument]);
  }

  void writeCall(Id id) {
    const auto routine = static_cast<std::size_t>(recorder_.at(id).value);
    const auto arguments = recorder_.operands(id);
    const Use& use = uses_[routine];
    std::vector<Id> ordered(arguments.size());
    for (std::size_t i = 0; i < arguments.size(); ++i) ordered[use.indices[i]] = arguments[i];
    write(Code::Call);
    write(use.number);
    write(static_cast<std::uint32_t>(arguments.size()));
    writeNumbers(ordered);
    numbers_[index(id)] = next_;
    next_ += static_cast<std::uint32_t>(routines_[routine].results.size());
  }

  void writeFold(Id id) {
    const std::uint32_t loop = loopOf(recorder_.at(id));
    const auto operands = recorder_.operands(id);
    const std::size_t count = operands.size() / 2;
    write(Code::Fold);
    write(recorder_.loop(loop).isCounted() ? recorder_.loop(loop).steps : 0);
    write(static_cast<std::uint32_t>(count));
    writeNumbers(operands.first(count));
    // The step number, then the states.
    const std::uint32_t first = next_;
    next_ += static_cast<std::uint32_t>(count) + 1;
    for (const Id local : locals_[loop]) {
      const Operation& leaf = recorder_.at(local);
      const bool isState = leaf.code == Code::State;
      numbers_[index(local)] = first + (isState ? 1 + leafOf(leaf).part : 0);
    }
    writeAll(loop);
    write(Code::Next);
    writeNumbers(operands.subspan(count));
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

  void write(std::uint32_t word) { listing_.words.push_back(word); }
  void write(Code code) { write(static_cast<std::uint32_t>(code)); }
  void writeNumbers(std::span<const Id> ids) {
    for (const Id id : ids) write(numbers_[index(id)]);
  }

  const Recorder& recorder_;
  const std::vector<Routine>& routines_;
  Listing& listing_;
  std::vector<Use> uses_;                         // by routine
  std::vector<std::uint32_t> numbers_, loops_;    // by operation
  std::vector<std::vector<Id>> bodies_, locals_;  // by loop; 0 is outside of all loops
  std::uint32_t next_ = 0;
  const Routine* routine_ = nullptr;  // the routine being defined
};

}  // namespace

Listing list(const Lowered& lowered, const Types& types) {
  Listing listing;
  Lister lister(lowered, listing);
  lister.list(lowered.results);
  for (std::size_t i = 0; i < lowered.externals.size(); ++i) {
    const auto& [name, type, isAttribute] = lowered.externals[i];
    listing.names.push_back(
        {name, types.name(type), isAttribute, lister.isNamed[i], {type.columns, type.rows}});
  }
  return listing;
}

}  // namespace warpjet::source
