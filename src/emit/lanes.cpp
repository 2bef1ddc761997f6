#include "emit/lanes.hpp"

#include <algorithm>

namespace warpjet {

namespace {

bool areEqual(const Lanes& lanes) {
  return std::all_of(lanes.begin(), lanes.end(), [&](NodeId id) { return id == lanes[0]; });
}

}  // namespace

void Packs::add(const Lanes& lanes) {
  for (int i = 0; i < lanes.count; ++i)
    places_[index(lanes[i])] = static_cast<std::uint32_t>(lanes_.size()) + i;
  lanes_.resize(lanes_.size() + Lanes::maxCount, noNode);
  std::copy(lanes.begin(), lanes.end(), lanes_.end() - Lanes::maxCount);
  for (const NodeId id : lanes) lengths_.setName(id, Lengths::name + Lengths::member);
}

void Packs::dissolve(std::uint32_t pack) {
  for (const NodeId id : (*this)[pack]) {
    places_[index(id)] = none;
    lengths_.setName(id, Lengths::name);
  }
}

Lanes Packs::operator[](std::uint32_t pack) const {
  Lanes lanes;
  const NodeId* all = &lanes_[pack * Lanes::maxCount];
  while (lanes.count < Lanes::maxCount && all[lanes.count] != noNode) lanes.add(all[lanes.count]);
  return lanes;
}

Lanes Packs::operandsOf(const Lanes& lanes, int i) const {
  Lanes operands;
  for (const NodeId id : lanes) operands.add(graph_.operand(id, i));
  return operands;
}

// Returns true if operand `i` is the same in all lanes, and the operation accepts a scalar for it
// while other operands are vectors. An operation with three operands (clamp, mix) accepts scalars
// only for all the operands in `numbers`, or for none.
bool Packs::takesScalar(const Lanes& lanes, int i) const {
  const ops::SomeOperands numbers = spellingOf(lanes).numbers;
  if ((numbers >> i & 1) == 0) return false;
  for (int other = 0; other < graph_.arity(lanes[0]); ++other) {
    const bool mustBeScalar =
        other == i || (graph_.arity(lanes[0]) == 3 && (numbers >> other & 1) != 0);
    if (mustBeScalar && !areEqual(operandsOf(lanes, other))) return false;
  }
  return true;
}

bool Packs::isPackable(const Lanes& lanes) const {
  for (int i = 0; i < lanes.count; ++i) {
    if (statementOf(lanes[i]) >= unpackable || packOf(lanes[i]) != none) return false;
    if (std::find(lanes.begin(), lanes.begin() + i, lanes[i]) != lanes.begin() + i) return false;
  }
  return true;
}

// Returns true if all lanes are the same operation, and it can be applied to vectors.
bool Packs::isOperation(const Lanes& lanes) const {
  const Op op = graph_.node(lanes[0]).op;
  if (!graph_.isOperation(lanes[0])) return false;
  for (const NodeId id : lanes) {
    if (!graph_.is(id, op)) return false;
  }
  const ops::Declaration& info = ops::declaration(op);
  if (info.signature.result != ops::Type::Float) return false;
  if (!ops::helpers(op, language_).empty()) return false;
  for (int i = 0; i < info.arity; ++i) {
    if (info.signature.operands[i] != ops::Type::Float && !takesScalar(lanes, i)) return false;
  }
  return true;
}

std::uint64_t Packs::placeOf(NodeId id) const {
  if (packOf(id) != none) return std::uint64_t{1} << 60 | places_[index(id)];
  const auto [first, second, unused] = graph_.node(id).operands;
  const auto place = [vector = first](std::uint64_t kind, std::uint32_t part, std::uint32_t i) {
    return kind << 60 | std::uint64_t{part} << 34 | std::uint64_t{vector} << 2 | i;
  };
  if (graph_.isResult(id) && !isStatement(id)) return place(2, second / 4, second % 4);
  if (!graph_.isInput(id) || graph_.input(first).shape.isNumber()) return 0;
  const auto rows = static_cast<std::uint32_t>(graph_.input(first).shape.rows);
  return place(3, second / rows, second % rows);
}

int Packs::vectorSizeOf(NodeId id) const {
  if (packOf(id) != none) return (*this)[packOf(id)].count;
  return graph_.isInput(id) ? graph_.input(graph_.node(id).operands[0]).shape.rows : 0;
}

bool Packs::isPart(const Lanes& lanes) const {
  const std::uint64_t vector = placeOf(lanes[0]) / 4;
  return vector != 0 && std::all_of(lanes.begin(), lanes.end(),
                                    [&](NodeId id) { return placeOf(id) / 4 == vector; });
}

// Terms are visited from last to first.
std::optional<Packs::Factors> Packs::dotProductOf(NodeId sum) const {
  Factors factors;
  for (NodeId rest = sum, term = noNode; term != rest;) {
    const bool isSum = graph_.is(rest, ops::find("add")) && (rest == sum || !isStatement(rest));
    term = isSum ? graph_.operand(rest, 1) : rest;
    if (isSum)
      rest = graph_.operand(rest, 0);
    else if (rest == sum)
      return std::nullopt;
    if (isStatement(term) || !graph_.is(term, ops::find("mult"))) return std::nullopt;
    NodeId a = graph_.operand(term, 0), b = graph_.operand(term, 1);
    if (factors.a.count == Lanes::maxCount) return std::nullopt;
    if (factors.a.count > 0 && placeOf(a) / 4 != placeOf(factors.a[0]) / 4) std::swap(a, b);
    if (placeOf(a) % 4 != placeOf(b) % 4) return std::nullopt;
    factors.a.add(a);
    factors.b.add(b);
    if (!isPart(factors.a) || !isPart(factors.b)) return std::nullopt;
  }
  std::reverse(factors.a.nodes.begin(), factors.a.nodes.begin() + factors.a.count);
  std::reverse(factors.b.nodes.begin(), factors.b.nodes.begin() + factors.b.count);
  return factors;
}

// Returns the factors of a cross product, if the lanes are one: component i is a[i + 1] * b[i + 2]
// - a[i + 2] * b[i + 1], with either factor first.
std::optional<Packs::Factors> Packs::crossProductOf(const Lanes& lanes) const {
  Factors factors;
  if (lanes.count != 3) return std::nullopt;
  factors.a.count = factors.b.count = 3;
  std::uint64_t u = 0, v = 0;  // the vectors
  for (int k = 0; k < 6; ++k) {
    const int i = k / 2, first = (i + 1 + k % 2) % 3, second = 3 - i - first;
    if (!graph_.is(lanes[i], ops::find("sub"))) return std::nullopt;
    const NodeId product = graph_.operand(lanes[i], k % 2);
    if (isStatement(product) || !graph_.is(product, ops::find("mult"))) return std::nullopt;
    NodeId a = graph_.operand(product, 0), b = graph_.operand(product, 1);
    if (k == 0 ? placeOf(a) % 4 != 1 : placeOf(a) / 4 != u) std::swap(a, b);
    if (k == 0) u = placeOf(a) / 4, v = placeOf(b) / 4;
    if (u == 0 || placeOf(a) != u * 4 + first) return std::nullopt;
    if (v == 0 || placeOf(b) != v * 4 + second) return std::nullopt;
    factors.a.nodes[first] = a;
    factors.b.nodes[second] = b;
  }
  return factors;
}

std::optional<Packs::Rotation> Packs::rotationOf(const Lanes& lanes) const {
  if (lanes.count != 2) return std::nullopt;
  Rotation rotation{{}, {noNode, noNode, 0}};
  Matrix& matrix = rotation.matrix;
  std::array<NodeId, 4> factors{noNode, noNode, noNode, noNode};
  for (int k = 0; k < 4; ++k) {
    const NodeId lane = lanes[k / 2];
    if (!graph_.is(lane, ops::find("add")) && !graph_.is(lane, ops::find("sub"))) return {};
    const NodeId product = graph_.operand(lane, k % 2);
    if (isStatement(product) || !graph_.is(product, ops::find("mult"))) return {};
    NodeId wave = graph_.operand(product, 0), factor = graph_.operand(product, 1);
    if (!isNamedSineOrCosine(wave)) std::swap(wave, factor);
    const bool isSine = graph_.is(wave, ops::find("sin"));
    NodeId& known = isSine ? matrix.sine : matrix.cosine;
    if (!isNamedSineOrCosine(wave) || (known != noNode && known != wave)) return {};
    known = wave;
    // The cosine belongs in the column with its row's index, the sine in the other column.
    const int row = k / 2, column = (row == 1) == isSine ? 0 : 1, place = 2 * column + row;
    if (factors[place] != noNode) return {};
    factors[place] = factor;
    if (k % 2 == 1 && graph_.is(lane, ops::find("sub"))) matrix.minus |= 1 << place;
  }
  if (factors[0] != factors[1] || factors[2] != factors[3]) return {};
  if (graph_.operand(matrix.cosine, 0) != graph_.operand(matrix.sine, 0)) return {};
  rotation.point.add(factors[0]);
  rotation.point.add(factors[2]);
  return rotation;
}

const MatrixProduct* Packs::productOf(const Lanes& lanes) const {
  if (lanes.count != 3) return nullptr;
  const auto found = std::find_if(products_.begin(), products_.end(), [&](const auto& product) {
    return std::equal(lanes.begin(), lanes.end(), product.sums.begin());
  });
  return found == products_.end() ? nullptr : &*found;
}

// Returns true for a sine or cosine with its own variable.
bool Packs::isNamedSineOrCosine(NodeId id) const {
  return isStatement(id) && (graph_.is(id, ops::find("sin")) || graph_.is(id, ops::find("cos")));
}

int Packs::operationLength(const Lanes& lanes, int levels) const {
  const int arity = graph_.arity(lanes[0]);
  int total = Lengths::around(spellingOf(lanes), arity);
  for (int i = 0; i < arity; ++i) {
    const auto [form, length] = chooseLayout(operandsOf(lanes, i), As::Operand, levels - 1);
    total += length;
    if (form == Form::Number && !takesScalar(lanes, i)) total += rowStart;
  }
  return total;
}

Packs::Layout Packs::chooseLayout(const Lanes& lanes, As as, int levels) const {
  bool areInline = true;
  if (as == As::Operand) {
    const int first = lengths_.whereRead(lanes[0], levels);
    if (areEqual(lanes)) return {Form::Number, first};
    if (isPart(lanes)) return {Form::Part, first - 1 + lanes.count};
    if (isOptimistic_ && isPackable(lanes)) return {Form::Part, Lengths::name};
    for (const NodeId id : lanes) areInline &= !isStatement(id);
  }
  int row = rowStart + (lanes.count - 1) * separator;
  for (const NodeId id : lanes)
    row +=
        as == As::Operand ? lengths_.whereRead(id, levels) : lengths_.lengthOfOperation(id, levels);
  // Matrix products are only recorded if they pay off.
  if (areInline && productOf(lanes)) return {Form::Operation, 0};
  if (levels > 0 && areInline) {
    if (const auto rotation = rotationOf(lanes)) {
      const int together =
          rotationStart + chooseLayout(rotation->point, As::Operand, levels - 1).length;
      if (together <= row) return {Form::Operation, together};
    }
  }
  if (levels > 0 && areInline && isOperation(lanes)) {
    const int together = operationLength(lanes, levels);
    if (together + margin <= row) return {Form::Operation, together};
  }
  return {Form::Row, row};
}

int Packs::gainOf(const Lanes& lanes, int length) const {
  // The length of a statement without its expression: `  float t12 = ;` and the line's end, or
  // `  vec3 …`.
  constexpr int statementOverhead = 15;
  int gain = -statementOverhead - length;
  for (const NodeId id : lanes) gain += statementOverhead + lengthOfStatement(id);
  return gain;
}

}  // namespace warpjet
