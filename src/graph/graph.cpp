#include "graph/graph.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "graph/simplify.hpp"

namespace warpjet {

namespace {

// Small, since most warps are small and each has a table to clear; it doubles when needed.
constexpr std::size_t initialTableSize = 256;

// Lookup tables of one byte per operation, read for each operand of each node.
constexpr auto resultTypes = [] {
  std::array<ops::Type, arities.size()> all{};
  all.fill(ops::Type::Float);
  for (std::size_t i = 0; i < ops::count; ++i) all[i] = ops::declarations[i].signature.result;
  return all;
}();

constexpr auto isCommutative = [] {
  std::array<bool, arities.size()> all{};
  for (std::size_t i = 0; i < ops::count; ++i)
    all[i] = ops::declarations[i].traits.has(ops::Trait::Commutative);
  return all;
}();

// Commutative operations hash equally in both orders: x + y and y + x.
std::size_t hash(const Node& node) {
  // Multiply and xor-shift, as in Steele and Vigna's splitmix64.
  const auto [x, y, z] = node.operands;
  const bool isSwapped = isCommutative[index(node.op)] && x > y;
  std::uint64_t h = isSwapped ? y | std::uint64_t{x} << 32 : x | std::uint64_t{y} << 32;
  h ^= (z | std::uint64_t{static_cast<std::uint8_t>(node.op)} << 32) * 0x9e3779b97f4a7c15u;
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
  return static_cast<std::size_t>(h ^ (h >> 31));
}

// Does what std::bit_cast does, which Emscripten 3.1.6 lacks.
template <class To, class From>
To bitCast(From from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(&to, &from, sizeof to);
  return to;
}

// The entry of an operation is true if `known` may return a value for it. Most operands are not
// known, and reading one byte rules them out.
constexpr auto mayBeKnown = [] {
  std::array<bool, arities.size()> all{};
  for (const Op op : {constantOp, ops::find("bool"), ops::find("int")}) all[index(op)] = true;
  return all;
}();

// Returns a constant rounded as a shader reads it.
double asFloat32(double value) { return static_cast<double>(static_cast<float>(value)); }

bool fitsFloat32(double value) {
  return std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());
}

}  // namespace

Graph::Graph(std::size_t capacity, Simplification simplification)
    : table_(initialTableSize), capacity_(capacity), simplification_(simplification) {}

Graph::Graph(std::vector<Node> nodes, std::vector<Input> inputs, std::vector<Function> functions,
             std::vector<Loop> loops)
    : nodes_(std::move(nodes)),
      inputs_(std::move(inputs)),
      functions_(std::move(functions)),
      loops_(std::move(loops)),
      capacity_(nodes_.size()),
      simplification_(Simplification::On) {
  for (const Node& node : nodes_) has_[index(node.op)] = true;
  for (std::uint32_t i = 0; i < functions_.size(); ++i)
    functionNumbers_.emplace(functions_[i].name, i);
  for (std::uint32_t i = 0; i < inputs_.size(); ++i) {
    if (!inputs_[i].image) inputNumbers_.emplace(inputs_[i].label, i);
  }
}

Graph Graph::copy() const {
  Graph copied = *this;
  copied.capacity_ = std::max(capacity_, maxNodes);
  std::size_t size = initialTableSize;
  while (size < copied.nodes_.size() * 2) size *= 2;
  if (size > table_.size()) copied.makeTable(size);
  return copied;
}

std::size_t Graph::slotOf(const Node& node) const {
  const std::size_t mask = table_.size() - 1;
  const bool commutes = isCommutative[index(node.op)] && simplification_ == Simplification::On;
  const Node swapped{{node.operands[1], node.operands[0]}, node.op};
  const auto isEqual = [&](const Node& known) {
    return known == node || (commutes && known == swapped);
  };
  std::size_t slot = hash(node) & mask;
  while (table_[slot] != 0 && !isEqual(nodes_[table_[slot] - 1])) slot = (slot + 1) & mask;
  return slot;
}

NodeId Graph::intern(const Node& node) {
  const std::size_t slot = slotOf(node);
  if (table_[slot] != 0) return NodeId{table_[slot] - 1};
  if (isFull()) return NodeId(nodes_.size() - 1);

  const auto id = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back(node);
  has_[index(node.op)] = true;
  table_[slot] = id + 1;
  if (nodes_.size() * 2 > table_.size()) makeTable(table_.size() * 2);
  return NodeId{id};
}

