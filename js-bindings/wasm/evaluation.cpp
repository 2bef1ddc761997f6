// The border to JavaScript of what runs programs on many vertices: plain C, since a call has
// numbers and addresses only. The caller lays programs and arrays into memory that it allocates
// here.
#include <emscripten.h>
#include <emscripten/emmalloc.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "eval/blocks.hpp"
#include "eval/bounds.hpp"
#include "eval/each_lane.hpp"
#include "eval/machine_code.hpp"

using namespace warpjet;

namespace {

// An array in memory: its address, its numbers a vertex, and for an input whether all vertices
// share them.
struct Array {
  float* values;
  std::uint32_t size;
  std::uint32_t isUniform;
};

std::vector<Stream> streams(const Array* arrays, int count) {
  std::vector<Stream> all;
  for (int i = 0; i < count; ++i)
    all.push_back({arrays[i].values, arrays[i].size, arrays[i].isUniform != 0});
  return all;
}

std::vector<Sink> sinks(const Array* arrays, int count) {
  std::vector<Sink> all;
  for (int i = 0; i < count; ++i) all.push_back({arrays[i].values, arrays[i].size});
  return all;
}

// Their addresses are offsets.
std::vector<Placement> placements(const Array* arrays, int count) {
  std::vector<Placement> all;
  for (int i = 0; i < count; ++i)
    all.push_back({static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(arrays[i].values)),
                   arrays[i].size, arrays[i].isUniform != 0});
  return all;
}

// What JavaScript reads of it stands first.
struct MadeCode {
  const std::uint8_t* module = nullptr;
  std::uint32_t moduleSize = 0;
  const std::uint32_t* shared = nullptr;
  std::uint32_t sharedCount = 0;
  std::uint32_t sharedAt = 0;
  MachineCode code;

  explicit MadeCode(MachineCode made) : code(std::move(made)) {
    module = code.module.data();
    moduleSize = static_cast<std::uint32_t>(code.module.size());
    shared = code.shared.data();
    sharedCount = static_cast<std::uint32_t>(code.shared.size());
    sharedAt = code.sharedAt;
  }
};

std::span<const std::uint32_t> words(const std::uint32_t* first, int count) {
  return {first, static_cast<std::size_t>(count)};
}

}  // namespace

extern "C" {

// Readies a program of so many instructions for the wanted ones of its results.
EMSCRIPTEN_KEEPALIVE BlockEvaluator* openEvaluator(const std::uint32_t* program, int size,
                                                   int instructions, const std::uint32_t* wanted,
                                                   int wantedCount, const Array* inputs,
                                                   int inputCount) {
  const std::vector<Stream> given = streams(inputs, inputCount);
  std::vector<bool> isUniform;
  for (const Stream& stream : given)
    isUniform.resize(isUniform.size() + stream.size, stream.isUniform);
  return new BlockEvaluator(
      allocateRegisters(words(program, size), static_cast<std::uint32_t>(instructions),
                        words(wanted, wantedCount), isUniform),
      given);
}

// Marks the inputs, number by number, that the wanted results depend on.
EMSCRIPTEN_KEEPALIVE void markInputs(const std::uint32_t* program, int size, int instructions,
                                     const std::uint32_t* wanted, int wantedCount,
                                     std::uint32_t* marks, int inputNumbers) {
  const RegisterProgram made = allocateRegisters(
      words(program, size), static_cast<std::uint32_t>(instructions), words(wanted, wantedCount),
      std::vector<bool>(static_cast<std::size_t>(inputNumbers)));
  for (const RegisterInstruction& instruction : made.body) {
    if (instruction.op == inputOp) marks[instruction.input] = 1;
  }
}

EMSCRIPTEN_KEEPALIVE void runEvaluator(BlockEvaluator* evaluator, int vertices, const Array* inputs,
                                       int inputCount, const Array* results, int resultCount) {
  evaluator->run(static_cast<std::size_t>(vertices), streams(inputs, inputCount),
                 sinks(results, resultCount));
}

// Ranges are pairs of a low and a high number: of each number of the inputs, and of each result.
EMSCRIPTEN_KEEPALIVE void bound(const std::uint32_t* program, int size, int instructions,
                                const Range* ranges, int rangeCount, const std::uint32_t* wanted,
                                int wantedCount, Range* results) {
  const std::vector<Range> found =
      bounds(words(program, size), static_cast<std::uint32_t>(instructions),
             {ranges, static_cast<std::size_t>(rangeCount)}, words(wanted, wantedCount));
  std::copy(found.begin(), found.end(), results);
}

// Machine code for the wanted results, of arrays at these offsets, all of them before `end`; null
// if it would be too long.
EMSCRIPTEN_KEEPALIVE MadeCode* makeMachineCode(const std::uint32_t* program, int size,
                                               int instructions, const std::uint32_t* wanted,
                                               int wantedCount, const Array* inputs, int inputCount,
                                               const Array* results, int resultCount, int end) {
  if (static_cast<std::size_t>(instructions) > mostInstructions) return nullptr;
  const std::vector<Placement> from = placements(inputs, inputCount);
  std::vector<bool> isUniform;
  for (const Placement& input : from)
    isUniform.resize(isUniform.size() + input.size, input.isUniform);
  const RegisterProgram made =
      allocateRegisters(words(program, size), static_cast<std::uint32_t>(instructions),
                        words(wanted, wantedCount), isUniform);
  return new MadeCode(
      machineCode(made, from, placements(results, resultCount), static_cast<std::uint32_t>(end)));
}

EMSCRIPTEN_KEEPALIVE void dropMachineCode(MadeCode* made) { delete made; }

EMSCRIPTEN_KEEPALIVE void closeEvaluator(BlockEvaluator* evaluator) { delete evaluator; }

EMSCRIPTEN_KEEPALIVE void* allocate(int bytes) {
  return std::malloc(static_cast<std::size_t>(bytes));
}

EMSCRIPTEN_KEEPALIVE void release(void* memory) { std::free(memory); }

// What machine code imports: `Staged` of src/eval/staged.hpp has what else it needs.
#define LANES(name) \
  EMSCRIPTEN_KEEPALIVE simd::Floats lanes_##name(simd::Floats x) { return name(Lanes(x)).floats; }
#define LANES_OF_TWO(name)                                                         \
  EMSCRIPTEN_KEEPALIVE simd::Floats lanes_##name(simd::Floats x, simd::Floats y) { \
    return name(Lanes(x), Lanes(y)).floats;                                        \
  }
LANES(tan)
LANES(asin)
LANES(acos)
LANES(atan)
LANES(exp)
LANES(exp2)
LANES(log)
LANES(log2)
LANES(sinh)
LANES(cosh)
LANES(tanh)
LANES(asinh)
LANES(acosh)
LANES(atanh)
LANES_OF_TWO(atan2)
LANES_OF_TWO(pow)

EMSCRIPTEN_KEEPALIVE simd::Floats lanes_each_lane(int op, simd::Floats x, simd::Floats y,
                                                  simd::Floats z) {
  return eachLane(Op{static_cast<std::uint8_t>(op)}, {Lanes(x), Lanes(y), Lanes(z)}).floats;
}

// Bytes that are allocated now.
EMSCRIPTEN_KEEPALIVE int memoryInUse() {
  return static_cast<int>(emmalloc_dynamic_heap_size() - emmalloc_free_dynamic_memory());
}

}  // extern "C"
