#include "frame/separation.hpp"

#include <numbers>
#include <optional>

#include "frame/frame.hpp"
#include "noise/noise.hpp"
#include "ops/scalar.hpp"

namespace warpjet {

namespace {

constexpr Op add = ops::find("add"), sub = ops::find("sub"), neg = ops::find("neg"),
             mult = ops::find("mult"), divide = ops::find("div");

Expression round(Expression x) { return build(ops::find("round"), x); }

}  // namespace

Separation::Separation(Graph& graph, Library& library, std::span<const std::uint32_t> frameInputs)
    : graph_(graph),
      library_(library),
      inputs_(graph),
      isFrameInput_(graph.inputCount()),
      isFrame_(graph.size()),
      replacements_(graph.size(), noNode),
      sums_(graph.size()) {
  for (const std::uint32_t input : frameInputs) isFrameInput_[input] = true;
}

void Separation::visit(NodeId id) {
  if (graph_.isInput(id)) isFrame_[index(id)] = isFrameInput_[graph_.node(id).operands[0]];
  if (graph_.isLeaf(id) || graph_.known(id)) {
    replacements_[index(id)] = id;
  } else if (graph_.isOperation(id)) {
    visitOperation(id);
  } else if (graph_.isCall(id)) {
    replacements_[index(id)] = callOf(id);
  } else if (graph_.isResult(id)) {
    replacements_[index(id)] =
        graph_.result(replacementOf(graph_.operand(id, 0)), graph_.resultNumber(id));
  } else if (graph_.isFold(id)) {
    std::vector<State> states = graph_.states(id);
    for (State& state : states) {
      state.start = replacementOf(state.start);
      state.next = replacementOf(state.next);
    }
    replacements_[index(id)] = graph_.fold(graph_.loopOf(id), states);
  } else if (graph_.isOutcome(id)) {
    replacements_[index(id)] =
        graph_.outcome(replacementOf(graph_.operand(id, 0)), graph_.operand(id, 1));
  }
}

NodeId Separation::replacementOf(NodeId id) {
  NodeId& node = replacements_[index(id)];
  if (node == noNode) node = inputs_.pass(id);
  return node;
}

void Separation::visitOperation(NodeId id) {
  bool isFrame = false, isVarying = false;
  for (int i = 0; i < graph_.arity(id); ++i) {
    const NodeId operand = graph_.operand(id, i);
    isFrame |= isFrame_[index(operand)];
    isVarying |= !isConstantInFrame(operand);
  }
  isFrame_[index(id)] = isFrame && !isVarying;
  if (isFrame_[index(id)]) return;
  sums_[index(id)] = sumOf(id);
  Operands<NodeId> operands{};
  for (int i = 0; i < graph_.arity(id); ++i) operands[i] = replacementOf(graph_.operand(id, i));
  if (const double period = periodOf(id); period > 0)
    operands[0] = reduceBy(period, graph_.operand(id, 0));
  replacements_[index(id)] = graph_.apply(graph_.node(id).op, operands);
}

// Separates the result of an operation into a sum: linear operations are distributed over the parts
// of their operands.
Separation::Sum Separation::sumOf(NodeId id) {
  const Op op = graph_.node(id).op;
  if (op == neg) return applyToEach(op, partsOf(graph_.operand(id, 0)));
  if (op != add && op != sub && op != mult && op != divide) return {};
  const NodeId x = graph_.operand(id, 0), y = graph_.operand(id, 1);
  if (op == mult && isConstantInFrame(x)) return scaleSum(op, partsOf(y), x);
  if (op == mult || op == divide) return isConstantInFrame(y) ? scaleSum(op, partsOf(x), y) : Sum{};
  const Sum left = partsOf(x), right = partsOf(y);
  return {combine(op, left.varying, right.varying), combine(op, left.frame, right.frame)};
}

Separation::Sum Separation::partsOf(NodeId id) {
  if (isFrame_[index(id)]) return {noNode, id};
  const Sum sum = sums_[index(id)];
  return sum.frame == noNode ? Sum{replacementOf(id), noNode} : sum;
}

Separation::Sum Separation::applyToEach(Op op, Sum sum) {
  if (sum.varying != noNode) sum.varying = graph_.apply(op, {sum.varying});
  if (sum.frame != noNode) sum.frame = graph_.apply(op, {sum.frame});
  return sum;
}

Separation::Sum Separation::scaleSum(Op op, Sum sum, NodeId factor) {
  if (sum.frame == noNode) return {};
  if (sum.varying != noNode) sum.varying = graph_.apply(op, {sum.varying, replacementOf(factor)});
  return {sum.varying, graph_.apply(op, {sum.frame, factor})};
}

NodeId Separation::combine(Op op, NodeId x, NodeId y) {
  if (y == noNode) return x;
  if (x == noNode) return op == sub ? graph_.apply(neg, {y}) : y;
  return graph_.apply(op, {x, y});
}

// Returns the period of the operation with respect to its first operand; 0 if it isn't periodic.
double Separation::periodOf(NodeId id) const {
  const Op op = graph_.node(id).op;
  if (op == ops::find("sin") || op == ops::find("cos")) return 2 * std::numbers::pi;
  if (op == ops::find("tan")) return std::numbers::pi;
  if (op == ops::find("fract")) return 1;
  const bool isModulo = op == ops::find("mod") && graph_.isConstant(graph_.operand(id, 1));
  return isModulo ? graph_.value(graph_.operand(id, 1)) : 0;
}

// Returns the operand with its frame constant reduced by whole periods.
NodeId Separation::reduceBy(double period, NodeId id) {
  const auto [varying, frame] = partsOf(id);
  if (frame == noNode) return varying;
  const NodeId reduced = remainder({&graph_, frame}, period);
  return varying == noNode ? reduced : graph_.apply(add, {varying, reduced});
}

NodeId Separation::remainder(Expression frame, double period) {
  const std::size_t before = inputs_.values().size();
  const NodeId input = inputs_.pass((frame - round(frame / period) * period).id);
  reducedCount_ += inputs_.values().size() - before;
  return input;
}

NodeId Separation::callOf(NodeId call) {
  std::vector<NodeId> arguments = graph_.arguments(call);
  const Function function = graph_.function(call);
  const auto variables = static_cast<std::size_t>(function.variables);
  double period = 0;
  if (function.isFromLibrary()) {
    std::optional<double> lacunarity;
    if (variables + 1 < arguments.size() && graph_.isConstant(arguments[variables + 1]))
      lacunarity = graph_.value(arguments[variables + 1]);
    const Definition& definition = library_.definition(function.name);
    period = noisePeriod(definition, lacunarity);
    // The cell and the remainder of a coordinate come from the same rounding, so both must be
    // computed on the CPU: cells are used only if there is room for two frame inputs per
    // coordinate.
    if (inputs_.values().size() + 2 * variables <= maxFrameValues &&
        canTakeCells(definition, lacunarity)) {
      for (std::size_t i = 0; i < variables; ++i)
        if (partsOf(arguments[i]).frame != noNode) return callWithCells(definition, arguments);
    }
  }
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool isPeriodic = period > 0 && i < variables;
    arguments[i] = isPeriodic ? reduceBy(period, arguments[i]) : replacementOf(arguments[i]);
  }
  return graph_.call(graph_.node(call).operands[1], arguments);
}

// Passes the frame constants of coordinates as integer cells and remainders.
NodeId Separation::callWithCells(const Definition& definition,
                                 const std::vector<NodeId>& arguments) {
  Numbers newArguments, cells;
  for (const NodeId id : arguments) {
    const bool isCoordinate =
        newArguments.size() < static_cast<std::size_t>(definition.function.variables);
    newArguments.push_back({&graph_, isCoordinate ? reduceBy(1, id) : replacementOf(id)});
    if (!isCoordinate) continue;
    const NodeId frame = partsOf(id).frame;
    cells.push_back({&graph_, frame == noNode
                                  ? graph_.constant(0)
                                  : remainder(round({&graph_, frame}), ops::hashPrime)});
  }
  for (const Expression cell : cells) newArguments.push_back(cell);
  return graph_.operand(library_.call(withCells(definition), newArguments)[0].id, 0);
}

}  // namespace warpjet
