#include "eval/machine_code.hpp"

#include <algorithm>

#include "eval/code_writer.hpp"
#include "ops/rows.hpp"

namespace warpjet {

namespace {

// A function of so many takes an engine's best compiler some milliseconds.
constexpr std::size_t instructionsPerFunction = 500;

// The types of functions, in the order of the section. The first number is the memory's address.
enum FunctionType : std::uint32_t {
  Piece,     // of the program: that, and 16 times the number of the four vertices
  Kernel,    // of so many operands
  Kernel2,   //
  EachLane,  // the operation and its operands
  Routine,   //
  Routine2,  //
};

template <ops::Type type>
auto typed(Staged x) {
  if constexpr (type == ops::Type::Bool)
    return asMask(x);
  else
    return x;
}

Staged untyped(Staged value) { return value; }
Staged untyped(StagedMask value) { return asLanes(value); }

using Stage = Staged (*)(const Operands<Staged>&);

// Null for what is done on each lane.
template <std::size_t Row>
constexpr Stage stageOf() {
  constexpr auto& signature = ops::declarations[Row].signature;
  if constexpr (signature.hasWhole()) {
    return nullptr;
  } else {
    return ops::numbered<ops::declarations[Row].arity>([](auto... k) -> Stage {
      constexpr const auto& row = std::get<Row>(ops::table);
      using Value = decltype(row.value);
      if constexpr (std::is_invocable_v<
                        Value,
                        decltype(typed<ops::declarations[Row].signature.operands[k]>(Staged()))...>)
        return [](const Operands<Staged>& x) {
          return ops::numbered<ops::declarations[Row].arity>([&](auto... i) {
            return untyped(
                std::get<Row>(ops::table)
                    .value(typed<ops::declarations[Row].signature.operands[i]>(x[i])...));
          });
        };
      else
        return nullptr;
    });
  }
}

constexpr auto stages =
    ops::numbered<ops::count>([](auto... row) { return std::array{stageOf<row>()...}; });

// So many sines and the like stand where they are needed, which saves calls; from more the module
// would grow long, and so each is a function.
constexpr std::size_t mostInline = 16;

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
    const std::uint32_t prologue = functionCount_;
    writePieces(program_.prologue, false);
    const std::uint32_t body = functionCount_;
    writePieces(program_.body, true);
    writeStart(prologue, body);
    writeRun(body);
    return {whole().bytes(), module_.sharedAt, std::move(module_.shared)};
  }

 private:
  struct Source {
    std::uint32_t input, component;
  };

  bool hasPieces() const { return program_.body.size() > instructionsPerFunction; }

  // What the program needs of the interpreter.
  void importKernels() {
    module_.kernels.fill(noFunction);
    module_.routines.fill(noFunction);
    module_.eachLane = import("each_lane", EachLane);
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
    if (uses <= mostInline) routines_.clear();
  }

  static bool isKernel(Op op) {
    return std::find(kernelOps.begin(), kernelOps.end(), op) != kernelOps.end();
  }

  void importKernel(Op op) {
    if (module_.kernels[index(op)] != noFunction) return;
    module_.kernels[index(op)] =
        import(ops::declaration(op).name, arities[index(op)] == 1 ? Kernel : Kernel2);
  }

  std::uint32_t import(std::string_view name, FunctionType type) {
    imports_.text("");
    imports_.text("lanes_", name);
    imports_.byte(wasm::OfFunction);
    imports_.number(type);
    return functionCount_++;
  }

  void add(FunctionType type, const WasmBytes& body) {
    types_.number(type);
    code_.appendCounted(body);
    ++functionCount_;
  }

  void writeRoutines() {
    imported_ = functionCount_;
    for (const Op op : routines_) {
      const std::uint32_t number = functionCount_;
      const bool isUnary = arities[index(op)] == 1;
      CodeWriter writer(module_, 1, isUnary ? 1 : 2);
      writer.give(routineFormula(op, writer.parameter(0), writer.parameter(isUnary ? 0 : 1)));
      add(isUnary ? Routine : Routine2, writer.function());
      module_.routines[index(op)] = number;
    }
  }

