#include "frame/frame.hpp"

#include <memory>
#include <numbers>
#include <optional>
#include <string>

#include "graph/expression.hpp"
#include "graph/flags.hpp"
#include "graph/reachable.hpp"
#include "noise/noise.hpp"
#include "ops/scalar.hpp"

namespace warpjet {

namespace {

constexpr Op add = ops::find("add"), sub = ops::find("sub"), neg = ops::find("neg"),
             mult = ops::find("mult"), divide = ops::find("div");

class Separation {
 public:
  Separation(Graph& graph, Library& library, std::span<const std::uint32_t> known)
      : graph_(graph),
        library_(library),
        isKnown_(graph.inputCount()),
        isFrame_(graph.size()),
        written_(graph.size(), noNode),
        sums_(graph.size()) {
    for (const std::uint32_t input : known) isKnown_[input] = true;
  }

  // Operands are visited before their users.
  void visit(NodeId id) {
    if (graph_.isInput(id)) isFrame_[index(id)] = isKnown_[graph_.node(id).operands[0]];
    if (graph_.isLeaf(id) || graph_.known(id)) {
      written_[index(id)] = id;
    } else if (graph_.isOperation(id)) {
      visitOperation(id);
    } else if (graph_.isCall(id)) {
      written_[index(id)] = callOf(id);
    } else if (graph_.isResult(id)) {
      written_[index(id)] = graph_.result(written(graph_.operand(id, 0)), graph_.resultNumber(id));
    } else if (graph_.isFold(id)) {
      std::vector<State> states = graph_.states(id);
      for (State& state : states) {
        state.start = written(state.start);
        state.next = written(state.next);
      }
      written_[index(id)] = graph_.fold(graph_.loopOf(id), states);
    } else if (graph_.isOutcome(id)) {
      written_[index(id)] = graph_.outcome(written(graph_.operand(id, 0)), graph_.operand(id, 1));
    }
  }

  // In the text.
  NodeId written(NodeId id) {
    NodeId& node = written_[index(id)];
    if (node == noNode) node = handedOver(id);
    return node;
  }

  // What the inputs of the frame are to be.
  const std::vector<NodeId>& values() const { return values_; }

  // How many of these are less by whole periods.
  std::size_t reduced() const { return reduced_; }

  std::uint32_t inputs() const { return static_cast<std::uint32_t>((values_.size() + 3) / 4); }

 private:
  // What varies, in the text, and what does not, before it is handed over.
  struct Sum {
    NodeId varying = noNode, frame = noNode;
  };

  void visitOperation(NodeId id) {
    bool isFrame = false, isVarying = false;
    for (int i = 0; i < graph_.arity(id); ++i) {
      const NodeId operand = graph_.operand(id, i);
      isFrame |= isFrame_[index(operand)];
      isVarying |= !isSame(operand);
    }
    isFrame_[index(id)] = isFrame && !isVarying;
    if (isFrame_[index(id)]) return;
    sums_[index(id)] = sumOf(id);
    Operands<NodeId> operands{};
    for (int i = 0; i < graph_.arity(id); ++i) operands[i] = written(graph_.operand(id, i));
    if (const double period = periodOf(id); period > 0)
      operands[0] = within(period, graph_.operand(id, 0));
    written_[index(id)] = graph_.apply(graph_.node(id).op, operands);
  }

  // What is linear in its parts is a sum of them again.
  Sum sumOf(NodeId id) {
    const Op op = graph_.node(id).op;
    if (op == neg) return each(op, partsOf(graph_.operand(id, 0)));
    if (op != add && op != sub && op != mult && op != divide) return {};
    const NodeId x = graph_.operand(id, 0), y = graph_.operand(id, 1);
    if (op == mult && isSame(x)) return scaled(op, partsOf(y), x);
    if (op == mult || op == divide) return isSame(y) ? scaled(op, partsOf(x), y) : Sum{};
    const Sum left = partsOf(x), right = partsOf(y);
    return {joined(op, left.varying, right.varying), joined(op, left.frame, right.frame)};
  }

  bool isSame(NodeId id) const { return isFrame_[index(id)] || graph_.known(id); }

  Sum partsOf(NodeId id) {
    if (isFrame_[index(id)]) return {noNode, id};
    const Sum sum = sums_[index(id)];
    return sum.frame == noNode ? Sum{written(id), noNode} : sum;
  }

