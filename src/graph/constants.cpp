// Constants of a graph, and operations on nothing else.
#include <cmath>
#include <cstring>
#include <limits>

#include "graph/graph.hpp"

namespace warpjet {

namespace {

// std::bit_cast, which Emscripten 3.1.6 lacks.
template <class To, class From>
To bitCast(From from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(&to, &from, sizeof to);
  return to;
}

// By operation, whether `known` may have a value of it: most operands are none, and are seen so by
// one byte.
constexpr auto mayBeKnown = [] {
  std::array<bool, arities.size()> all{};
  for (const Op op : {constantOp, ops::find("bool"), ops::find("int")}) all[index(op)] = true;
  return all;
}();

// A constant as a shader reads it.
double asFloat32(double value) { return static_cast<double>(static_cast<float>(value)); }

bool fitsFloat32(double value) {
  return std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());
}

}  // namespace

NodeId Graph::constant(double value) {
  const auto bits = bitCast<std::uint64_t>(value);
  return intern(
      {{static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits >> 32)}, constantOp});
}

NodeId Graph::whole(double value) {
  return intern(Node{{index(constant(value))}, ops::find("int")});
}

double Graph::value(NodeId constant) const {
  const auto& words = node(constant).operands;
  return bitCast<double>(words[0] | std::uint64_t{words[1]} << 32);
}

bool Graph::isConstant(NodeId id, double value) const {
  return isConstant(id) && this->value(id) == value;
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
      return whole(result);
  }
  return std::nullopt;
}

}  // namespace warpjet
