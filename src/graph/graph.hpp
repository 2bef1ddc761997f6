// The expression graph: operations enter, interned and folded scalar nodes leave.
//
// Every node is one float, bool or int, but for images, lists of arguments, and calls of functions
// of ours, which only calls and results read, and what folds are made of; a vec3 is three ids, held
// by whoever wants a vector.
// Equal nodes are one node, so a value and its derivatives share their work. Operands always have
// smaller ids than their users, so ascending ids are a topological order and nothing recurses by
// depth. The graph knows nothing of shaders: an input is a label and a component, a function of the
// host is a name.
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

// In the place of a node where there is none.
inline constexpr NodeId noNode{none};

constexpr std::uint32_t index(NodeId id) { return static_cast<std::uint32_t>(id); }
constexpr std::size_t index(Op op) { return static_cast<std::size_t>(op); }

// The kinds of nodes that are no rows of the table, numbered after them: two kinds of leaves, a
// call of a function, whose arguments are a list, and one result of a call that has several. A
// fold, the loop, is four kinds more: see graph/folds.hpp.
inline constexpr Op constantOp{static_cast<std::uint8_t>(ops::count)};
inline constexpr Op inputOp{static_cast<std::uint8_t>(ops::count + 1)};
inline constexpr Op callOp{static_cast<std::uint8_t>(ops::count + 2)};
inline constexpr Op listOp{static_cast<std::uint8_t>(ops::count + 3)};
inline constexpr Op resultOp{static_cast<std::uint8_t>(ops::count + 4)};
inline constexpr Op localOp{static_cast<std::uint8_t>(ops::count + 5)};
inline constexpr Op stateOp{static_cast<std::uint8_t>(ops::count + 6)};
inline constexpr Op foldOp{static_cast<std::uint8_t>(ops::count + 7)};
inline constexpr Op outcomeOp{static_cast<std::uint8_t>(ops::count + 8)};

// How many operands are nodes, by operation.
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

// Sixteen bytes. A constant keeps the bits of its double in the first two operands, an input its
// number and its component. A call has its arguments first and then the number of its function;
// several arguments are a list of all but the last, and the last. A result has its call, and its
// number there.
struct Node {
  ops::Operands<std::uint32_t> operands{};
  Op op{};

  // Word by word: of an array, compilers call memcmp, in the innermost loop that there is.
  bool operator==(const Node& other) const {
    return op == other.op && operands[0] == other.operands[0] && operands[1] == other.operands[1] &&
           operands[2] == other.operands[2];
  }
};

// A variable of the host, or the width and height of the image that is another input.
struct Input {
  std::string label;
  Shape shape;
  std::optional<std::uint32_t> image = {};
};

// A function that is called by name. One of the host goes from floats to a float. One of ours gives
// `values` numbers, and as many of their derivatives by its first `variables` arguments as results
// are asked for: result number i * values + k is derivative i of value k; see multi_index.hpp.
struct Function {
  std::string name;
  int arity;
  int values = 0, variables = 0;

  bool isOurs() const { return values > 0; }
};

// A loop: how often its body is run, and how many variables it has. The first is the number of the
// step, from 0 on, the others are states.
struct Loop {
  std::uint32_t steps;
  std::uint32_t locals = 1;
};

// One of the states of a fold: its variable, what that starts as, and what each step makes of it.
struct State {
  NodeId local, start, next;
};

using ops::Operands;

class Graph {
 public:
  // More nodes than any shader can use; a loop that never ends stops here instead of taking all
  // memory. Past it every new node is the last one, valid but meaningless.
  static constexpr std::size_t maxNodes = std::size_t{1} << 22;

  enum class Simplification : bool { Off, On };

  explicit Graph(std::size_t capacity = maxNodes,
                 Simplification simplification = Simplification::On);
  // One of these nodes, to which none can be added: that is what copies are for.
  Graph(std::vector<Node> nodes, std::vector<Input> inputs, std::vector<Function> functions,
        std::vector<Loop> loops);
  Graph copy() const;

  NodeId constant(double value);
  // The node `int(constant)`, which has all 32 bits: `apply` would round the constant to a float.
  NodeId whole(double value);

  // The number of the input with this label and shape; asking twice gives the same one.
  std::uint32_t input(std::string_view label, Shape shape);
  // The number of the input that is the size of an image.
  std::uint32_t sizeOf(std::uint32_t image);
  // The first input with this label, whatever its shape.
  std::optional<std::uint32_t> inputLabelled(std::string_view label) const;
  NodeId component(std::uint32_t input, int component);

  // Names are given once.
  std::uint32_t addFunction(Function function);
  std::optional<std::uint32_t> functionNamed(std::string_view name) const;
  NodeId call(std::uint32_t function, std::span<const NodeId> arguments);
  // Of a call of a function of ours.
  NodeId result(NodeId call, int number);
  // What the derivatives of a call by its arguments are, one node each; for functions of the host.
  void setPartials(NodeId call, std::span<const NodeId> partials);
  bool hasPartials(NodeId call) const;
  std::vector<NodeId> partials(NodeId call) const { return list(partials_[index(call)]); }
  std::vector<NodeId> arguments(NodeId call) const { return list(operand(call, 0)); }

