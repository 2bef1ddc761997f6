// The border to JavaScript: plain C. What happens once per operation has numbers only; texts, once
// per warp or name, are strings that the JavaScript side makes before a call and releases after it.
// No exception crosses: a problem is a sentence, and the JavaScript side throws it.
#include <emscripten.h>
#include <emscripten/emmalloc.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>

#include "builder/builder.hpp"
#include "emit/text.hpp"
#include "eval/program.hpp"
#include "frame/frame.hpp"
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
  std::vector<std::uint32_t> results, known;
  Text text;
  Program program;
  std::string problem;
};

NodeId toNode(int id) { return NodeId{static_cast<std::uint32_t>(id)}; }

// Whoever asked releases it.
const std::string* told(std::string text) { return new std::string(std::move(text)); }

// Columns, rows, number and name.
std::string line(Shape shape, std::uint32_t number, const std::string& name) {
  return std::to_string(shape.columns) + ' ' + std::to_string(shape.rows) + ' ' +
         std::to_string(number) + ' ' + name + '\n';
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE std::string* makeText(int size) {
  return new std::string(static_cast<std::size_t>(size), '\0');
}

EMSCRIPTEN_KEEPALIVE const char* textAddress(const std::string* text) { return text->data(); }

EMSCRIPTEN_KEEPALIVE int textSize(const std::string* text) {
  return static_cast<int>(text->size());
}

EMSCRIPTEN_KEEPALIVE void releaseText(const std::string* text) { delete text; }

// The names of all operations in the order of their numbers; with a `+` before
// it of what is no method, and a `-` of what only shader text calls.
EMSCRIPTEN_KEEPALIVE const std::string* operationNames() {
  std::string names;
  for (const Operation& operation : operations) {
    if (!names.empty()) names += ' ';
    if (operation.isForText) {
      names += '-';
    } else if (operation.isConstructor()) {
      names += '+';
    }
    names += operation.name;
  }
  return told(names);
}

EMSCRIPTEN_KEEPALIVE Session* openSession() { return new Session; }

EMSCRIPTEN_KEEPALIVE int constant(Session* session, double value) {
  return session->builder.constant(value);
}

EMSCRIPTEN_KEEPALIVE void push(Session* session, int handle) { session->builder.push(handle); }

// Pushes the first `count` of a, b and c, then calls: the border is crossed once per operation, and
// not for each operand too.
EMSCRIPTEN_KEEPALIVE int call(Session* session, int operation, int isMethod, int count, int a,
                              int b, int c) {
  const std::array operands{a, b, c};
  for (int i = 0; i < count; ++i) session->builder.push(operands[i]);
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

// See Builder::addRecorded; the caller laid the words into memory.
EMSCRIPTEN_KEEPALIVE int addRecorded(Session* session, const std::string* name, int variables,
                                     const std::uint32_t* words, int size) {
  return session->builder.addRecorded(*name, static_cast<std::uint32_t>(variables),
                                      {words, static_cast<std::size_t>(size)});
}

EMSCRIPTEN_KEEPALIVE int callRecorded(Session* session, int function) {
  return session->builder.callRecorded(function);
}

// See Builder::openRepeat.
EMSCRIPTEN_KEEPALIVE int openRepeat(Session* session, int steps) {
  return session->builder.openRepeat(steps);
}

EMSCRIPTEN_KEEPALIVE int closeRepeat(Session* session) { return session->builder.closeRepeat(); }

EMSCRIPTEN_KEEPALIVE void dropRepeat(Session* session) { session->builder.dropRepeat(); }

EMSCRIPTEN_KEEPALIVE int swizzle(Session* session, int handle, int count, int indices) {
  return session->builder.swizzle(handle, count, static_cast<unsigned>(indices));
}

EMSCRIPTEN_KEEPALIVE const std::string* problem(Session* session) {
  return told(session->builder.problem());
}

EMSCRIPTEN_KEEPALIVE int input(Session* session, const std::string* method,
                               const std::string* label, int columns, int rows) {
  return session->builder.input(*method, *label, matrixOf(columns, rows));
}

EMSCRIPTEN_KEEPALIVE int callTexture(Session* session, const std::string* image, int filter,
                                     int wrap) {
  return session->builder.callTexture({Filter(filter), Wrap(wrap)}, *image);
}

EMSCRIPTEN_KEEPALIVE void addSource(Session* session, const std::string* family,
                                    const std::string* text) {
  session->sources.push_back({*family, *text});
}

EMSCRIPTEN_KEEPALIVE int addFunction(Session* session, const std::string* name, int arity) {
  return session->builder.addFunction(*name, std::exchange(session->sources, {}), arity);
}

EMSCRIPTEN_KEEPALIVE void comment(Session* session, const std::string* text) {
  session->builder.comment(*text);
}

EMSCRIPTEN_KEEPALIVE void output(Session* session, const std::string* method,
                                 const std::string* name, int handle) {
  session->builder.output(*method, *name, handle);
}

// Of the values pushed; see Builder::warp.
EMSCRIPTEN_KEEPALIVE int warp(Session* session, const std::string* method, int turns, int isFlat) {
  return session->builder.warp(*method, {turns != 0, isFlat != 0});
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

EMSCRIPTEN_KEEPALIVE void nameInput(Reading* reading, int number, const std::string* text) {
  reading->options.inputs.push_back({static_cast<std::uint32_t>(number), *text});
}

EMSCRIPTEN_KEEPALIVE void nameResult(Reading* reading, int number, const std::string* text) {
  reading->options.results.push_back({static_cast<std::uint32_t>(number), *text});
}

// One more input that is the same for a frame and known to the host, by number.
EMSCRIPTEN_KEEPALIVE void knowInput(Reading* reading, int number) {
  reading->known.push_back(static_cast<std::uint32_t>(number));
}

// How many vec4s the host is to compute once a frame, which the last result gives.
EMSCRIPTEN_KEEPALIVE int separate(Reading* reading) {
  return static_cast<int>(separateFrame(reading->module, reading->known));
}

// Whether there is a text. A depth of 0 leaves it to us.
EMSCRIPTEN_KEEPALIVE int writeText(Reading* reading, const std::string* target, int maxDepth) {
  if (maxDepth > 0) reading->options.emit = {maxDepth, EmitOptions::mostReads};
  Written written = write(reading->module, *findDialect(*target), reading->options);
  reading->problem = written.problem;
  if (written.text) reading->text = std::move(*written.text);
  return written.text.has_value();
}

EMSCRIPTEN_KEEPALIVE const std::string* readingProblem(Reading* reading) {
  return told(reading->problem);
}
EMSCRIPTEN_KEEPALIVE const std::string* code(Reading* reading) {
  return told(reading->text.emitted.code);
}
EMSCRIPTEN_KEEPALIVE const std::string* declarations(Reading* reading) {
  return told(reading->text.declarations);
}

// The host's expressions that the text reads, a line each.
EMSCRIPTEN_KEEPALIVE const std::string* inputLines(Reading* reading) {
  std::string lines;
  for (const auto& [number, text] : reading->text.inputs)
    lines += line(reading->module.graph.input(number).shape, number, text);
  return told(lines);
}

// All that there are, in the order in which a program wants their numbers.
EMSCRIPTEN_KEEPALIVE const std::string* allInputLines(Reading* reading) {
  const Graph& graph = reading->module.graph;
  std::string lines;
  for (std::uint32_t i = 0; i < graph.inputCount(); ++i)
    lines += line(graph.input(i).shape, i, graph.input(i).label);
  return told(lines);
}

// The inputs that the wanted results depend on.
EMSCRIPTEN_KEEPALIVE const std::string* readInputLines(Reading* reading) {
  std::string lines;
  for (const std::uint32_t i : inputsRead(reading->module, reading->results))
    lines += line(reading->module.graph.input(i).shape, i, reading->module.graph.input(i).label);
  return told(lines);
}

EMSCRIPTEN_KEEPALIVE const std::string* outputLines(Reading* reading) {
  std::string lines;
  for (std::uint32_t i = 0; i < reading->module.outputs.size(); ++i) {
    const Output& output = reading->module.outputs[i];
    lines += line(output.shape, i, output.name);
  }
  return told(lines);
}

EMSCRIPTEN_KEEPALIVE int nodeCount(Reading* reading) {
  return static_cast<int>(reading->text.emitted.nodes);
}

EMSCRIPTEN_KEEPALIVE int operationCount(Reading* reading) {
  return static_cast<int>(reading->text.emitted.operations);
}

EMSCRIPTEN_KEEPALIVE int temporaryCount(Reading* reading) {
  return static_cast<int>(reading->text.emitted.temporaries);
}

EMSCRIPTEN_KEEPALIVE int vectorCount(Reading* reading) {
  return static_cast<int>(reading->text.emitted.vectors);
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

// Tells whether the program reads any of `count` input numbers from `first` on.
EMSCRIPTEN_KEEPALIVE int programReads(Reading* reading, int first, int count) {
  return reads(reading->program, static_cast<std::uint32_t>(first),
               static_cast<std::uint32_t>(count));
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
