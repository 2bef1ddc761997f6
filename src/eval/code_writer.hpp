// Writes the instructions of one function of a module: its values are locals, which the engine maps
// to registers. Only one function is written at a time: the operators of `Staged` write to it.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "eval/staged.hpp"

namespace warpjet {

inline constexpr std::uint32_t noFunction = ~0u;

// The state that the functions of a module share.
struct CodeModule {
  // The bits of floats shared by all vertices; `sharedAt` is their offset in the memory passed to a
  // call.
  std::uint32_t sharedAt;
  std::vector<std::uint32_t> shared;
  // The number of each operation's function in this module, and of its imported function; or
  // `noFunction`.
  std::array<std::uint32_t, ops::count> routines, kernels;
  std::uint32_t eachLane = noFunction;
  std::size_t firstConstant = 0;  // where the constants of formulas start among the shared floats

  std::uint32_t constant(std::uint32_t bits);
};

// Returns the formula that a routine computes.
Staged routineFormula(Op op, Staged x, Staged y);

class CodeWriter {
 public:
  // Starts a function with `numbers` integer parameters, the first of which is the address of the
  // memory passed to a call, followed by `lanes` parameters of four floats.
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
  // Works for any operation, by calling it for each lane.
  Staged callEachLane(Op op, const Operands<Staged>& x);
  // Returns `value`, except that lanes where the mask is set are computed one by one from `x`.
  Staged replaceLanes(StagedMask mask, Staged value, Op op, Staged x);

  // Loads this component of an array for four vertices; the array is at this offset and has `size`
  // numbers per vertex. The second parameter is 16 times the index of the four vertices.
  Staged load(std::uint32_t offset, std::uint32_t size, std::uint32_t component);
  void store(Staged x, std::uint32_t offset, std::uint32_t size, std::uint32_t component);
  // `loadOne` and `storeOne` access one number, which is the same in all lanes; `loadFour` and
  // `storeFour` access four lanes as they are.
  Staged loadOne(std::uint32_t offset);
  void storeOne(Staged x, std::uint32_t offset);
  Staged loadFour(std::uint32_t offset);
  void storeFour(Staged x, std::uint32_t offset);

  // Returns a value from the function.
  void returnValue(Staged x) { push(x); }

  // Returns the value in a local that no other value shares.
  Staged copyToOwnLocal(Staged x);
  // `release` frees a local for another value; `releaseAllBut` frees all locals taken since its
  // last call, except this one.
  void release(Staged x) { free_.push_back(x.place); }
  void releaseAllBut(Staged x);

  std::size_t size() const { return code_.size(); }
  // Returns the function with its locals, as stored in the code section.
  WasmBytes function() const;

 private:
  void push(Staged x);
  Staged pop();
  std::uint32_t addLocal() { return address_ + 1 + locals_++; }
  void simd(wasm::Simd instruction, int offset = -1);
  void get(std::uint32_t local);
  void call(std::uint32_t function);
  void computeAddress(std::uint32_t size);

  CodeModule& module_;
  WasmBytes code_;
  std::uint32_t firstLanes_, address_, locals_ = 0;
  std::vector<std::uint32_t> free_, taken_;
  // Maps a shared number -> the local that has it since its first use.
  std::map<std::uint32_t, std::uint32_t> sharedLocals_;
  bool isInBranch_ = false;  // inside a branch, where a local would be set only sometimes
};

}  // namespace warpjet
