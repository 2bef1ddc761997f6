#include "eval/machine_code.hpp"

#include <algorithm>

#include "eval/code_writer.hpp"
#include "eval/stages.hpp"
#include "eval/wasm_module.hpp"

namespace warpjet {

namespace {

// Optimizing compilers of engines take a few milliseconds for a function of this size. V8 ignores
// the order of instructions without side effects, computes independent parts side by side, and
// spills what doesn't fit into registers: three octaves of simplex noise take 123 ns per vertex in
// functions of 500 instructions, 106 in functions of 350, and 148 in functions of 120.
constexpr std::size_t instructionsPerFunction = 350;

// Up to this number of calls of routines, such as sines, are inlined, which saves a tenth to a
// third of the time. With more, the module would become long, so each routine becomes a function.
constexpr std::size_t maxInline = 64;

bool isRoutine(Op op) {
  return op == ops::find("sin") || op == ops::find("cos") || op == ops::find("hash");
}

class Generator {
 public:
  Generator(const RegisterProgram& program, std::span<const Placement> inputs,
            std::span<const Placement> results, std::uint32_t end)
      : program_(program), inputs_(inputs), results_(results), spillsAt_(end) {
    for (std::uint32_t input = 0; input < inputs.size(); ++input) {
      for (std::uint32_t i = 0; i < inputs[input].size; ++i) sources_.push_back({input, i});
    }
    homes_.resize(program.blockRegisters);
    module_.sharedAt = end;
    if (hasPieces()) module_.sharedAt += program.blockRegisters * std::uint32_t{sizeof(Lanes)};
    for (const float x : program.constants)
      module_.shared.push_back(__builtin_bit_cast(std::uint32_t, x));
    module_.shared.resize(module_.firstConstant = program.uniformRegisters);
  }

  MachineCode run() {
    importKernels();
    writeRoutines();
    const std::uint32_t prologue = wasm_.functionCount();
    writePieces(program_.prologue, false);
    const std::uint32_t body = wasm_.functionCount();
    writePieces(program_.body, true);
    writeStart(prologue, body);
    writeRun(body);
    return {wasm_.bytes(start_).bytes(), module_.sharedAt, std::move(module_.shared)};
  }

 private:
  struct Source {
    std::uint32_t input, component;
  };

  bool hasPieces() const { return program_.body.size() > instructionsPerFunction; }

  // Imports the functions of the interpreter that the program needs.
  void importKernels() {
    module_.kernels.fill(noFunction);
    module_.routines.fill(noFunction);
    module_.eachLane = wasm_.import("each_lane", EachLane);
    std::size_t uses = 0;
    for (const auto* part : {&program_.prologue, &program_.body}) {
      for (const RegisterInstruction& instruction : *part) {
        const Op op = instruction.op;
        if (op == inputOp) continue;
        if (isKernel(op)) importKernel(op);
        if (!isRoutine(op)) continue;
        if (std::find(routines_.begin(), routines_.end(), op) == routines_.end())
          routines_.push_back(op);
        ++uses;
      }
    }
    if (uses <= maxInline) routines_.clear();
  }

  static bool isKernel(Op op) {
    return std::find(kernelOps.begin(), kernelOps.end(), op) != kernelOps.end();
  }

  void importKernel(Op op) {
    if (module_.kernels[index(op)] != noFunction) return;
    module_.kernels[index(op)] =
        wasm_.import(ops::declaration(op).name, arities[index(op)] == 1 ? Kernel : Kernel2);
  }

  void writeRoutines() {
    for (const Op op : routines_) {
      const std::uint32_t functionIndex = wasm_.functionCount();
      const bool isUnary = arities[index(op)] == 1;
      CodeWriter writer(module_, 1, isUnary ? 1 : 2);
      writer.returnValue(
          routineFormula(op, writer.parameter(0), writer.parameter(isUnary ? 0 : 1)));
      wasm_.add(isUnary ? Routine : Routine2, writer.function());
      module_.routines[index(op)] = functionIndex;
    }
  }

  // Writes one function per `instructionsPerFunction` instructions; the last one also writes the
  // results.
  void writePieces(const std::vector<RegisterInstruction>& instructions, bool isBody) {
    for (std::size_t first = 0; first < instructions.size() || (isBody && first == 0);
         first += instructionsPerFunction) {
      const std::size_t last = std::min(first + instructionsPerFunction, instructions.size());
      CodeWriter writer(module_, 2, 0);
      std::fill(homes_.begin(), homes_.end(), Home{});
      for (std::size_t i = first; i < last; ++i) write(writer, instructions[i]);
      if (isBody && last == instructions.size())
        writeResults(writer);
      else
        spill(writer);
      wasm_.add(Piece, writer.function());
    }
  }