  // A loop that is run so often; its variables belong to it alone.
  std::uint32_t addLoop(std::uint32_t steps);
  // The number of its step.
  NodeId stepOf(std::uint32_t loop) { return intern(Node{{loop, 0}, localOp}); }
  // One more variable of it.
  NodeId addState(std::uint32_t loop);
  // The loop with these states, and with all that what they become reads of its variables.
  NodeId fold(std::uint32_t loop, std::span<const State> states);
  // What the variable of a state is after all steps.
  NodeId outcome(NodeId fold, NodeId local) {
    return intern(Node{{index(fold), index(local)}, outcomeOp});
  }
  std::vector<State> states(NodeId fold) const;

  // The operation on operands, simplified. Operands of the wrong type are converted. An operation
  // on constants is folded, unless its result is not a finite float32: such a node stays as it is.
  // That is done in double; but what only jumps, such as a comparison or floor, sees its operands
  // in float32, and so decides as the shader does that reads the same constants.
  // With simplification off, which is for tests, it is only interned.
  NodeId apply(Op op, Operands<NodeId> operands);
  // The operation on two operands if it is there, as it would be interned.
  std::optional<NodeId> found(Op op, NodeId x, NodeId y) const;

  std::size_t size() const { return nodes_.size(); }
  bool full() const { return nodes_.size() >= capacity_; }
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
  // A call of a function of ours, which is no number: its results are.
  bool isOurCall(NodeId id) const { return isCall(id) && function(id).isOurs(); }
  bool isFold(NodeId id) const { return node(id).op == foldOp; }
  bool isOutcome(NodeId id) const { return node(id).op == outcomeOp; }
  // A state, or a list of them: what only a fold reads.
  bool isOfStates(NodeId id) const {
    return is(id, stateOp) || (isList(id) && is(operand(id, 1), stateOp));
  }
  // The loop of a variable or a fold.
  std::uint32_t loopOf(NodeId id) const { return node(id).operands[isLocal(id) ? 0 : 1]; }
  bool isStep(NodeId id) const { return isLocal(id) && node(id).operands[1] == 0; }
  int resultNumber(NodeId id) const { return static_cast<int>(node(id).operands[1]); }
  bool isOperation(NodeId id) const { return index(node(id).op) < ops::count; }
  bool is(NodeId id, Op op) const { return node(id).op == op; }
  double value(NodeId constant) const;
  // The value of a constant, which of another type than float is the node `bool(constant)` or
  // `int(constant)`; of a condition 1 or 0.
  std::optional<double> known(NodeId id) const;
  ops::Type type(NodeId id) const;
  // What a node can be where inputs, and what functions give, are numbers up to `usualSize`: what
  // meshes and sketches have. So it may be infinite near a pole, but not from a large x * x.
  Interval range(NodeId id);
  static constexpr double usualSize = 1e4;
  // The ranges of all nodes where inputs and functions give any finite float32.
  std::vector<Interval> rangesOfAll() const;
  // Whether any node is of this operation.
  bool has(Op op) const { return has_[index(op)]; }
  int arity(NodeId id) const { return arities[index(node(id).op)]; }
  NodeId operand(NodeId id, int i) const { return NodeId{node(id).operands[i]}; }

 private:
  // The slot that holds an equal node, or the empty one where it belongs. x + y and y + x are one
  // node, in the order that came first, unless simplification is off.
  std::size_t slotOf(const Node& node) const;
  NodeId intern(const Node& node);
  void makeTable(std::size_t size);
  NodeId convert(NodeId id, ops::Type type);
  std::optional<NodeId> fold(Op op, const Operands<NodeId>& operands);
  NodeId makeList(std::span<const NodeId> items);
  std::vector<NodeId> list(NodeId id) const;
  // Computes a range from `ranges`, those of the nodes before it.
  Interval findRange(NodeId id, double inputSize, const std::vector<Interval>& ranges) const;

  std::vector<Node> nodes_;
  std::array<bool, arities.size()> has_{};
  std::vector<std::uint32_t> table_;  // open addressing; an entry is a node's index plus one
  std::vector<Input> inputs_;
  std::vector<Function> functions_;
  std::vector<Loop> loops_;
  // Numbers by label and by name: there may be thousands.
  std::multimap<std::string, std::uint32_t, std::less<>> inputNumbers_;
  std::map<std::string, std::uint32_t, std::less<>> functionNumbers_;
  std::vector<NodeId> partials_;  // by call, a list; as long as there are calls with any
  std::vector<Interval> ranges_;  // by node, of the first ones
  std::size_t capacity_;
  Simplification simplification_;
};

}  // namespace warpjet
