// What a text computes, as operations on single numbers: each once, folded where all is known, so
// that loops and indices are. Numbers of type float fold in float32, as the language says.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <unordered_map>
#include <vector>

#include "glsl/codes.hpp"
#include "glsl/types.hpp"

namespace warpjet::glsl {

// The number of an operation.
enum class Id : std::uint32_t {};

constexpr std::uint32_t index(Id id) { return static_cast<std::uint32_t>(id); }

struct Operation {
  Code code;
  // Of the result; that of a group of numbers is Float.
  Base base;
  std::uint16_t count = 0;
  // In the list of operands.
  std::uint32_t first = 0;
  // Of a constant; of a leaf or a component its number.
  double value = 0;
};

// A loop of the shader: how often it runs, and the loop that it stands in, counted from 1 on.
struct Loop {
  std::uint32_t outer;
  std::uint32_t steps = 0;
  // Those of the loops within it, multiplied, where they are the most.
  std::uint32_t inner = 1;
};

class Recorder {
 public:
  static constexpr std::size_t most = std::size_t{1} << 20;
  static constexpr std::size_t mostLoops = 60'000;

  // `foldsAll` folds functions of known numbers too, whose last bits differ from GPU to GPU.
  explicit Recorder(bool foldsAll = false) : foldsAll_(foldsAll) {}
  bool foldsAll() const { return foldsAll_; }

  Id constant(Base base, double value);
  // What was never given a value: any will do.
  Id undefined(Base base);
  // A leaf: component number `part` of an argument or a uniform of that layout, or an image.
  Id leaf(Code code, int number, int part = 0, int layout = 0);
  // The same as a number of that type. Of a whole number there are two leaves, of 16 bits each,
  // since a leaf is a float.
  Id leafOf(Code code, int number, int part, Type type);
  // Beside a layout, says that the leaf is the upper half, with the sign.
  static constexpr int highHalf = 128;

  // The operation, folded where all is known. A result of int or uint wraps around.
  Id apply(Code code, Base base, std::initializer_list<Id> operands);
  // Numbers together, for an operation on vectors; its results one by one.
  Id group(Code code, std::span<const Id> operands);
  // `layout` is how many columns and rows it has, four bits each.
  Id component(Id group, int part, int layout) {
    return component(Code::Component, group, part, layout);
  }

  // A number that a function of the text is called with.
  Id parameter(std::uint32_t routine, std::size_t i) {
    return leaf(Code::Parameter, static_cast<int>(routine), static_cast<int>(i));
  }
  Id call(std::uint32_t routine, std::span<const Id> arguments);
  Id result(Id call, std::size_t i) {
    return component(Code::Result, call, static_cast<int>(i), 0);
  }
  // What these need, and they themselves, in order.
  std::vector<Id> neededBy(std::span<const Id> results) const;

  // A loop whose body is recorded from now on, in one that is open too, or 0: its number, from 1
  // on.
  std::uint32_t openLoop(std::uint32_t outer);
  Id step(std::uint32_t loop) { return leaf(Code::StepNumber, static_cast<int>(loop)); }
  Id state(std::uint32_t loop, std::size_t i) {
    return leaf(Code::State, static_cast<int>(loop), static_cast<int>(i));
  }
  // The loop from what its states, which are floats, start as, to what each step makes of them.
  Id fold(std::uint32_t loop, std::uint32_t steps, std::span<const Id> starts,
          std::span<const Id> nexts);
  // What that state is in the end.
  Id outcome(Id fold, std::size_t state) {
    return component(Code::Outcome, fold, static_cast<int>(state), 0);
  }
  const Loop& loop(std::uint32_t number) const { return loops_[number - 1]; }
  std::size_t loopCount() const { return loops_.size(); }

  Id choose(Id condition, Id yes, Id no);
  Id negated(Id condition);
  Id both(Id a, Id b);
  Id either(Id a, Id b);
  // From one type of numbers to another, as a constructor does it.
  Id convert(Id value, Base to);

  Base base(Id id) const { return at(id).base; }
  bool isConstant(Id id) const { return at(id).code == Code::Constant; }
  bool isUndefined(Id id) const { return at(id).code == Code::Undefined; }
  double value(Id constant) const { return at(constant).value; }
  bool isTrue(Id id) const { return isConstant(id) && value(id) != 0; }
  bool isFalse(Id id) const { return isConstant(id) && value(id) == 0; }
  bool isFull() const { return operations_.size() >= most; }
  std::size_t size() const { return operations_.size(); }
  const Operation& at(Id id) const { return operations_[index(id)]; }
  std::span<const Id> operands(Id id) const {
    return {operands_.data() + at(id).first, at(id).count};
  }

 private:
  // What a language refuses to compile: divisions by a zero and shifts by 32 that it can see.
  Id tamed(Code code, Base base, Id x, Id y);
  Id component(Code code, Id group, int part, int layout);
  // Whether a float is made of whole numbers and the numbers of steps.
  bool isWhole(Id id) const;
  Id intern(Operation operation, std::span<const Id> operands);
  bool isEqual(Id id, const Operation& operation, std::span<const Id> operands) const;

  bool foldsAll_;
  std::vector<Operation> operations_;
  std::vector<Id> operands_;
  std::unordered_multimap<std::uint64_t, Id> known_;
  std::vector<Loop> loops_;
};

}  // namespace warpjet::glsl
