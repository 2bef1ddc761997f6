// The border to JavaScript. What happens once per operation is plain C with numbers only, since an
// embind call with texts costs forty times as much; what happens once per warp or name goes through
// embind. No exception crosses: a problem is a sentence, and the JavaScript side throws it.
#include <emscripten.h>
#include <emscripten/bind.h>
#include <emscripten/emmalloc.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>

#include "builder/builder.hpp"
#include "emit/text.hpp"
#include "eval/program.hpp"
#include "noise/noise.hpp"
#include "texture/texture.hpp"
#include "warp/warp.hpp"

using namespace warpjet;

namespace {

// One run of a sketch's function: a builder, and the words of its module in the end. The sources of
// a function of the host come one by one.
struct Session {
  Builder builder;
  std::vector<HostText> sources;
  std::vector<std::uint32_t> kept;
};

// A module that was kept, how its host names things, and what was made of it.
struct Reading {
  Module module;
  TextOptions options;
  std::vector<std::uint32_t> results;
  Text text;
  Program program;
  std::string problem;
};

NodeId toNode(int id) { return NodeId{static_cast<std::uint32_t>(id)}; }

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE int constant(Session* session, double value) {
  return session->builder.constant(value);
}

EMSCRIPTEN_KEEPALIVE void push(Session* session, int handle) { session->builder.push(handle); }

EMSCRIPTEN_KEEPALIVE int call(Session* session, int operation, int isMethod) {
  return session->builder.call(operation, isMethod != 0);
}

EMSCRIPTEN_KEEPALIVE int callFunction(Session* session, int function) {
  return session->builder.callFunction(function);
}

// Kinds by the number of their row.
EMSCRIPTEN_KEEPALIVE int callNoise(Session* session, int kind, int base, int octaves,
                                   int isMethod) {
  return session->builder.callNoise({NoiseKind(kind), NoiseKind(base), octaves}, isMethod != 0);
}

EMSCRIPTEN_KEEPALIVE int swizzle(Session* session, int handle, int count, int indices) {
  return session->builder.swizzle(handle, count, static_cast<unsigned>(indices));
}

// The calls whose partial derivatives are needed, by their place.
EMSCRIPTEN_KEEPALIVE int pendingCount(Session* session) {
  return static_cast<int>(session->builder.pendingCalls().size());
}

EMSCRIPTEN_KEEPALIVE int pendingCall(Session* session, int place) {
  return static_cast<int>(index(session->builder.pendingCalls()[place]));
}

EMSCRIPTEN_KEEPALIVE int functionOfCall(Session* session, int call) {
  return session->builder.functionOfCall(toNode(call));
}

EMSCRIPTEN_KEEPALIVE int argumentOfCall(Session* session, int call, int i) {
  return session->builder.argumentOfCall(toNode(call), i);
}

EMSCRIPTEN_KEEPALIVE int setPartials(Session* session, int call) {
  return session->builder.setPartials(toNode(call));
}

// The number of an input, by its value.
EMSCRIPTEN_KEEPALIVE int inputOf(Session* session, int handle) {
  return static_cast<int>(session->builder.inputOf(handle));
}

// Whether there is a module to keep.
EMSCRIPTEN_KEEPALIVE int finish(Session* session) {
  const bool isFine = session->builder.finish();
  if (isFine) session->kept = save(session->builder.module());
  return isFine;
}

EMSCRIPTEN_KEEPALIVE const std::uint32_t* keptWords(Session* session) {
  return session->kept.data();
}

EMSCRIPTEN_KEEPALIVE int keptSize(Session* session) {
  return static_cast<int>(session->kept.size());
}

// Columns and rows, four bits each.
EMSCRIPTEN_KEEPALIVE int shapeOf(Session* session, int handle) {
  const Shape shape = session->builder.shape(handle);
  return shape.columns << 4 | shape.rows;
}

EMSCRIPTEN_KEEPALIVE void closeSession(Session* session) { delete session; }

// Reads words that were kept, which the caller laid into memory.
EMSCRIPTEN_KEEPALIVE Reading* openReading(const std::uint32_t* words, int size) {
  return new Reading{.module = load({words, static_cast<std::size_t>(size)})};
}

EMSCRIPTEN_KEEPALIVE void closeReading(Reading* reading) { delete reading; }

EMSCRIPTEN_KEEPALIVE int nodeCount(Reading* reading) {
  return static_cast<int>(reading->text.emitted.nodes);
}

EMSCRIPTEN_KEEPALIVE int operationCount(Reading* reading) {
  return static_cast<int>(reading->text.emitted.operations);
}

EMSCRIPTEN_KEEPALIVE int temporaryCount(Reading* reading) {
  return static_cast<int>(reading->text.emitted.temporaries);
}

// Asks for one more result in the program, by number.
EMSCRIPTEN_KEEPALIVE void wantResult(Reading* reading, int number) {
  reading->results.push_back(static_cast<std::uint32_t>(number));
}

// Whether there is a program of these.
EMSCRIPTEN_KEEPALIVE int makeProgram(Reading* reading) {
  auto made = program(reading->module, reading->results);
  reading->problem = made.problem;
  if (made.program) reading->program = std::move(*made.program);
  return made.program.has_value();
}

EMSCRIPTEN_KEEPALIVE const std::uint32_t* programWords(Reading* reading) {
  return reading->program.words.data();
}

EMSCRIPTEN_KEEPALIVE int programSize(Reading* reading) {
  return static_cast<int>(reading->program.words.size());
}

EMSCRIPTEN_KEEPALIVE int instructionCount(Reading* reading) {
  return static_cast<int>(reading->program.instructions);
}

// Runs a program that the caller laid into memory.
EMSCRIPTEN_KEEPALIVE void run(const std::uint32_t* words, int size, int instructions,
                              const double* inputs, int inputCount, double* results,
                              int resultCount) {
  evaluate({words, static_cast<std::size_t>(size)}, static_cast<std::uint32_t>(instructions),
           {inputs, static_cast<std::size_t>(inputCount)},
           {results, static_cast<std::size_t>(resultCount)});
}

EMSCRIPTEN_KEEPALIVE void* allocate(int bytes) {
  return std::malloc(static_cast<std::size_t>(bytes));
}

EMSCRIPTEN_KEEPALIVE void release(void* memory) { std::free(memory); }

// Bytes that are allocated now.
EMSCRIPTEN_KEEPALIVE int memoryInUse() {
  return static_cast<int>(emmalloc_dynamic_heap_size() - emmalloc_free_dynamic_memory());
}

}  // extern "C"

