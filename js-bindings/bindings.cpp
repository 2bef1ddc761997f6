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
#include "noise/noise.hpp"
#include "texture/texture.hpp"

using namespace warpjet;

namespace {

// One compilation: a builder, and what it gave.
struct Session {
  Builder builder;
  Built built;
  Program program;

  explicit Session(const Dialect& dialect) : builder(dialect) {}
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

// Kinds by their number in noiseNames.
EMSCRIPTEN_KEEPALIVE int callNoise(Session* session, int kind, int base, int octaves,
                                   int isMethod) {
  return session->builder.callNoise({NoiseKind(kind), NoiseKind(base), octaves}, isMethod != 0);
}

EMSCRIPTEN_KEEPALIVE int callTexture(Session* session, int filter, int wrap) {
  return session->builder.callTexture({Filter(filter), Wrap(wrap)});
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

EMSCRIPTEN_KEEPALIVE int dependsOn(Session* session, int handle, int input) {
  return session->builder.dependsOn(handle, input);
}

// Columns and rows, four bits each.
EMSCRIPTEN_KEEPALIVE int shapeOf(Session* session, int handle) {
  const Shape shape = session->builder.shape(handle);
  return shape.columns << 4 | shape.rows;
}

EMSCRIPTEN_KEEPALIVE int nodeCount(Session* session) {
  return static_cast<int>(session->built.emitted.nodes);
}

EMSCRIPTEN_KEEPALIVE int operationCount(Session* session) {
  return static_cast<int>(session->built.emitted.operations);
}

EMSCRIPTEN_KEEPALIVE int temporaryCount(Session* session) {
  return static_cast<int>(session->built.emitted.temporaries);
}

// Makes the program that gives the values pushed. Whether there can be one.
EMSCRIPTEN_KEEPALIVE int makeProgram(Session* session) {
  auto program = session->builder.program();
  if (program) session->program = std::move(*program);
  return program.has_value();
}

EMSCRIPTEN_KEEPALIVE const std::uint32_t* programWords(Session* session) {
  return session->program.words.data();
}

EMSCRIPTEN_KEEPALIVE int programSize(Session* session) {
  return static_cast<int>(session->program.words.size());
}

EMSCRIPTEN_KEEPALIVE int instructionCount(Session* session) {
  return static_cast<int>(session->program.instructions);
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

EMSCRIPTEN_KEEPALIVE void closeSession(Session* session) { delete session; }

// Bytes that are allocated now.
EMSCRIPTEN_KEEPALIVE int memoryInUse() {
  return static_cast<int>(emmalloc_dynamic_heap_size() - emmalloc_free_dynamic_memory());
}

}  // extern "C"

namespace {

using Address = std::uintptr_t;

Session& at(Address session) { return *reinterpret_cast<Session*>(session); }

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

// A session, or 0 if there is no such dialect.
Address open(const std::string& target) {
  const Dialect* dialect = findDialect(target);
  return dialect ? reinterpret_cast<Address>(new Session(*dialect)) : 0;
}

std::string problem(Address session) { return at(session).builder.problem(); }

int input(Address session, const std::string& method, const std::string& label, int columns,
          int rows) {
  return at(session).builder.input(method, label, matrixOf(columns, rows));
}

int addFunction(Address session, const std::string& name, const std::string& source, int arity) {
  return at(session).builder.addFunction(name, source, arity);
}

void comment(Address session, const std::string& text) { at(session).builder.comment(text); }

bool output(Address session, const std::string& method, const std::string& name, int handle) {
  return at(session).builder.output(method, name, handle);
}

bool outputSum(Address session, const std::string& method, const std::string& name, int handle,
               int input, int term) {
  return at(session).builder.outputSum(method, name, handle, input, term);
}

// Whether there is a text. A depth of 0 leaves it to us.
bool buildText(Address session, int maxDepth) {
  auto built = at(session).builder.build(maxDepth > 0 ? std::optional(maxDepth) : std::nullopt);
  if (built) at(session).built = std::move(*built);
  return built.has_value();
}

std::string code(Address session) { return at(session).built.emitted.code; }
std::string declarations(Address session) { return at(session).built.declarations; }

// Columns, rows and name.
std::string line(Shape shape, const std::string& name) {
  return std::to_string(shape.columns) + std::to_string(shape.rows) + name + '\n';
}

std::string line(const Session& session, std::uint32_t input) {
  const auto& [label, shape] = session.builder.graph().input(input);
  return line(shape, label);
}

// The host's expressions that the text reads, a line each.
std::string inputLines(Address session) {
  std::string lines;
  for (const std::uint32_t i : at(session).built.emitted.inputs) lines += line(at(session), i);
  return lines;
}

// All that there are, in the order in which a program wants their numbers.
std::string allInputLines(Address session) {
  std::string lines;
  for (std::uint32_t i = 0; i < at(session).builder.graph().inputCount(); ++i)
    lines += line(at(session), i);
  return lines;
}

std::string outputLines(Address session) {
  std::string lines;
  for (const Output& output : at(session).builder.outputs())
    lines += line(output.shape, output.name);
  return lines;
}

}  // namespace

EMSCRIPTEN_BINDINGS(warpjet) {
  // The only type that needs a conversion, in core-module.ts. Without libembind nobody else tells
  // of it.
  emscripten::internal::_embind_register_std_string(
      emscripten::internal::TypeID<std::string>::get(), "std::string");
  emscripten::function("operationNames", &operationNames);
  emscripten::function("open", &open);
  emscripten::function("problem", &problem);
  emscripten::function("input", &input);
  emscripten::function("addFunction", &addFunction);
  emscripten::function("comment", &comment);
  emscripten::function("output", &output);
  emscripten::function("outputSum", &outputSum);
  emscripten::function("build", &buildText);
  emscripten::function("code", &code);
  emscripten::function("declarations", &declarations);
  emscripten::function("inputLines", &inputLines);
  emscripten::function("allInputLines", &allInputLines);
  emscripten::function("outputLines", &outputLines);
}
