// The bindings of the compiler. Calls that happen once per operation are plain exports with numbers
// only; embind binds the others. No exception crosses the border: a problem is a message, which
// JavaScript throws.
#include <emscripten.h>
#include <malloc.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "builder/builder.hpp"
#include "embind.hpp"
#include "emit/text.hpp"
#include "eval/cost.hpp"
#include "eval/phases.hpp"
#include "eval/program.hpp"
#include "frame/frame.hpp"
#include "noise/noise.hpp"
#include "texture/texture.hpp"
#include "warp/warp.hpp"

using namespace warpjet;

// JavaScript's `Session` is a `Builder`. These functions take its address.
extern "C" {

EMSCRIPTEN_KEEPALIVE int constant(Builder* session, double value) {
  return session->constant(value);
}

EMSCRIPTEN_KEEPALIVE void push(Builder* session, int handle) { session->push(handle); }

// Pushes the first `count` of a, b and c, then calls: the border is crossed once per operation
// instead of once per operand.
EMSCRIPTEN_KEEPALIVE int call(Builder* session, int operation, int isMethod, int count, int a,
                              int b, int c) {
  const std::array operands{a, b, c};
  for (int i = 0; i < count; ++i) session->push(operands[i]);
  return session->call(operation, isMethod != 0);
}

EMSCRIPTEN_KEEPALIVE int callFunction(Builder* session, int function) {
  return session->callFunction(function);
}

// Calls a noise. `kind` and `base` are numbers of `NoiseKind`.
EMSCRIPTEN_KEEPALIVE int callNoise(Builder* session, int kind, int base, int octaves,
                                   int isMethod) {
  return session->callNoise({NoiseKind(kind), NoiseKind(base), octaves}, isMethod != 0);
}

EMSCRIPTEN_KEEPALIVE int swizzle(Builder* session, int handle, int count, int indices) {
  return session->swizzle(handle, count, static_cast<unsigned>(indices));
}

// Returns the number of an input in the module.
EMSCRIPTEN_KEEPALIVE std::uint32_t inputOf(Builder* session, int handle) {
  return session->inputOf(handle);
}

// Returns columns and rows, with four bits each.
EMSCRIPTEN_KEEPALIVE int shapeOf(Builder* session, int handle) {
  const Shape shape = session->shape(handle);
  return shape.columns << 4 | shape.rows;
}

}  // extern "C"

