// The instructions of one function of a module: its values are locals, of which the engine makes
// registers. One function is written at a time: what the operators of `Staged` write is its.
#pragma once

#include <array>
#include <vector>

#include "eval/staged.hpp"

namespace warpjet {

inline constexpr std::uint32_t noFunction = ~0u;

// What the functions of a module have in common.
struct CodeModule {
  // Bits of floats that all vertices share, at this offset in the memory that a call is given.
  std::uint32_t sharedAt;
  std::vector<std::uint32_t> shared;
  // By operation, the number of the function of this module, if it has one, and of that from
  // outside.
  std::array<std::uint32_t, ops::count> routines, kernels;
  std::uint32_t eachLane = noFunction;
  std::size_t firstConstant = 0;  // of the shared ones, those of formulas

  std::uint32_t constant(std::uint32_t bits);
};

// What a routine computes.
Staged routineFormula(Op op, Staged x, Staged y);

class CodeWriter {
 public:
  // A function of so many parameters: whole numbers, the first of which is the address of that
  // memory, and then lanes.
  CodeWriter(CodeModule& module, std::uint32_t numbers, std::uint32_t lanes)
      : module_(module), firstLanes_(numbers), address_(numbers + lanes) {
    current = this;
  }
  ~CodeWriter() { current = nullptr; }
  CodeWriter(const CodeWriter&) = delete;

  static inline CodeWriter* current = nullptr;

  Staged parameter(std::uint32_t i) const { return Staged(firstLanes_ + i); }
  Staged number(double x);

  Staged apply(wasm::Simd instruction, std::initializer_list<Staged> operands);
  Staged shift(wasm::Simd instruction, Staged x, int count);
  Staged callRoutine(Op op, std::initializer_list<Staged> operands);
  Staged callKernel(Op op, std::initializer_list<Staged> operands);
  // For any operation, of each lane as a number.
  Staged callEachLane(Op op, const Operands<Staged>& x);
  // `value`, but where the mask is set what that gives.
  Staged orEachLane(StagedMask mask, Staged value, Op op, Staged x);

  // Of four vertices the numbers at this component of an array at this offset, which has `size` a
  // vertex. The second parameter is 16 times the number of the four.
  Staged load(std::uint32_t offset, std::uint32_t size, std::uint32_t component);
  void store(Staged x, std::uint32_t offset, std::uint32_t size, std::uint32_t component);
  // One number, the same in all lanes; and all four as they are.
  Staged loadOne(std::uint32_t offset);
  void storeOne(Staged x, std::uint32_t offset);
  Staged loadFour(std::uint32_t offset);
  void storeFour(Staged x, std::uint32_t offset);

  // The result of a function.
  void give(Staged x) { push(x); }

  // The value in a local that nothing else is in.
  Staged owned(Staged x);
  // A local is free for another value; or all that were taken since the last time, but this one.
  void release(Staged x) { free_.push_back(x.place); }
  void releaseAllBut(Staged x);

  std::size_t size() const { return code_.size(); }
  // With its locals, as the code section has it.
  WasmBytes function() const;

 private:
  void push(Staged x);
  Staged pop();
  void simd(wasm::Simd instruction, int offset = -1);
  void get(std::uint32_t local);
  void call(std::uint32_t function);
  void findAddress(std::uint32_t size);

  CodeModule& module_;
  WasmBytes code_;
  std::uint32_t firstLanes_, address_, locals_ = 0;
  std::vector<std::uint32_t> free_, taken_;
};

}  // namespace warpjet