  // The current location of a block register: a local if this piece has read or written the
  // register; otherwise it is in memory.
  struct Home {
    Staged value{};
    bool isKnown = false, isChanged = false;
  };

  Staged get(CodeWriter& writer, Register r) {
    if (r.isUniform) return Staged(r.number | Staged::sharedFlag);
    Home& home = homes_[r.number];
    if (!home.isKnown) {
      home = {writer.loadFour(spillsAt_ + r.number * std::uint32_t{sizeof(Lanes)}), true};
      writer.releaseAllBut(home.value);
    }
    return home.value;
  }

  void set(CodeWriter& writer, Register r, Staged value) {
    if (r.isUniform) {
      writer.storeOne(value, module_.sharedAt + r.number * std::uint32_t{sizeof(float)});
      return writer.releaseAllBut(Staged(Staged::sharedFlag));
    }
    Home& home = homes_[r.number];
    if (home.isKnown) writer.release(home.value);
    home = {value, true, true};
    writer.releaseAllBut(value);
  }

  void write(CodeWriter& writer, const RegisterInstruction& instruction) {
    const Op op = instruction.op;
    if (op == inputOp) {
      const auto [input, component] = sources_[instruction.input];
      const auto [offset, size, isUniform] = inputs_[input];
      const std::uint32_t place = offset + component * std::uint32_t{sizeof(float)};
      return set(writer, instruction.result,
                 isUniform ? writer.loadOne(place) : writer.load(offset, size, component));
    }
    Operands<Staged> x;
    for (int k = 0; k < arities[index(op)]; ++k) x[k] = get(writer, instruction.operands[k]);
    const Stage stage = stageOf(op);
    set(writer, instruction.result,
        stage ? writer.copyToOwnLocal(stage(x)) : writer.callEachLane(op, x));
  }

  void spill(CodeWriter& writer) {
    for (std::uint32_t i = 0; i < homes_.size(); ++i) {
      if (homes_[i].isChanged)
        writer.storeFour(homes_[i].value, spillsAt_ + i * std::uint32_t{sizeof(Lanes)});
    }
  }

  void writeResults(CodeWriter& writer) {
    auto result = program_.results.begin();
    for (const auto& [offset, size, isUniform] : results_) {
      for (std::uint32_t i = 0; i < size; ++i)
        writer.store(get(writer, *result++), offset, size, i);
    }
  }

  static void callPiece(WasmBytes& code, std::uint32_t function, std::uint32_t position) {
    code.byte(wasm::LocalGet);
    code.number(0);
    code.byte(wasm::LocalGet);
    code.number(position);
    code.byte(wasm::Call);
    code.number(function);
  }

  void writeStart(std::uint32_t first, std::uint32_t end) {
    WasmBytes code;
    code.number(0);
    for (std::uint32_t i = first; i < end; ++i) callPiece(code, i, 1);
    code.byte(wasm::End);
    start_ = wasm_.functionCount();
    wasm_.add(Piece, code);
  }

  // Writes `for (position = 0; position < end; position += 16) …`.
  void writeRun(std::uint32_t first) {
    const std::uint32_t end = start_, position = 2;
    WasmBytes code;
    code.number(1);
    code.number(1);
    code.byte(wasm::i32);
    code.byte(wasm::Loop);
    code.byte(wasm::noResult);
    for (std::uint32_t i = first; i < end; ++i) callPiece(code, i, position);
    code.byte(wasm::LocalGet);
    code.number(position);
    code.byte(wasm::Number);
    code.signedNumber(sizeof(Lanes));
    code.byte(wasm::Add);
    code.byte(wasm::LocalTee);
    code.number(position);
    code.byte(wasm::LocalGet);
    code.number(1);
    code.byte(wasm::Less);
    code.byte(wasm::BranchIf);
    code.number(0);
    code.byte(wasm::End);
    code.byte(wasm::End);
    wasm_.add(Piece, code);
  }

  const RegisterProgram& program_;
  std::span<const Placement> inputs_, results_;
  std::uint32_t spillsAt_, start_ = 0;
  std::vector<Source> sources_;
  std::vector<Home> homes_;
  std::vector<Op> routines_;
  CodeModule module_;
  WasmModule wasm_;
};

}  // namespace

MachineCode machineCode(const RegisterProgram& program, std::span<const Placement> inputs,
                        std::span<const Placement> results, std::uint32_t end) {
  return Generator(program, inputs, results, end).run();
}

}  // namespace warpjet
