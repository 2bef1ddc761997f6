// The expression graph: takes operations, returns interned and constant-folded scalar nodes.
//
// Every node is one float, bool or int, except images, argument lists, calls of our functions
// (which only calls and results read) and the parts of folds. A vec3 is three ids, held by the code
// that needs a vector. Equal nodes are the same node, so a value and its derivatives share their
// work. Operands always have smaller ids than their users, so ascending ids are a topological order
// and nothing recurses by graph depth. The graph knows nothing of shaders: an input is a label and
// a component, a function of the host is a name.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "graph/none.hpp"
#include "graph/shape.hpp"
#include "ops/ops.hpp"

namespace warpjet {

enum class NodeId : std::uint32_t {};

// Stands for an absent node.
inline constexpr NodeId noNode{none};

constexpr std::uint32_t index(NodeId id) { return static_cast<std::uint32_t>(id); }
constexpr std::size_t index(Op op) { return static_cast<std::size_t>(op); }

// Node kinds that are not rows of the operation table, numbered after its rows: two kinds of
// leaves, a function call (whose arguments are a list), and one result of a call that has several.
// Folds (loops) add four more kinds: see graph/folds.hpp.
inline constexpr Op constantOp{static_cast<std::uint8_t>(ops::count)};
inline constexpr Op inputOp{static_cast<std::uint8_t>(ops::count + 1)};
inline constexpr Op callOp{static_cast<std::uint8_t>(ops::count + 2)};
inline constexpr Op listOp{static_cast<std::uint8_t>(ops::count + 3)};
inline constexpr Op resultOp{static_cast<std::uint8_t>(ops::count + 4)};
inline constexpr Op localOp{static_cast<std::uint8_t>(ops::count + 5)};
inline constexpr Op stateOp{static_cast<std::uint8_t>(ops::count + 6)};
inline constexpr Op foldOp{static_cast<std::uint8_t>(ops::count + 7)};
inline constexpr Op outcomeOp{static_cast<std::uint8_t>(ops::count + 8)};

// The number of each operation's operands that are nodes.
inline constexpr auto arities = [] {
  std::array<std::uint8_t, ops::count + 9> all{};
  for (std::size_t i = 0; i < ops::count; ++i)
    all[i] = static_cast<std::uint8_t>(ops::declarations[i].arity);
  all[index(callOp)] = 1;
  all[index(listOp)] = 2;
  all[index(resultOp)] = 1;
  all[index(stateOp)] = 3;
  all[index(foldOp)] = 1;
  all[index(outcomeOp)] = 2;
  return all;
}();

// 16 bytes. A constant stores the bits of its double in the first two operands; an input stores its
// number and its component. A call stores its arguments and then its function's number; several
// arguments are a list node of all but the last argument, and the last. A result stores its call
// and its number within the call.
struct Node {
  ops::Operands<std::uint32_t> operands{};
  Op op{};

  // Compared word by word: for an array, compilers call memcmp, and this is the innermost loop.
  bool operator==(const Node& other) const {
    return op == other.op && operands[0] == other.operands[0] && operands[1] == other.operands[1] &&
           operands[2] == other.operands[2];
  }
};

// A variable of the host, or the width and height of the image that is input number `image`.
struct Input {
  std::string label;
  Shape shape;
  std::optional<std::uint32_t> image = {};
};

// A function that is called by name. A host function maps floats to a float. Our own functions
// return `values` numbers, followed by as many of their derivatives with respect to the first
// `variables` arguments as the results need: result number i * values + k is derivative i of value
// k; see multi_index.hpp.
struct Function {
  std::string name;
  int arity;
  int values = 0, variables = 0;

  // Returns true for functions that warpjet itself defines, such as noise; see
  // functions/library.hpp.
  bool isFromLibrary() const { return values > 0; }
};

// Marks an uncounted loop, which ends by itself: once its first state, variable 1, is more than
// 0.5, no further step changes any state. It is also the limit of the loop in the shader: no vertex
// shader runs that many iterations, and float32 counts them exactly.
inline constexpr std::uint32_t uncountedSteps = std::uint32_t{1} << 22;

// A loop: its number of iterations and of variables. Variable 0 is the step number, counted from 0;
// the others are states.
struct Loop {
  // The number of iterations of an uncounted loop that estimates assume, and the max on the CPU.
  static constexpr std::uint32_t assumedSteps = 256;

