#include "emit/writer.hpp"

#include <algorithm>
#include <utility>

#include "emit/bundle.hpp"
#include "emit/literal.hpp"
#include "graph/multi_index.hpp"

namespace warpjet {

namespace {

constexpr ops::Spelling listSpelling{"$0, $1"}, callSpelling{"$0"};

}  // namespace

Writer::Writer(const Graph& graph, const Dialect& dialect, const Packs& packs)
    : graph_(graph),
      dialect_(dialect),
      packs_(packs),
      names_(graph.size(), none),
      inputNames_(graph.inputCount()) {}

const ops::Spelling& Writer::spellingOf(NodeId id) const {
  if (graph_.isList(id)) return listSpelling;
  if (graph_.isCall(id)) return callSpelling;
  return ops::spelling(graph_.node(id).op, dialect_.language);
}

void Writer::requestResult(NodeId call, int result) {
  const Function& function = graph_.function(call);
  const int needed = MultiIndices::orderOf(function.variables, result / function.values);
  orders_.resize(graph_.size());
  orders_[index(call)] = std::max(orders_[index(call)], static_cast<std::uint8_t>(needed));
}

std::string Writer::typeOf(NodeId id) const {
  if (graph_.isLibraryCall(id)) return Bundle(graph_.function(id), orderOf(id)).type(dialect_);
  return std::string(dialect_.typeName(graph_.type(id), scalarShape));
}

std::string_view Writer::textOf(NodeId id) {
  return graph_.isCall(id) ? callText(id) : spellingOf(id).text;
}

// Returns the spelling of a call, such as `bump($0)`.
std::string_view Writer::callText(NodeId id) {
  const Function& function = graph_.function(id);
  const std::string name =
      function.isFromLibrary() ? nameWithDerivatives(function, orderOf(id)) : function.name;
  return *callTexts_.insert(name + "($0)").first;
}

void Writer::writeResult(std::string& text, NodeId id) const {
  const NodeId call = graph_.operand(id, 0);
  const Bundle bundle(graph_.function(call), orderOf(call));
  text += nameOf(call) + bundle.member(graph_.resultNumber(id));
}

void Writer::name(NodeId id, std::string name) {
  names_[index(id)] = static_cast<std::uint32_t>(texts_.size());
  texts_.push_back(std::move(name));
}

void Writer::writeLeaf(std::string& text, NodeId id) {
  if (graph_.isConstant(id)) {
    const std::string number = literal(graph_.value(id));
    if (number[0] == '-' && text.ends_with('-')) text += ' ';  // "--" is a decrement
    text += number;
    text += dialect_.numberSuffix;
    return;
  }
  const auto [input, component, unused] = graph_.node(id).operands;
  const Shape shape = graph_.input(input).shape;
  text += inputNames_[input];
  if (shape.isMatrix()) text += '[' + std::to_string(component / shape.rows) + ']';
  if (shape.size() > 1) text += {'.', "xyzw"[component % shape.rows]};
}

// Writes negative integers in parentheses, so that no two minuses are adjacent. GLSL has no literal
// for -2^31.
void Writer::writeInt(std::string& text, double value) {
  const auto whole = static_cast<std::int32_t>(value);
  if (whole == INT32_MIN)
    text += "(-2147483647 - 1)";
  else if (whole < 0)
    text += '(' + std::to_string(whole) + ')';
  else
    text += std::to_string(whole);
}

void Writer::open(std::string& text, NodeId id, ops::Precedence loosest) {
  if (isNamed(id)) {
    text += nameOf(id);
  } else if (graph_.isOutcome(id)) {
    text += nameOf(graph_.operand(id, 1));
  } else if (graph_.isLeaf(id)) {
    writeLeaf(text, id);
  } else if (graph_.isKnownInt(id)) {
    writeInt(text, graph_.value(graph_.operand(id, 0)));
  } else if (graph_.isResult(id)) {
    writeResult(text, id);
  } else if (const auto factors = packs_.dotProductOf(id)) {
    writeProduct(text, "dot(", *factors);
  } else {
    const ops::Spelling& spelling = spellingOf(id);
    const bool parenthesized = spelling.result < loosest;
    if (parenthesized) text += '(';
    frames_.push_back({id, textOf(id), parenthesized});
  }
}

// Writes the rest of all spellings on the stack; each `$` is replaced by an operand, whose spelling
// goes onto the stack.
void Writer::writePending(std::string& text) {
  while (!frames_.empty()) {
    Frame& frame = frames_.back();
    const std::size_t dollar = frame.rest.find('$');
    text += frame.rest.substr(0, dollar);
    if (dollar == frame.rest.npos) {
      if (frame.parenthesized) text += ')';
      frames_.pop_back();
      continue;
    }
    const int operand = frame.rest[dollar + 1] - '0';
    frame.rest.remove_prefix(dollar + 2);
    const ops::Spelling& spelling = spellingOf(frame.id);
    open(text, graph_.operand(frame.id, operand), spelling.operands[operand]);
  }
}

void Writer::write(std::string& text, NodeId id) {
  open(text, id, ops::Precedence::Ternary);
  writePending(text);
}

void Writer::writeOperation(std::string& text, NodeId id) {
  if (graph_.isResult(id)) return writeResult(text, id);
  if (graph_.isOutcome(id)) {
    text += nameOf(graph_.operand(id, 1));
    return;
  }
  if (graph_.isKnownInt(id)) return writeInt(text, graph_.value(graph_.operand(id, 0)));
  if (const auto factors = packs_.dotProductOf(id)) return writeProduct(text, "dot(", *factors);
  frames_.push_back({id, textOf(id), false});
  writePending(text);
}

bool Writer::isWholeInput(Shape shape, std::span<const NodeId> components) const {
  for (std::size_t i = 0; i < components.size(); ++i) {
    if (!graph_.isInput(components[i])) return false;
    const auto [input, component, unused] = graph_.node(components[i]).operands;
    if (input != graph_.node(components[0]).operands[0] || component != i) return false;
    if (graph_.input(input).shape != shape) return false;
  }
  return true;
}

void Writer::writeValue(std::string& text, Shape shape, std::span<const NodeId> components) {
  if (shape.isNumber()) return write(text, components[0]);
  if (isWholeInput(shape, components)) {
    text += inputNames_[graph_.node(components[0]).operands[0]];
    return;
  }
  if (shape.isVector()) return writeLanes(text, Lanes(components), Packs::As::Operand);
  writeRow(text, shape, components, Packs::As::Operand);
}

}  // namespace warpjet