  Sum each(Op op, Sum sum) {
    if (sum.varying != noNode) sum.varying = graph_.apply(op, {sum.varying});
    if (sum.frame != noNode) sum.frame = graph_.apply(op, {sum.frame});
    return sum;
  }

  Sum scaled(Op op, Sum sum, NodeId factor) {
    if (sum.frame == noNode) return {};
    if (sum.varying != noNode) sum.varying = graph_.apply(op, {sum.varying, written(factor)});
    return {sum.varying, graph_.apply(op, {sum.frame, factor})};
  }

  NodeId joined(Op op, NodeId x, NodeId y) {
    if (y == noNode) return x;
    if (x == noNode) return op == sub ? graph_.apply(neg, {y}) : y;
    return graph_.apply(op, {x, y});
  }

  // Of an operation's first operand; 0 if there is none.
  double periodOf(NodeId id) const {
    const Op op = graph_.node(id).op;
    if (op == ops::find("sin") || op == ops::find("cos")) return 2 * std::numbers::pi;
    if (op == ops::find("tan")) return std::numbers::pi;
    if (op == ops::find("fract")) return 1;
    const bool isModulo = op == ops::find("mod") && graph_.isConstant(graph_.operand(id, 1));
    return isModulo ? graph_.value(graph_.operand(id, 1)) : 0;
  }

  // The operand, with what is the same for a frame less by whole periods.
  NodeId within(double period, NodeId id) {
    const auto [varying, frame] = partsOf(id);
    if (frame == noNode) return varying;
    const NodeId given = remainder({&graph_, frame}, period);
    return varying == noNode ? given : graph_.apply(add, {varying, given});
  }

  NodeId remainder(Expression frame, double period) {
    const std::size_t before = values_.size();
    const NodeId given = handedOver((frame - round(frame / period) * period).id);
    reduced_ += values_.size() - before;
    return given;
  }

  Expression round(Expression x) { return build(ops::find("round"), x); }

  NodeId callOf(NodeId call) {
    std::vector<NodeId> arguments = graph_.arguments(call);
    const Function function = graph_.function(call);
    const auto variables = static_cast<std::size_t>(function.variables);
    double period = 0;
    if (function.isOurs()) {
      std::optional<double> lacunarity;
      if (variables + 1 < arguments.size() && graph_.isConstant(arguments[variables + 1]))
        lacunarity = graph_.value(arguments[variables + 1]);
      const Definition& definition = library_.definition(function.name);
      period = noisePeriod(definition, lacunarity);
      // Cells and the rest of a coordinate must come from one computation.
      if (values_.size() + 2 * variables <= mostFrameValues && knowsCells(definition, lacunarity)) {
        for (std::size_t i = 0; i < variables; ++i)
          if (partsOf(arguments[i]).frame != noNode) return callApart(definition, arguments);
      }
    }
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const bool repeats = period > 0 && i < variables;
      arguments[i] = repeats ? within(period, arguments[i]) : written(arguments[i]);
    }
    return graph_.call(graph_.node(call).operands[1], arguments);
  }

  // What is the same for a frame, as whole cells and the rest.
  NodeId callApart(const Definition& definition, const std::vector<NodeId>& arguments) {
    Numbers given, cells;
    for (const NodeId id : arguments) {
      const bool isCoordinate =
          given.size() < static_cast<std::size_t>(definition.function.variables);
      given.push_back({&graph_, isCoordinate ? within(1, id) : written(id)});
      if (!isCoordinate) continue;
      const NodeId frame = partsOf(id).frame;
      cells.push_back({&graph_, frame == noNode
                                    ? graph_.constant(0)
                                    : remainder(round({&graph_, frame}), ops::hashPrime)});
    }
    for (const Expression cell : cells) given.push_back(cell);
    return graph_.operand(library_.call(withCells(definition), given)[0].id, 0);
  }

  // The node that the shader reads in place of `id`, or `id` itself where no room is left. Frame
  // inputs are floats: a condition arrives as 1 or 0. A whole number arrives as two floats, its
  // upper and its lower 16 bits, since a float has only 24 bits.
  NodeId handedOver(NodeId id) {
    if (graph_.isLeaf(id)) return id;
    NodeId given = noNode;
    switch (graph_.type(id)) {
      case ops::Type::Float:
        given = component(id);
        break;
      case ops::Type::Bool:
        given = component(graph_.apply(ops::find("float"), {id}));
        if (given != noNode) given = graph_.apply(ops::find("bool"), {given});
        break;
      case ops::Type::Int:
        given = fromHalves(half(ops::find("shiftRight"), id, 16),
                           half(ops::find("bitAnd"), id, 0xffff));
        break;
    }
    return given == noNode ? id : given;
  }