  std::uint32_t steps;
  std::uint32_t locals = 1;

  bool isCounted() const { return steps != uncountedSteps; }
  std::uint32_t estimatedSteps() const { return isCounted() ? steps : assumedSteps; }
};

// One state of a fold: its variable, the initial value, and the value after each step.
struct State {
  NodeId local, start, next;
};

using ops::Operands;

class Graph {
 public:
  // More nodes than any shader can use: a loop that never ends stops here instead of filling the
  // memory. Beyond this limit every new node is the last one, which is valid but meaningless.
  static constexpr std::size_t maxNodes = std::size_t{1} << 22;

  enum class Simplification : bool { Off, On };

  explicit Graph(std::size_t capacity = maxNodes,
                 Simplification simplification = Simplification::On);
  // Makes a full graph of these nodes; `copy` returns one that can grow.
  Graph(std::vector<Node> nodes, std::vector<Input> inputs, std::vector<Function> functions,
        std::vector<Loop> loops);
  Graph copy() const;

  NodeId constant(double value);
  // Returns the node `int(constant)` with all 32 bits; `apply` would round the constant to a float.
  NodeId intConstant(double value);

  // Returns the number of the input with this label and shape, added on first use.
  std::uint32_t input(std::string_view label, Shape shape);
  // Returns the number of the input that is the size of an image.
  std::uint32_t sizeOf(std::uint32_t image);
  // Returns the first input with this label, of any shape.
  std::optional<std::uint32_t> findInput(std::string_view label) const;
  NodeId component(std::uint32_t input, int component);

  // A name must not be added twice.
  std::uint32_t addFunction(Function function);
  std::optional<std::uint32_t> findFunction(std::string_view name) const;
  NodeId call(std::uint32_t function, std::span<const NodeId> arguments);
  // Returns one result of a call of our own functions.
  NodeId result(NodeId call, int number);
  // Sets the derivatives of a host function's call with respect to its arguments, one node each.
  void setPartials(NodeId call, std::span<const NodeId> partials);
  bool hasPartials(NodeId call) const;
  std::vector<NodeId> partials(NodeId call) const { return list(partials_[index(call)]); }
  std::vector<NodeId> arguments(NodeId call) const { return list(operand(call, 0)); }

  // Adds a loop of `steps` iterations, with variables of its own.
  std::uint32_t addLoop(std::uint32_t steps);
  // Returns the loop's step number.
  NodeId stepOf(std::uint32_t loop) { return intern(Node{{loop, 0}, localOp}); }
  // Adds a variable to the loop.
  NodeId addState(std::uint32_t loop);
  // Returns true for the state that ends an uncounted loop.
  bool endsLoop(NodeId local) const;
  // Returns the node of the loop with these states only. They must include every variable that
  // their `next` nodes read.
  NodeId fold(std::uint32_t loop, std::span<const State> states);
  // Returns the value of a state's variable after the last step.
  NodeId outcome(NodeId fold, NodeId local) {
    return intern(Node{{index(fold), index(local)}, outcomeOp});
  }
  std::vector<State> states(NodeId fold) const;

  // Applies an operation to operands and simplifies the result. Operands of the wrong type are
  // converted. Operations on constants are folded in double precision, unless the result isn't a
  // finite float32: such a node remains. Discontinuous operations, such as comparisons and floor,
  // are folded on operands rounded to float32, so that they decide as the shader does, which reads
  // the same constants. With simplification off, which is for tests, the node is only interned.
  NodeId apply(Op op, Operands<NodeId> operands);
  // Finds the node of an operation on two operands without adding it.
  std::optional<NodeId> findNode(Op op, NodeId x, NodeId y) const;

  std::size_t size() const { return nodes_.size(); }
  bool isFull() const { return nodes_.size() >= capacity_; }
  const Node& node(NodeId id) const { return nodes_[index(id)]; }
  const Input& input(std::uint32_t number) const { return inputs_[number]; }
  std::size_t inputCount() const { return inputs_.size(); }
  const Function& function(std::uint32_t number) const { return functions_[number]; }
  const Function& function(NodeId call) const { return functions_[node(call).operands[1]]; }
  std::size_t functionCount() const { return functions_.size(); }
  const Loop& loop(std::uint32_t number) const { return loops_[number]; }
  std::size_t loopCount() const { return loops_.size(); }