namespace {

using Address = std::uintptr_t;

Session& at(Address session) { return *reinterpret_cast<Session*>(session); }
Reading& read(Address reading) { return *reinterpret_cast<Reading*>(reading); }

// The names of all operations in the order of their numbers; of constructors with a `+` before it.
std::string operationNames() {
  std::string names;
  for (const Operation& operation : operations) {
    if (!names.empty()) names += ' ';
    if (operation.isConstructor()) names += '+';
    names += operation.name;
  }
  return names;
}

// The names of all languages, the one first that counts unless another is asked for, each with what
// glsl.fn calls its sources.
std::string languageNames() {
  std::string names;
  for (const Dialect* dialect : dialects()) {
    names += dialect->name;
    names += ' ';
    names += dialect->sourceKey;
    names += '\n';
  }
  return names;
}

Address open() { return reinterpret_cast<Address>(new Session); }

std::string problem(Address session) { return at(session).builder.problem(); }

int input(Address session, const std::string& method, const std::string& label, int columns,
          int rows) {
  return at(session).builder.input(method, label, matrixOf(columns, rows));
}

int callTexture(Address session, const std::string& image, int filter, int wrap) {
  return at(session).builder.callTexture({Filter(filter), Wrap(wrap)}, image);
}

void addSource(Address session, const std::string& family, const std::string& text) {
  at(session).sources.push_back({family, text});
}

int addFunction(Address session, const std::string& name, int arity) {
  return at(session).builder.addFunction(name, std::exchange(at(session).sources, {}), arity);
}

void comment(Address session, const std::string& text) { at(session).builder.comment(text); }

void output(Address session, const std::string& method, const std::string& name, int handle) {
  at(session).builder.output(method, name, handle);
}

// Of the values pushed; see Builder::warp.
int warp(Address session, const std::string& method, bool turns, bool isFlat) {
  return at(session).builder.warp(method, {turns, isFlat});
}

void nameInput(Address reading, int number, const std::string& text) {
  read(reading).options.inputs.push_back({static_cast<std::uint32_t>(number), text});
}

void nameResult(Address reading, int number, const std::string& text) {
  read(reading).options.results.push_back({static_cast<std::uint32_t>(number), text});
}

// Whether there is a text. A depth of 0 leaves it to us.
bool writeText(Address reading, const std::string& target, int maxDepth) {
  Reading& to = read(reading);
  if (maxDepth > 0) to.options.emit = {maxDepth, EmitOptions::mostReads};
  Written written = write(to.module, *findDialect(target), to.options);
  to.problem = written.problem;
  if (written.text) to.text = std::move(*written.text);
  return written.text.has_value();
}

std::string readingProblem(Address reading) { return read(reading).problem; }
std::string code(Address reading) { return read(reading).text.emitted.code; }
std::string declarations(Address reading) { return read(reading).text.declarations; }

// Columns, rows, number and name.
std::string line(Shape shape, std::uint32_t number, const std::string& name) {
  return std::to_string(shape.columns) + ' ' + std::to_string(shape.rows) + ' ' +
         std::to_string(number) + ' ' + name + '\n';
}

// The host's expressions that the text reads, a line each.
std::string inputLines(Address reading) {
  std::string lines;
  for (const auto& [number, text] : read(reading).text.inputs)
    lines += line(read(reading).module.graph.input(number).shape, number, text);
  return lines;
}

// All that there are, in the order in which a program wants their numbers.
std::string allInputLines(Address reading) {
  const Graph& graph = read(reading).module.graph;
  std::string lines;
  for (std::uint32_t i = 0; i < graph.inputCount(); ++i)
    lines += line(graph.input(i).shape, i, graph.input(i).label);
  return lines;
}

std::string outputLines(Address reading) {
  std::string lines;
  for (std::uint32_t i = 0; i < read(reading).module.outputs.size(); ++i) {
    const Output& output = read(reading).module.outputs[i];
    lines += line(output.shape, i, output.name);
  }
  return lines;
}

}  // namespace

EMSCRIPTEN_BINDINGS(warpjet) {
  // The only type that needs a conversion, in core-module.ts. Without libembind nobody else tells
  // of it.
  emscripten::internal::_embind_register_std_string(
      emscripten::internal::TypeID<std::string>::get(), "std::string");
  emscripten::function("operationNames", &operationNames);
  emscripten::function("languageNames", &languageNames);
  emscripten::function("open", &open);
  emscripten::function("problem", &problem);
  emscripten::function("input", &input);
  emscripten::function("callTexture", &callTexture);
  emscripten::function("addSource", &addSource);
  emscripten::function("addFunction", &addFunction);
  emscripten::function("comment", &comment);
  emscripten::function("output", &output);
  emscripten::function("warp", &warp);
  emscripten::function("nameInput", &nameInput);
  emscripten::function("nameResult", &nameResult);
  emscripten::function("write", &writeText);
  emscripten::function("readingProblem", &readingProblem);
  emscripten::function("code", &code);
  emscripten::function("declarations", &declarations);
  emscripten::function("inputLines", &inputLines);
  emscripten::function("allInputLines", &allInputLines);
  emscripten::function("outputLines", &outputLines);
}