  // The component whose value is to be this float, or `noNode` where no room is left.
  NodeId component(NodeId value) {
    std::size_t place = 0;
    while (place < values_.size() && values_[place] != value) ++place;
    if (place == mostFrameValues) return noNode;
    if (place == values_.size()) values_.push_back(value);
    const std::string label = frameLabel + std::to_string(place / 4);
    return graph_.component(graph_.input(label, vectorOf(4)), static_cast<int>(place % 4));
  }

  NodeId half(Op op, NodeId whole, double by) {
    const NodeId bits = graph_.apply(op, {whole, graph_.whole(by)});
    return component(graph_.apply(ops::find("intToFloat"), {bits}));
  }

  // A product and a sum, since GLSL ES 1.00 has no bit operations.
  NodeId fromHalves(NodeId high, NodeId low) {
    if (high == noNode || low == noNode) return noNode;
    const NodeId upper = graph_.apply(ops::find("intMult"), {high, graph_.whole(0x10000)});
    return graph_.apply(ops::find("intAdd"), {upper, low});
  }

  Graph& graph_;
  Library& library_;
  Flags isKnown_;  // by input
  Flags isFrame_;  // by node, as the two below
  std::vector<NodeId> written_;
  std::vector<Sum> sums_;
  std::vector<NodeId> values_;
  std::size_t reduced_ = 0;
};

// A module's graph, what its results are there, and what is computed of them once a frame.
struct Separated {
  Separated(Module& module, std::span<const std::uint32_t> known, bool unrolls)
      : graph(module.graph.copy()),
        roots(unrolls ? unrolled(graph, module.roots()) : module.roots()),
        separation(graph, module.library, known) {
    for (const NodeId id : reachable(graph, roots)) separation.visit(id);
    for (NodeId& root : roots) root = separation.written(root);
  }

  Graph graph;
  std::vector<NodeId> roots;
  Separation separation;
};

// Whether all loops, written out, are of a size that compiles at once.
bool areShort(const Graph& graph) {
  if (!graph.has(foldOp)) return false;
  std::size_t written = graph.size();
  for (std::uint32_t i = 0; i < graph.loopCount() && written <= mostUnrolled; ++i)
    written *= graph.loop(i).steps;
  return written <= mostUnrolled;
}

// What no result reads need not be computed.
void leaveOutUnread(const Graph& graph, std::span<const NodeId> roots, std::uint32_t firstInput,
                    std::vector<NodeId>& values, NodeId zero) {
  Flags isRead(values.size());
  for (const NodeId id : reachable(graph, roots)) {
    if (!graph.isInput(id) || graph.node(id).operands[0] < firstInput) continue;
    isRead[(graph.node(id).operands[0] - firstInput) * 4 + graph.node(id).operands[1]] = true;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!isRead[i]) values[i] = zero;
  }
}

}  // namespace

std::uint32_t separateFrame(Module& module, std::span<const std::uint32_t> known) {
  const auto firstInput = static_cast<std::uint32_t>(module.graph.inputCount());
  auto separated = std::make_unique<Separated>(module, known, false);
  if (areShort(module.graph)) {
    // Steps of a loop add something else each.
    auto other = std::make_unique<Separated>(module, known, true);
    if (other->separation.reduced() > separated->separation.reduced()) separated = std::move(other);
  }
  auto& [graph, found, separation] = *separated;
  std::vector<NodeId> values = separation.values();
  const NodeId zero = graph.constant(0);
  leaveOutUnread(graph, found, firstInput, values, zero);
  if (graph.full() || values.empty()) return 0;
  values.resize(4 * separation.inputs(), zero);
  auto node = found.begin();
  for (Output& output : module.outputs) {
    for (NodeId& component : output.components) component = *node++;
  }
  module.methods.resize(graph.inputCount());
  module.graph = std::move(graph);
  module.outputs.push_back({frameLabel, oneNumber, std::move(values)});
  return separation.inputs();
}

}  // namespace warpjet
