// Records the computations of a source as operations on single numbers. Equal operations are
// recorded once. If all operands are known, an operation is folded, so that the lengths of loops
// and indices are known, too. Floats are folded in float32, as the language requires.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <unordered_map>
#include <vector>

#include "source/codes.hpp"
#include "source/types.hpp"

namespace warpjet::source {

// The number of an operation.
enum class Id : std::uint32_t {};

constexpr std::uint32_t index(Id id) { return static_cast<std::uint32_t>(id); }

struct Operation {
  Code code;
  // The type of the result. An operation on vectors (see Recorder::group) has Float.
  Base base;
  std::uint16_t count = 0;
  // The index of the first operand in the list of operands.
  std::uint32_t first = 0;
  // The value of a constant, or the index (of an argument, a uniform or a component) that a leaf or
  // a component reads.
  double value = 0;
};

// The number of iterations of a loop that ends by itself: a number that no vertex shader reaches,
// and that float32 counts exactly.
inline constexpr std::uint32_t uncountedSteps = std::uint32_t{1} << 22;

// A loop of the shader. Loop numbers start at 1.
struct Loop {
  std::uint32_t outer;      // the number of the enclosing loop; 0 if there is none
  std::uint32_t steps = 0;  // the number of iterations
  // Iterations of the nested loops per iteration of this loop: the maximum of steps * inner over
  // its nested loops, where the steps of uncounted ones are omitted; 1 if there are none.
  std::uint32_t inner = 1;

  bool isCounted() const { return steps != uncountedSteps; }
};

// Converts a value to its representation in that type: rounds floats, and wraps integers around.
double representAs(Base base, double value);

class Recorder {
 public:
  static constexpr std::size_t maxOperations = std::size_t{1} << 20;
  static constexpr std::size_t maxLoops = 60'000;

  // With `foldsAll`, functions of known numbers are folded even if their last bits differ between
  // GPUs.
  explicit Recorder(bool foldsAll = false) : foldsAll_(foldsAll) {}
  bool foldsAll() const { return foldsAll_; }

  Id constant(Base base, double value);
  // Returns an uninitialized value: it may be anything.
  Id undefined(Base base);
  // Records a leaf: an image, or component `part` of argument or uniform number `number`. `layout`
  // encodes the columns and rows of its type, four bits each; it is 0 for images.
  Id leaf(Code code, int number, int part = 0, int layout = 0);
  // Returns the leaf as a number of that type. An integer consists of two leaves of 16 bits each,
  // since a leaf is a float.
  Id leafOf(Code code, int number, int part, Type type);
  // Added to `layout` for the upper 16 bits of an integer, which include the sign. Columns and rows
  // are at most 4, so this bit is free.
  static constexpr int highHalf = 128;

  // Records an operation, or folds it if all operands are known. Results of int or uint wrap
  // around.
  Id apply(Code code, Base base, std::initializer_list<Id> operands);
  // Records an operation on vectors, whose result is a group of numbers; `component` reads one of
  // them.
  Id group(Code code, std::span<const Id> operands);
  // `layout` holds the numbers of columns and rows, four bits each.
  Id component(Id group, int part, int layout) {
    return component(Code::Component, group, part, layout);
  }

  // Returns argument `i` of the function recorded as `routine`, for use in the body of that
  // function.
  Id parameter(std::uint32_t routine, std::size_t i) {
    return leaf(Code::Parameter, static_cast<int>(routine), static_cast<int>(i));
  }
  Id call(std::uint32_t routine, std::span<const Id> arguments);
  Id result(Id call, std::size_t i) {
    return component(Code::Result, call, static_cast<int>(i), 0);
  }
  // Returns all operations that the results depend on, including themselves, in order.
  std::vector<Id> neededBy(std::span<const Id> results) const;

  // Opens a loop whose body is recorded from now on; `outer` is the enclosing loop, or 0. Returns
  // the loop's number, counted from 1.
  std::uint32_t openLoop(std::uint32_t outer);
  Id step(std::uint32_t loop) { return leaf(Code::StepNumber, static_cast<int>(loop)); }
  Id state(std::uint32_t loop, std::size_t i) {
    return leaf(Code::State, static_cast<int>(loop), static_cast<int>(i));
  }
  // Closes a loop and returns its operation. `starts` are the initial values of its states, which
  // are floats, and `nexts` their values after each step. The first state of an uncounted loop
  // becomes 1 where the loop ends; from then on, no state changes.
  Id fold(std::uint32_t loop, std::uint32_t steps, std::span<const Id> starts,
          std::span<const Id> nexts);
  // Returns the final value of a state.
  Id outcome(Id fold, std::size_t state) {
    return component(Code::Outcome, fold, static_cast<int>(state), 0);
  }
  const Loop& loop(std::uint32_t number) const { return loops_[number - 1]; }
  std::size_t loopCount() const { return loops_.size(); }

  Id choose(Id condition, Id yes, Id no);
  Id logicalNot(Id condition);
  Id logicalAnd(Id a, Id b);
  Id logicalOr(Id a, Id b);
  // Converts between types of numbers, as a constructor does.
  Id convert(Id value, Base to);

  Base base(Id id) const { return at(id).base; }
  bool isConstant(Id id) const { return at(id).code == Code::Constant; }
  bool isUndefined(Id id) const { return at(id).code == Code::Undefined; }
  double value(Id constant) const { return at(constant).value; }
  bool isTrue(Id id) const { return isConstant(id) && value(id) != 0; }
  bool isFalse(Id id) const { return isConstant(id) && value(id) == 0; }
  bool isFull() const { return operations_.size() >= maxOperations; }
  std::size_t size() const { return operations_.size(); }
  const Operation& at(Id id) const { return operations_[index(id)]; }
  std::span<const Id> operands(Id id) const {
    return {operands_.data() + at(id).first, at(id).count};
  }

 private:
  // Replaces operations with constant operands that some languages reject at compile time:
  // divisions by 0, and shifts by 32 or more.
  Id avoidUndefined(Code code, Base base, Id x, Id y);
  Id component(Code code, Id group, int part, int layout);
  // Returns true if a float is computed only from integers and step numbers.
  bool isIntegral(Id id) const;
  Id intern(Operation operation, std::span<const Id> operands);
  bool isEqual(Id id, const Operation& operation, std::span<const Id> operands) const;

  bool foldsAll_;
  std::vector<Operation> operations_;
  std::vector<Id> operands_;
  std::unordered_multimap<std::uint64_t, Id> known_;
  std::vector<Loop> loops_;
};

}  // namespace warpjet::source