  // One function for each so many instructions; the last also writes the results.
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
      add(Piece, writer.function());
    }
  }

  // Where a register of the block is now: a local, unless it was only written by another piece.
  struct Home {
    Staged value{};
    bool isKnown = false, isChanged = false;
  };

  Staged get(CodeWriter& writer, Register r) {
    if (r.isUniform) return Staged(r.number | Staged::isShared);
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
      return writer.releaseAllBut(Staged(Staged::isShared));
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
    const Stage stage = stages[index(op)];
    set(writer, instruction.result, stage ? writer.owned(stage(x)) : writer.callEachLane(op, x));
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

  static void callPiece(WasmBytes& code, std::uint32_t function, std::uint32_t at) {
    code.byte(wasm::LocalGet);
    code.number(0);
    code.byte(wasm::LocalGet);
    code.number(at);
    code.byte(wasm::Call);
    code.number(function);
  }

  void writeStart(std::uint32_t first, std::uint32_t end) {
    WasmBytes code;
    code.number(0);
    for (std::uint32_t i = first; i < end; ++i) callPiece(code, i, 1);
    code.byte(wasm::End);
    start_ = functionCount_;
    add(Piece, code);
  }

  // for (at = 0; at < end; at += 16) …
  void writeRun(std::uint32_t first) {
    const std::uint32_t end = start_, at = 2;
    WasmBytes code;
    code.number(1);
    code.number(1);
    code.byte(wasm::i32);
    code.byte(wasm::Loop);
    code.byte(wasm::noResult);
    for (std::uint32_t i = first; i < end; ++i) callPiece(code, i, at);
    code.byte(wasm::LocalGet);
    code.number(at);
    code.byte(wasm::Number);
    code.signedNumber(sizeof(Lanes));
    code.byte(wasm::Add);
    code.byte(wasm::LocalTee);
    code.number(at);
    code.byte(wasm::LocalGet);
    code.number(1);
    code.byte(wasm::Less);
    code.byte(wasm::BranchIf);
    code.number(0);
    code.byte(wasm::End);
    code.byte(wasm::End);
    add(Piece, code);
  }

  WasmBytes whole() const;

  const RegisterProgram& program_;
  std::span<const Placement> inputs_, results_;
  std::uint32_t spillsAt_, functionCount_ = 0, imported_ = 0, start_ = 0;
  std::vector<Source> sources_;
  std::vector<Home> homes_;
  std::vector<Op> routines_;
  CodeModule module_;
  WasmBytes imports_, types_, code_;
};

void type(WasmBytes& types, std::initializer_list<std::uint8_t> operands, bool hasResult) {
  types.byte(wasm::functionType);
  types.number(static_cast<std::uint32_t>(operands.size()));
  for (const std::uint8_t operand : operands) types.byte(operand);
  types.number(hasResult);
  if (hasResult) types.byte(wasm::v128);
}

WasmBytes Generator::whole() const {
  using namespace wasm;
  WasmBytes module;
  for (const char x : {'\0', 'a', 's', 'm', '\1', '\0', '\0', '\0'})
    module.byte(static_cast<std::uint8_t>(x));

  WasmBytes types;
  types.number(6);
  type(types, {i32, i32}, false);
  type(types, {v128}, true);
  type(types, {v128, v128}, true);
  type(types, {i32, v128, v128, v128}, true);
  type(types, {i32, v128}, true);
  type(types, {i32, v128, v128}, true);
  module.section(Types, types);

  WasmBytes imports;
  imports.number(imported_ + 1);
  imports.append(imports_);
  imports.text("");
  imports.text("memory");
  imports.byte(OfMemory);
  imports.number(0);
  imports.number(0);
  module.section(Imports, imports);

  WasmBytes functions;
  functions.number(functionCount_ - imported_);
  functions.append(types_);
  module.section(Functions, functions);

  WasmBytes exports;
  exports.number(2);
  for (const auto& [name, number] : {std::pair{"start", start_}, {"run", start_ + 1}}) {
    exports.text(name);
    exports.byte(OfFunction);
    exports.number(number);
  }
  module.section(Exports, exports);

  WasmBytes code;
  code.number(functionCount_ - imported_);
  code.append(code_);
  module.section(Code, code);
  return module;
}

}  // namespace

MachineCode machineCode(const RegisterProgram& program, std::span<const Placement> inputs,
                        std::span<const Placement> results, std::uint32_t end) {
  return Generator(program, inputs, results, end).run();
}

}  // namespace warpjet
