// The bindings for evaluating programs at many vertices. The interpreter's inputs and results are
// passed as views of arrays; machine code has its own arrays, in memory that JavaScript allocates.
#include <emscripten.h>
#include <malloc.h>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "embind.hpp"
#include "eval/blocks.hpp"
#include "eval/bounds.hpp"
#include "eval/each_lane.hpp"
#include "eval/machine_code.hpp"

using namespace warpjet;

namespace {

using Words = std::vector<std::uint32_t>;

// The numbers of an input: `size` per vertex or, if it is uniform, `size` in total.
struct InputArray {
  std::uint32_t size;
  bool isUniform;

  std::size_t length(std::uint32_t vertices) const {
    return std::size_t{size} * (isUniform ? 1 : vertices);
  }
};

// The words and instructions of warpjet::Program.
class CpuProgram {
 public:
  CpuProgram(Words words, std::uint32_t instructions)
      : words_(std::move(words)), instructions_(instructions) {}

  // Returns for each input whether the wanted results depend on it. `sizes` has the number of
  // components of each input.
  std::vector<std::uint8_t> inputsRead(const Words& wanted, const Words& sizes) const {
    std::vector<std::uint8_t> isRead;
    std::vector<std::size_t> inputOf;  // the input that each number belongs to
    for (const std::uint32_t size : sizes) {
      inputOf.insert(inputOf.end(), size, isRead.size());
      isRead.push_back(0);
    }
    const RegisterProgram program = allocate(wanted, std::vector<bool>(inputOf.size()));
    for (const RegisterInstruction& instruction : program.body)
      if (instruction.op == inputOp) isRead[inputOf[instruction.input]] = 1;
    return isRead;
  }

  // Returns a lower and an upper bound of each wanted result. `ranges` has the bounds of each
  // component of the inputs. `budget` can only lower that of `BoundsOptions`.
  std::vector<double> bounds(const std::vector<double>& ranges, const Words& wanted,
                             double budget) const {
    std::vector<Range> inputRanges;
    for (std::size_t i = 0; i + 1 < ranges.size(); i += 2)
      inputRanges.push_back({ranges[i], ranges[i + 1]});
    BoundsOptions options;
    if (budget < static_cast<double>(options.budget))
      options.budget = static_cast<std::uint64_t>(budget);
    std::vector<double> lowsAndHighs;
    for (const auto& [low, high] :
         warpjet::bounds(words_, instructions_, inputRanges, wanted, options))
      lowsAndHighs.insert(lowsAndHighs.end(), {low, high});
    return lowsAndHighs;
  }

  bool isTooLongForMachineCode() const { return instructions_ > maxInstructions; }

  RegisterProgram allocate(const Words& wanted, const std::vector<InputArray>& inputs) const {
    std::vector<bool> isUniform;
    for (const InputArray& input : inputs)
      isUniform.resize(isUniform.size() + input.size, input.isUniform);
    return allocate(wanted, isUniform);
  }

 private:
  RegisterProgram allocate(const Words& wanted, const std::vector<bool>& isUniform) const {
    return allocateRegisters(words_, instructions_, wanted, isUniform);
  }

  Words words_;
  std::uint32_t instructions_;
};

// Computes the wanted results of a program by interpreting it, in batches of at most `vertices`
// vertices. The caller fills the inputs before each run; uniform ones only before the first.
class Evaluator {
 public:
  Evaluator(const CpuProgram& program, const Words& wanted, const std::vector<InputArray>& inputs,
            const Words& resultSizes, std::uint32_t vertices)
      : program_(program.allocate(wanted, inputs)) {
    for (const InputArray& input : inputs) {
      inputs_.emplace_back(input.length(vertices));
      streams_.push_back({inputs_.back().data(), input.size, input.isUniform});
    }
    for (const std::uint32_t size : resultSizes) {
      results_.emplace_back(std::size_t{size} * vertices);
      sinks_.push_back({results_.back().data(), size});
    }
  }

  View<float> input(std::uint32_t i) { return View(inputs_[i]); }
  View<float> result(std::uint32_t i) { return View(results_[i]); }

  void run(std::uint32_t vertices) {
    if (!evaluator_) evaluator_.emplace(std::move(program_), streams_);
    evaluator_->run(vertices, streams_, sinks_);
  }

 private:
  RegisterProgram program_;
  std::vector<std::vector<float>> inputs_, results_;
  std::vector<Stream> streams_;
  std::vector<Sink> sinks_;
  std::optional<BlockEvaluator> evaluator_;
};

// Machine code, as a separate wasm module. The offsets refer to memory that the caller allocates.
struct Code {
  std::vector<std::uint8_t> module;  // empty if the program is too long
  Words inputsAt = {}, resultsAt = {};
  // The bits of floats that the caller copies to offset `sharedAt` before it calls the exported
  // `start`. They are the last part of the memory.
  Words shared = {};
  std::uint32_t sharedAt = 0;
};

Code makeCode(const CpuProgram& program, const Words& wanted, const std::vector<InputArray>& inputs,
              const Words& resultSizes, std::uint32_t vertices) {
  if (program.isTooLongForMachineCode()) return {};
  std::uint32_t end = 0;
  const auto place = [&](std::size_t numbers) {
    return std::exchange(end, end + static_cast<std::uint32_t>(sizeof(float) * numbers));
  };
  Code code{};
  std::vector<Placement> inputPlaces, resultPlaces;
  for (const InputArray& input : inputs) {
    code.inputsAt.push_back(place(input.length(vertices)));
    inputPlaces.push_back({code.inputsAt.back(), input.size, input.isUniform});
  }
  for (const std::uint32_t size : resultSizes) {
    code.resultsAt.push_back(place(std::size_t{size} * vertices));
    resultPlaces.push_back({code.resultsAt.back(), size});
  }
  MachineCode compiled =
      machineCode(program.allocate(wanted, inputs), inputPlaces, resultPlaces, end);
  code.module = std::move(compiled.module);
  code.shared = std::move(compiled.shared);
  code.sharedAt = compiled.sharedAt;
  return code;
}

std::uint32_t memoryInUse() { return mallinfo().uordblks; }

}  // namespace

// Functions that machine code imports. It contains the other operations itself: see `Staged` in
// src/eval/staged.hpp.
extern "C" {
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
}  // extern "C"

EMSCRIPTEN_BINDINGS(evaluation) {
  using namespace emscripten;

  registerArray<std::uint8_t>();
  registerArray<std::uint32_t>();
  registerArray<double>();
  registerArray<InputArray>();
  registerView<float>();

  value_object<InputArray>("InputArray")
      .field("size", &InputArray::size)
      .field("isUniform", &InputArray::isUniform);
  value_object<Code>("Code")
      .field("module", &Code::module)
      .field("inputsAt", &Code::inputsAt)
      .field("resultsAt", &Code::resultsAt)
      .field("shared", &Code::shared)
      .field("sharedAt", &Code::sharedAt);

  class_<CpuProgram>("Program")
      .constructor<Words, std::uint32_t>()
      .function("inputsRead", &CpuProgram::inputsRead)
      .function("bounds", &CpuProgram::bounds)
      .function("code", &makeCode);

  class_<Evaluator>("Evaluator")
      .constructor<const CpuProgram&, const Words&, const std::vector<InputArray>&, const Words&,
                   std::uint32_t>()
      .function("input", &Evaluator::input)
      .function("result", &Evaluator::result)
      .function("run", &Evaluator::run);

  function("memoryInUse", &memoryInUse);
}