namespace {

using Words = std::vector<std::uint32_t>;

// Returns the names of all operations, in the order of their numbers.
std::vector<std::string> operationNames() {
  std::vector<std::string> names;
  for (const Operation& operation : operations) names.emplace_back(operation.name);
  return names;
}

// Returns flags of all operations: bit 0 for methods, bit 1 for those that are listed. Internal
// operations are neither.
std::vector<std::uint8_t> operationFlags() {
  std::vector<std::uint8_t> flags;
  for (const Operation& operation : operations) {
    const bool isMethod = !operation.isInternal && !operation.isConstructor();
    flags.push_back((isMethod ? 1 : 0) | (operation.isInternal ? 0 : 2));
  }
  return flags;
}

// Session

std::uintptr_t addressOf(Builder& session) { return reinterpret_cast<std::uintptr_t>(&session); }

int addInput(Builder& session, std::string_view method, std::string_view label, int columns,
             int rows) {
  return session.input(method, label, matrixOf(columns, rows));
}

int callTexture(Builder& session, std::string_view image, Filter filter, Wrap wrap) {
  return session.callTexture({filter, wrap}, image);
}

int imageSize(Builder& session, std::string_view image) { return session.imageSize(image); }

int addRecorded(Builder& session, std::string_view name, std::uint32_t variables,
                const Words& module) {
  return session.addRecorded(name, variables, module);
}

int warp(Builder& session, std::string_view method, bool needsDirections, bool isFlat) {
  return session.warp(method, {needsDirections, isFlat});
}

// Returns the calls whose partial derivatives are needed.
Words pendingCalls(Builder& session) {
  Words calls;
  for (const NodeId call : session.pendingCalls()) calls.push_back(index(call));
  return calls;
}

int functionOfCall(Builder& session, std::uint32_t call) {
  return session.functionOfCall(NodeId{call});
}

int argumentOfCall(Builder& session, std::uint32_t call, int i) {
  return session.argumentOfCall(NodeId{call}, i);
}

bool setPartials(Builder& session, std::uint32_t call) { return session.setPartials(NodeId{call}); }

// Returns the serialized module; empty if there is a problem.
Words finish(Builder& session) { return session.finish() ? save(session.module()) : Words{}; }

// Module

struct Variable {
  std::string name;
  Shape shape;
  std::uint32_t number;
};

struct Stats {
  std::uint32_t nodes = 0, operations = 0, temporaries = 0, vectors = 0;
};

// The record that JavaScript receives.
struct ShaderTextRecord {
  std::string problem, code = {}, declarations = {};
  std::vector<Variable> inputs = {};  // the inputs that the code reads
  Stats stats = {};
};

// Has neither instructions nor a problem if the program would call a function of the host.
struct CpuProgram {
  std::string problem;
  Words words = {};
  std::uint32_t instructions = 0;
  std::vector<Variable> inputs = {};  // the program takes their numbers in this order
};

Module* openModule(const Words& words) { return new Module(load(words)); }

Variable inputVariable(const Module& module, std::uint32_t number) {
  const Input& input = module.graph.input(number);
  return {input.label, input.shape, number};
}

std::vector<Variable> inputs(const Module& module) {
  std::vector<Variable> all;
  for (std::uint32_t i = 0; i < module.graph.inputCount(); ++i)
    all.push_back(inputVariable(module, i));
  return all;
}

// Returns the inputs that the results depend on.
std::vector<Variable> inputsReadBy(const Module& module, const Words& results) {
  std::vector<Variable> variables;
  for (const std::uint32_t i : inputsRead(module, results))
    variables.push_back(inputVariable(module, i));
  return variables;
}

std::vector<Variable> results(const Module& module) {
  std::vector<Variable> all;
  for (std::uint32_t i = 0; i < module.outputs.size(); ++i)
    all.push_back({module.outputs[i].name, module.outputs[i].shape, i});
  return all;
}

// `frameInputs` are the inputs that are constant during a frame.
std::uint32_t separate(Module& module, const Words& frameInputs) {
  return separateFrame(module, frameInputs);
}

// Pairs the numbers of inputs or results with their names. JavaScript passes two arrays, since a
// record for each pair takes three calls.
std::vector<Naming> namings(const Words& numbers, const std::vector<std::string>& names) {
  std::vector<Naming> all;
  for (std::size_t i = 0; i < numbers.size(); ++i) all.push_back({numbers[i], names[i]});
  return all;
}

// Writes shader code. A `maxDepth` of 0 selects the default.
ShaderTextRecord writeText(const Module& module, std::string_view target, const Words& inputs,
                           const std::vector<std::string>& inputNames, const Words& results,
                           const std::vector<std::string>& resultNames, int maxDepth,
                           bool fadesNoise, bool reflectsAtBorders) {
  ShaderTextOptions options{.results = namings(results, resultNames),
                            .inputs = namings(inputs, inputNames),
                            .fadesNoise = fadesNoise,
                            .reflectsAtBorders = reflectsAtBorders};
  if (maxDepth > 0) options.emit = {maxDepth, EmitOptions::maxTrackedReads};
  ShaderTextResult written = write(module, *findDialect(target), options);
  if (!written.text) return {.problem = written.problem};
  auto& [emitted, declarations, names] = *written.text;
  ShaderTextRecord text{{}, std::move(emitted.code), std::move(declarations)};
  for (auto& [number, name] : names)
    text.inputs.push_back({std::move(name), module.graph.input(number).shape, number});
  text.stats = {
      static_cast<std::uint32_t>(emitted.nodes), static_cast<std::uint32_t>(emitted.operations),
      static_cast<std::uint32_t>(emitted.temporaries), static_cast<std::uint32_t>(emitted.vectors)};
  return text;
}

CpuProgram makeProgram(const Module& module, const Words& wanted) {
  ModuleProgram made = program(module, wanted);
  if (!made.program) return {.problem = made.problem};
  return {{}, std::move(made.program->words), made.program->instructions, inputs(module)};
}

Cost cost(const Module& module, const Words& results) { return costOf(module, results); }

// `fronts` has three numbers for each front: its profile, `first` and `second`.
struct FlatPhases {
  std::vector<Phase> phases;
  std::vector<double> fronts;
};

FlatPhases phases(Module& module, const Words& results, const Words& varying) {
  Phases found = addPhases(module, results, varying);
  FlatPhases flat{std::move(found.phases), {}};
  for (const auto& [profile, first, second] : found.fronts)
    flat.fronts.insert(flat.fronts.end(), {static_cast<double>(profile), first, second});
  return flat;
}

// Returns for each input whether the program reads it. `sizes` has the number of components of each
// input.
std::vector<std::uint8_t> inputsReadByProgram(const Words& words, std::uint32_t instructions,
                                              const Words& sizes) {
  const Program program{words, instructions};
  std::vector<std::uint8_t> all;
  std::uint32_t first = 0;
  for (const std::uint32_t size : sizes) {
    all.push_back(reads(program, first, size));
    first += size;
  }
  return all;
}

std::vector<double> evaluateInDouble(const Words& words, std::uint32_t instructions,
                                     const std::vector<double>& inputs, std::uint32_t resultCount) {
  std::vector<double> results(resultCount);
  evaluate(words, instructions, inputs, results);
  return results;
}

std::uint32_t memoryInUse() { return mallinfo().uordblks; }

template <typename Enum, std::size_t count>
void bindEnum(const char* name, const std::array<std::string_view, count>& names) {
  emscripten::enum_<Enum> bound(name);
  for (std::size_t i = 0; i < count; ++i) bound.value(names[i].data(), Enum(i));
}

}  // namespace