  bool isConstant(NodeId id) const { return node(id).op == constantOp; }
  bool isConstant(NodeId id, double value) const;
  bool isInput(NodeId id) const { return node(id).op == inputOp; }
  bool isLocal(NodeId id) const { return node(id).op == localOp; }
  bool isLeaf(NodeId id) const { return isConstant(id) || isInput(id) || isLocal(id); }
  bool isKnownInt(NodeId id) const {
    return is(id, ops::find("int")) && isConstant(operand(id, 0));
  }
  bool isCall(NodeId id) const { return node(id).op == callOp; }
  bool isList(NodeId id) const { return node(id).op == listOp; }
  bool isResult(NodeId id) const { return node(id).op == resultOp; }
  // Returns true for a call of a library function. Such a call isn't a number; its results are.
  bool isLibraryCall(NodeId id) const { return isCall(id) && function(id).isFromLibrary(); }
  bool isFold(NodeId id) const { return node(id).op == foldOp; }
  bool isOutcome(NodeId id) const { return node(id).op == outcomeOp; }
  // Returns true for a state or a list of states, which only folds read.
  bool isStateOrList(NodeId id) const {
    return is(id, stateOp) || (isList(id) && is(operand(id, 1), stateOp));
  }
  // Returns the loop that a variable or a fold belongs to.
  std::uint32_t loopOf(NodeId id) const { return node(id).operands[isLocal(id) ? 0 : 1]; }
  bool isStep(NodeId id) const { return isLocal(id) && node(id).operands[1] == 0; }
  int resultNumber(NodeId id) const { return static_cast<int>(node(id).operands[1]); }
  bool isOperation(NodeId id) const { return index(node(id).op) < ops::count; }
  bool is(NodeId id, Op op) const { return node(id).op == op; }
  double value(NodeId constant) const;
  // Returns the value of a constant; constants of other types are nodes `bool(constant)` and
  // `int(constant)`. A condition is 1 or 0.
  std::optional<double> known(NodeId id) const;
  ops::Type type(NodeId id) const;
  // Returns the interval of a node's values, assuming that inputs and function results have
  // magnitudes up to `assumedMagnitude`, as in real meshes and sketches. So a node may be infinite
  // near a pole, but not because of a large x * x.
  Interval range(NodeId id);
  static constexpr double assumedMagnitude = 1e4;
  // Returns the ranges of all nodes, assuming that inputs and function results are any finite
  // float32.
  std::vector<Interval> rangesOfAll() const;
  // Returns true if the graph contains a node of this operation.
  bool has(Op op) const { return has_[index(op)]; }
  int arity(NodeId id) const { return arities[index(node(id).op)]; }
  NodeId operand(NodeId id, int i) const { return NodeId{node(id).operands[i]}; }

 private:
  // Returns the slot of an equal node, or the empty slot where it belongs. x + y and y + x are one
  // node, in the order of the first use, unless simplification is off.
  std::size_t slotOf(const Node& node) const;
  NodeId intern(const Node& node);
  void makeTable(std::size_t size);
  NodeId convert(NodeId id, ops::Type type);
  std::optional<NodeId> fold(Op op, const Operands<NodeId>& operands);
  NodeId makeList(std::span<const NodeId> items);
  std::vector<NodeId> list(NodeId id) const;
  // Computes one range from `ranges`, the ranges of all nodes before it.
  Interval findRange(NodeId id, double inputSize, const std::vector<Interval>& ranges) const;

  std::vector<Node> nodes_;
  std::array<bool, arities.size()> has_{};
  std::vector<std::uint32_t> table_;  // open addressing; an entry is a node's index plus one
  std::vector<Input> inputs_;
  std::vector<Function> functions_;
  std::vector<Loop> loops_;
  // Lookups by label and by name, since there may be thousands.
  std::multimap<std::string, std::uint32_t, std::less<>> inputNumbers_;
  std::map<std::string, std::uint32_t, std::less<>> functionNumbers_;
  std::vector<NodeId> partials_;  // by call, a list; only as long as needed
  std::vector<Interval> ranges_;  // by node; computed for a prefix of the nodes
  std::size_t capacity_;
  Simplification simplification_;
};

}  // namespace warpjet