void Graph::makeTable(std::size_t size) {
  table_.assign(size, 0);
  const std::size_t mask = size - 1;
  // No two nodes are equal, so each takes the first empty slot.
  for (std::uint32_t id = 0; id < nodes_.size(); ++id) {
    std::size_t slot = hash(nodes_[id]) & mask;
    while (table_[slot] != 0) slot = (slot + 1) & mask;
    table_[slot] = id + 1;
  }
}

NodeId Graph::constant(double value) {
  const auto bits = bitCast<std::uint64_t>(value);
  return intern(
      {{static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits >> 32)}, constantOp});
}

NodeId Graph::intConstant(double value) {
  return intern(Node{{index(constant(value))}, ops::find("int")});
}

double Graph::value(NodeId constant) const {
  const auto& words = node(constant).operands;
  return bitCast<double>(words[0] | std::uint64_t{words[1]} << 32);
}

bool Graph::isConstant(NodeId id, double value) const {
  return isConstant(id) && this->value(id) == value;
}

NodeId Graph::component(std::uint32_t input, int component) {
  return intern(Node{{input, static_cast<std::uint32_t>(component)}, inputOp});
}

ops::Type Graph::type(NodeId id) const { return resultTypes[index(node(id).op)]; }

// Rarely needed, hence kept out of `apply`.
[[gnu::noinline]] NodeId Graph::convert(NodeId id, ops::Type wanted) {
  if (type(id) == wanted) return id;
  if (type(id) == ops::Type::Int) {
    const NodeId number = apply(ops::find("intToFloat"), {id});
    return wanted == ops::Type::Float ? number : apply(ops::find("bool"), {number});
  }
  const Op conversion = wanted == ops::Type::Float  ? ops::find("float")
                        : wanted == ops::Type::Bool ? ops::find("bool")
                                                    : ops::find("int");
  return apply(conversion, {id});
}

std::optional<double> Graph::known(NodeId id) const {
  if (isConstant(id)) return value(id);
  if ((is(id, ops::find("bool")) && isConstant(operand(id, 0))) || isKnownInt(id))
    return value(operand(id, 0));
  return std::nullopt;
}

std::optional<NodeId> Graph::fold(Op op, const Operands<NodeId>& operands) {
  const ops::Declaration& info = ops::declaration(op);
  for (int i = 0; i < info.arity; ++i) {
    if (!mayBeKnown[index(node(operands[i]).op)]) return std::nullopt;
  }
  Operands<double> values{};
  for (int i = 0; i < info.arity; ++i) {
    const auto value = known(operands[i]);
    if (!value) return std::nullopt;
    const bool isFloat = info.signature.operands[i] == ops::Type::Float;
    values[i] = ops::isStep(op) && isFloat ? asFloat32(*value) : *value;
  }
  const double result = ops::valueOf(op, values);
  if (!fitsFloat32(result)) return std::nullopt;
  switch (info.signature.result) {
    case ops::Type::Float:
      return constant(result);
    case ops::Type::Bool:
      return intern(Node{{index(constant(result))}, ops::find("bool")});
    case ops::Type::Int:
      return intConstant(result);
  }
  return std::nullopt;
}

NodeId Graph::apply(Op op, Operands<NodeId> operands) {
  if (isFull()) return NodeId(nodes_.size() - 1);
  const ops::Declaration& info = ops::declaration(op);
  for (int i = 0; i < info.arity; ++i) {
    const ops::Type wanted = info.signature.operands[i];
    if (type(operands[i]) != wanted) operands[i] = convert(operands[i], wanted);
  }
  if (simplification_ == Simplification::On) {
    if (const auto folded = fold(op, operands)) return *folded;
    if (const auto simpler = simplify(*this, op, operands)) return *simpler;
  }

  Node node{{}, op};
  for (int i = 0; i < info.arity; ++i) node.operands[i] = index(operands[i]);
  return intern(node);
}

[[gnu::noinline, gnu::cold]] std::optional<NodeId> Graph::findNode(Op op, NodeId x,
                                                                   NodeId y) const {
  const std::uint32_t entry = table_[slotOf({{index(x), index(y)}, op})];
  return entry == 0 ? std::nullopt : std::optional(NodeId{entry - 1});
}

}  // namespace warpjet
