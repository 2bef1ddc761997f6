// The border to JavaScript. What happens once per operation is plain C with numbers only, since an
// embind call with objects costs forty times as much; what happens once per warp goes through
// embind. No exception crosses: a problem is a sentence, and the JavaScript side throws it.
#include <emscripten.h>
#include <emscripten/bind.h>
#include <emscripten/emmalloc.h>

#include <string>
#include <vector>

#include "diff/differentiator.hpp"
#include "emit/dialect.hpp"
#include "emit/emit.hpp"
#include "emit/names.hpp"
#include "graph/graph.hpp"
#include "graph/reachable.hpp"
#include "warp/warp.hpp"

using emscripten::val;
using namespace warpjet;

namespace {

// One compilation: a graph, its derivatives and the language to write.
struct Session {
  Graph graph;
  Differentiator differentiator{graph};
  const Dialect& dialect;

  explicit Session(const Dialect& dialect) : dialect(dialect) {}
};

// Returned instead of a node id.
constexpr int notFinite = -1;
constexpr int graphFull = -2;

int toNumber(const Session& session, NodeId id) {
  return session.graph.full() ? graphFull : static_cast<int>(index(id));
}

NodeId toNode(int id) { return NodeId{static_cast<std::uint32_t>(id)}; }

Session& toSession(std::uintptr_t session) { return *reinterpret_cast<Session*>(session); }

// An operation on constants that folding left alone, since its result is not a finite float32, or a
// division by a constant zero.
bool isUnfolded(const Graph& graph, NodeId id) {
  if (graph.isLeaf(id) || graph.known(id)) return false;
  const bool divides = graph.is(id, ops::find("div")) || graph.is(id, ops::find("mod"));
  if (divides && graph.isConstant(graph.operand(id, 1), 0)) return true;
  for (int i = 0; i < graph.arity(id); ++i) {
    if (!graph.known(graph.operand(id, i))) return false;
  }
  return true;
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE int constant(Session* session, double value) {
  return toNumber(*session, session->graph.constant(value));
}

EMSCRIPTEN_KEEPALIVE int component(Session* session, int input, int component) {
  return toNumber(*session, session->graph.component(static_cast<std::uint32_t>(input), component));
}

EMSCRIPTEN_KEEPALIVE int apply(Session* session, int op, int a, int b, int c) {
  const NodeId id = session->graph.apply(static_cast<Op>(op), {toNode(a), toNode(b), toNode(c)});
  return isUnfolded(session->graph, id) ? notFinite : toNumber(*session, id);
}

EMSCRIPTEN_KEEPALIVE int derivative(Session* session, int root, int input) {
  return toNumber(*session, session->differentiator.derivative(toNode(root), toNode(input)));
}

EMSCRIPTEN_KEEPALIVE void closeSession(Session* session) { delete session; }

// Bytes that are allocated now.
EMSCRIPTEN_KEEPALIVE int memoryInUse() {
  return static_cast<int>(emmalloc_dynamic_heap_size() - emmalloc_free_dynamic_memory());
}

}  // extern "C"

namespace {

// The rows of the table, in their order.
val operations() {
  val rows = val::array();
  for (const ops::Info& info : ops::infos) {
    val row = val::object();
    row.set("name", std::string(info.name));
    row.set("arity", info.arity);
    rows.call<void>("push", row);
  }
  return rows;
}

// A session, or 0 if there is no such dialect.
std::uintptr_t open(const std::string& target) {
  const Dialect* dialect = findDialect(target);
  return dialect ? reinterpret_cast<std::uintptr_t>(new Session(*dialect)) : 0;
}

// What is wrong with a host's expression, or nothing.
std::string inputProblemOf(std::uintptr_t session, const std::string& expression) {
  return inputProblem(toSession(session).dialect, expression);
}

std::string outputProblemOf(std::uintptr_t session, const std::string& name) {
  return outputProblem(toSession(session).dialect, name);
}

int input(std::uintptr_t session, const std::string& expression, int size) {
  return static_cast<int>(toSession(session).graph.input(expression, size));
}

Vec3 toVec3(const val& ids) {
  return {toNode(ids[0].as<int>()), toNode(ids[1].as<int>()), toNode(ids[2].as<int>())};
}

val toArray(const Vec3& ids) {
  val array = val::array();
  for (const NodeId id : ids) array.call<void>("push", static_cast<int>(index(id)));
  return array;
}

val positionOf(std::uintptr_t session, const val& position, const val& offset) {
  return toArray(warpedPosition(toSession(session).graph, toVec3(position), toVec3(offset)));
}

val normalOf(std::uintptr_t session, const val& position, const val& normal, const val& offset) {
  Session& at = toSession(session);
  return toArray(
      warpedNormal(at.differentiator, at.graph, toVec3(position), toVec3(normal), toVec3(offset)));
}

// From { name, ids, sum?: { input, output } }.
Output toOutput(const val& from) {
  Output output{from["name"].as<std::string>(), {}};
  const int size = from["ids"]["length"].as<int>();
  for (int i = 0; i < size; ++i) output.components.push_back(toNode(from["ids"][i].as<int>()));
  if (const val sum = from["sum"]; !sum.isUndefined())
    output.sum = {sum["input"].as<std::uint32_t>(), sum["output"].as<unsigned>()};
  return output;
}

// A derivative can need an operation on constants that `apply` never saw.
int problemOf(const Graph& graph, const std::vector<Output>& outputs) {
  if (graph.full()) return graphFull;
  std::vector<NodeId> roots;
  for (const Output& output : outputs)
    roots.insert(roots.end(), output.components.begin(), output.components.end());
  for (const NodeId id : reachable(graph, roots)) {
    if (isUnfolded(graph, id)) return notFinite;
  }
  return 0;
}

// `comments` holds pairs of a node and a line, in the order of the nodes.
val emitCode(std::uintptr_t session, const val& outputs, int maxDepth, const val& comments) {
  const Session& at = toSession(session);
  val result = val::object();
  std::vector<Output> roots;
  const int count = outputs["length"].as<int>();
  for (int i = 0; i < count; ++i) roots.push_back(toOutput(outputs[i]));
  EmitOptions options{maxDepth};
  const int lines = comments["length"].as<int>();
  for (int i = 0; i < lines; ++i)
    options.comments.emplace_back(toNode(comments[i][0].as<int>()),
                                  comments[i][1].as<std::string>());

  if (const int problem = problemOf(at.graph, roots); problem != 0) {
    result.set("problem", problem);
    return result;
  }
  const Emitted emitted = emit(at.graph, roots, options);
  val inputs = val::array();
  for (const std::uint32_t input : emitted.inputs) inputs.call<void>("push", input);
  result.set("code", emitted.code);
  result.set("inputs", inputs);
  result.set("nodes", emitted.nodes);
  result.set("operations", emitted.operations);
  result.set("temporaries", emitted.temporaries);
  return result;
}

}  // namespace

EMSCRIPTEN_BINDINGS(warpjet) {
  emscripten::function("operations", &operations);
  emscripten::function("open", &open);
  emscripten::function("input", &input);
  emscripten::function("inputProblem", &inputProblemOf);
  emscripten::function("outputProblem", &outputProblemOf);
  emscripten::function("warpedPosition", &positionOf);
  emscripten::function("warpedNormal", &normalOf);
  emscripten::function("emit", &emitCode);
}
