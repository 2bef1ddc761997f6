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
    isUniform.insert(isUniform.end(), stream.size, stream.isUniform);
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

EMSCRIPTEN_KEEPALIVE void closeEvaluator(BlockEvaluator* evaluator) { delete evaluator; }

EMSCRIPTEN_KEEPALIVE void* allocate(int bytes) {
  return std::malloc(static_cast<std::size_t>(bytes));
}

EMSCRIPTEN_KEEPALIVE void release(void* memory) { std::free(memory); }

// Bytes that are allocated now.
EMSCRIPTEN_KEEPALIVE int memoryInUse() {
  return static_cast<int>(emmalloc_dynamic_heap_size() - emmalloc_free_dynamic_memory());
}

}  // extern "C"
