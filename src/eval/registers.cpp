#include "eval/registers.hpp"

#include <algorithm>
#include <numeric>

#include "eval/words.hpp"
#include "graph/schedule.hpp"

namespace warpjet {

namespace {

// The allocation of an instruction.
struct Allocation {
  bool isNeeded = false;
  bool isUniform = true;
  std::uint32_t task = none;  // `none` if it is uniform
  // The remaining readers, plus one for a result, so that its register is never freed.
  std::uint32_t readersLeft = 0;
  Register result;
};

class Allocator {
 public:
  Allocator(const Words& program, std::span<const std::uint32_t> wanted,
            const std::vector<bool>& isUniform)
      : program_(program), wanted_(wanted), isUniform_(isUniform), allocations_(program.count()) {}

  RegisterProgram run() {
    findNeeded();
    for (std::uint32_t i = 0; i < program_.count(); ++i) {
      if (allocations_[i].isNeeded && isConstant(i)) {
        result_.constants.push_back(constant(i));
        allocations_[i].result = {result_.uniformRegisters++, true};
      }
    }
    for (std::uint32_t i = 0; i < program_.count(); ++i) {
      if (!allocations_[i].isNeeded || isConstant(i)) continue;
      allocations_[i].isUniform = isUniform(i);
      if (allocations_[i].isUniform) {
        result_.prologue.push_back(translate(i, {result_.uniformRegisters++, true}));
      } else {
        addTask(i);
      }
    }
    for (const std::uint32_t task : chooseOrder()) {
      const std::uint32_t i = instructions_[task];
      // Operands are released before the result's register is taken: an instruction may overwrite
      // them, since it reads the operands of four vertices before it writes their result.
      for (const std::uint32_t read : work_.readsOf(task)) release(instructions_[read]);
      result_.body.push_back(translate(i, {takeRegister(), false}));
    }
    for (const std::uint32_t i : wanted_)
      result_.results.push_back(allocations_[program_.result(i)].result);
    return std::move(result_);
  }

 private:
  // Returns true for `int(constant)`, which is stored as its bits: a float can't represent all
  // integers.
  bool isKnownInt(std::uint32_t i) const {
    return program_.op(i) == ops::find("int") && program_.op(program_.operands(i)[0]) == constantOp;
  }
  bool isConstant(std::uint32_t i) const { return program_.op(i) == constantOp || isKnownInt(i); }
  float constant(std::uint32_t i) const {
    if (!isKnownInt(i)) return static_cast<float>(program_.constant(i));
    const double value = program_.constant(program_.operands(i)[0]);
    return __builtin_bit_cast(float, static_cast<std::int32_t>(value));
  }

  void findNeeded() {
    for (const std::uint32_t i : wanted_) {
      allocations_[program_.result(i)].isNeeded = true;
      allocations_[program_.result(i)].readersLeft = 1;
    }
    for (std::uint32_t i = program_.count(); i-- > 0;) {
      if (!allocations_[i].isNeeded) continue;
      for (const std::uint32_t operand : program_.operands(i))
        allocations_[operand].isNeeded = true;
    }
  }

  bool isUniform(std::uint32_t i) const {
    if (program_.op(i) == inputOp) return isUniform_[program_.input(i)];
    const auto operands = program_.operands(i);
    return std::all_of(operands.begin(), operands.end(),
                       [&](std::uint32_t operand) { return allocations_[operand].isUniform; });
  }

  void addTask(std::uint32_t i) {
    Task task{static_cast<std::uint32_t>(work_.reads.size()), 0, allocations_[i].readersLeft > 0};
    for (const std::uint32_t operand : program_.operands(i)) {
      const auto begin = work_.reads.begin() + task.firstRead;
      const std::uint32_t read = allocations_[operand].task;
      if (read == none || std::find(begin, work_.reads.end(), read) != work_.reads.end()) continue;
      work_.reads.push_back(read);
      ++task.readCount;
      ++allocations_[operand].readersLeft;
    }
    allocations_[i].task = static_cast<std::uint32_t>(work_.tasks.size());
    work_.tasks.push_back(task);
    instructions_.push_back(i);
  }

  RegisterInstruction translate(std::uint32_t i, Register result) {
    RegisterInstruction instruction;
    instruction.op = program_.op(i);
    instruction.result = allocations_[i].result = result;
    if (instruction.op == inputOp) instruction.input = program_.input(i);
    auto next = instruction.operands.begin();
    for (const std::uint32_t operand : program_.operands(i)) *next++ = allocations_[operand].result;
    return instruction;
  }

  // Returns the order of the tasks in which fewer values are alive at once. `schedule` works on
  // several results side by side, which suits derivatives; but it also interleaves the octaves of
  // a noise, and three of them then need 120 registers instead of 34.
  std::vector<std::uint32_t> chooseOrder() const {
    std::vector<std::uint32_t> scheduled = schedule(work_), original(work_.tasks.size());
    std::iota(original.begin(), original.end(), 0);
    return countAlive(original) < countAlive(scheduled) ? original : scheduled;
  }

  // Returns the max number of values that are alive at once.
  std::size_t countAlive(std::span<const std::uint32_t> order) const {
    std::vector<std::uint32_t> readersLeft;
    for (const std::uint32_t i : instructions_) readersLeft.push_back(allocations_[i].readersLeft);
    std::size_t alive = 0, max = 0;
    for (const std::uint32_t task : order) {
      for (const std::uint32_t read : work_.readsOf(task)) alive -= --readersLeft[read] == 0;
      max = std::max(max, ++alive);
    }
    return max;
  }

  void release(std::uint32_t i) {
    if (--allocations_[i].readersLeft == 0) free_.push_back(allocations_[i].result.number);
  }

  std::uint32_t takeRegister() {
    if (free_.empty()) return result_.blockRegisters++;
    const std::uint32_t number = free_.back();
    free_.pop_back();
    return number;
  }

  const Words program_;
  std::span<const std::uint32_t> wanted_;
  const std::vector<bool>& isUniform_;
  std::vector<Allocation> allocations_;  // by instruction
  Work work_;
  std::vector<std::uint32_t> instructions_;  // by task
  std::vector<std::uint32_t> free_;
  RegisterProgram result_;
};

}  // namespace

RegisterProgram allocateRegisters(std::span<const std::uint32_t> words, std::uint32_t instructions,
                                  std::span<const std::uint32_t> wanted,
                                  const std::vector<bool>& isUniform) {
  return Allocator(Words(words, instructions), wanted, isUniform).run();
}

}  // namespace warpjet