EMSCRIPTEN_BINDINGS(core) {
  using namespace emscripten;

  registerArray<std::uint8_t>();
  registerArray<std::uint32_t>();
  registerArray<double>();
  registerArray<std::string>();
  registerArray<HostText>();
  registerArray<Variable>();
  registerArray<Phase>();

  bindEnum<Filter>("Filter", filterNames);
  bindEnum<Wrap>("Wrap", wrapNames);

  value_array<HostText>("HostText").element(&HostText::family).element(&HostText::text);
  value_array<Shape>("Shape").element(&Shape::columns).element(&Shape::rows);
  value_object<Variable>("Variable")
      .field("name", &Variable::name)
      .field("shape", &Variable::shape)
      .field("number", &Variable::number);
  value_object<Stats>("Stats")
      .field("nodes", &Stats::nodes)
      .field("operations", &Stats::operations)
      .field("temporaries", &Stats::temporaries)
      .field("vectors", &Stats::vectors);
  value_object<ShaderTextRecord>("ShaderText")
      .field("problem", &ShaderTextRecord::problem)
      .field("code", &ShaderTextRecord::code)
      .field("declarations", &ShaderTextRecord::declarations)
      .field("inputs", &ShaderTextRecord::inputs)
      .field("stats", &ShaderTextRecord::stats);
  value_object<CpuProgram>("Program")
      .field("problem", &CpuProgram::problem)
      .field("words", &CpuProgram::words)
      .field("instructions", &CpuProgram::instructions)
      .field("inputs", &CpuProgram::inputs);
  value_object<Phase>("Phase").field("size", &Phase::size).field("step", &Phase::step);
  value_object<FlatPhases>("Phases")
      .field("phases", &FlatPhases::phases)
      .field("fronts", &FlatPhases::fronts);
  value_object<Cost>("Cost")
      .field("operations", &Cost::operations)
      .field("hasNoise", &Cost::hasNoise)
      .field("needsGpu", &Cost::needsGpu);

  class_<Builder>("Session")
      .constructor<>()
      .function("address", &addressOf)
      .function("problem", &Builder::problem)
      .function("input", &addInput)
      .function("callTexture", &callTexture)
      .function("imageSize", &imageSize)
      .function("addFunction", &Builder::addFunction)
      .function("addRecorded", &addRecorded)
      .function("callRecorded", &Builder::callRecorded)
      .function("openRepeat", &Builder::openRepeat)
      .function("closeRepeat", &Builder::closeRepeat)
      .function("dropRepeat", &Builder::dropRepeat)
      .function("pendingCalls", &pendingCalls)
      .function("functionOfCall", &functionOfCall)
      .function("argumentOfCall", &argumentOfCall)
      .function("setPartials", &setPartials)
      .function("comment", &Builder::comment)
      .function("output", &Builder::output)
      .function("warp", &warp)
      .function("finish", &finish);

  class_<Module>("Module")
      .constructor(&openModule, allow_raw_pointers())
      .function("inputs", &inputs)
      .function("inputsRead", &inputsReadBy)
      .function("results", &results)
      .function("separate", &separate)
      .function("write", &writeText)
      .function("program", &makeProgram)
      .function("cost", &cost)
      .function("phases", &phases);

  function("operationNames", &operationNames);
  function("operationFlags", &operationFlags);
  function("inputsRead", &inputsReadByProgram);
  function("evaluate", &evaluateInDouble);
  function("memoryInUse", &memoryInUse);
}
