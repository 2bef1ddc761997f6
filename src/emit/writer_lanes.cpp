// The part of Writer that writes vectors.
#include <algorithm>
#include <utility>

#include "emit/writer.hpp"

namespace warpjet {

void Writer::writeLanes(std::string& text, const Lanes& lanes, Packs::As as,
                        ops::Precedence loosest) {
  const auto form = packs_.chooseLayout(lanes, as).form;
  if (form == Packs::Form::Part) return writePart(text, lanes);
  if (form == Packs::Form::Operation) return writeOperation(text, lanes, loosest);
  const std::span all(lanes.begin(), form == Packs::Form::Number ? 1 : lanes.count);
  writeRow(text, vectorOf(lanes.count), all, as);
}

// Equal components are written as one number, and adjacent components of a vector as a swizzle.
void Writer::writeRow(std::string& text, Shape shape, std::span<const NodeId> all, Packs::As as) {
  std::string values;
  std::span<const NodeId> rest = all;
  while (!rest.empty()) {
    if (!values.empty()) values += ", ";
    std::size_t count = 1;
    const bool mayUseSwizzles = shape.isVector() && as == Packs::As::Operand;
    while (mayUseSwizzles && count < rest.size() && packs_.isPart(Lanes(rest.first(count + 1))))
      ++count;
    if (count > 1)
      writePart(values, Lanes(rest.first(count)));
    else
      as == Packs::As::Statement ? writeOperation(values, rest[0]) : write(values, rest[0]);
    rest = rest.subspan(count);
  }
  appendExpanded(text, all.size() == 1 ? dialect_.splat : dialect_.construction,
                 {dialect_.typeName(graph_.type(all[0]), shape), values});
}

void Writer::writeOperation(std::string& text, const Lanes& lanes, ops::Precedence loosest) {
  if (const MatrixProduct* product = packs_.productOf(lanes)) return writeProduct(text, *product);
  if (const auto factors = packs_.crossProductOf(lanes))
    return writeProduct(text, "cross(", *factors);
  if (const auto rotation = packs_.rotationOf(lanes))
    return writeRotation(text, *rotation, loosest);
  const ops::Spelling& spelling = spellingOf(lanes[0]);
  const bool parenthesized = spelling.result < loosest;
  if (parenthesized) text += '(';
  std::string_view rest = spelling.text;
  for (std::size_t dollar; (dollar = rest.find('$')) != rest.npos;) {
    text += rest.substr(0, dollar);
    const int i = rest[dollar + 1] - '0';
    rest.remove_prefix(dollar + 2);
    const Lanes operands = packs_.operandsOf(lanes, i);
    if (packs_.takesScalar(lanes, i)) {
      open(text, operands[0], spelling.operands[i]);
      writePending(text);
    } else {
      writeLanes(text, operands, Packs::As::Operand, spelling.operands[i]);
    }
  }
  text += rest;
  if (parenthesized) text += ')';
}

// Writes the first lane, such as v.x, then replaces what follows the last dot.
void Writer::writePart(std::string& text, const Lanes& lanes) {
  open(text, lanes[0], ops::Precedence::Primary);
  text.pop_back();
  bool isWhole = packs_.vectorSizeOf(lanes[0]) == lanes.count;
  for (int i = 0; i < lanes.count; ++i) {
    const int component = static_cast<int>(packs_.placeOf(lanes[i]) % 4);
    text += "xyzw"[component];
    isWhole &= component == i;
  }
  if (isWhole) text.resize(text.size() - lanes.count - 1);
}

void Writer::writeRotation(std::string& text, const Packs::Rotation& rotation,
                           ops::Precedence loosest) {
  const bool parenthesized = ops::Precedence::Multiplicative < loosest;
  if (parenthesized) text += '(';
  const std::uint32_t found = find(rotation.matrix);
  if (found != none && matrices_[found].name < wanted)
    text += texts_[matrices_[found].name];
  else
    writeMatrix(text, rotation.matrix);
  text += " * ";
  writeLanes(text, rotation.point, Packs::As::Operand, ops::Precedence::Unary);
  if (parenthesized) text += ')';
}

std::uint32_t Writer::find(const Packs::Matrix& matrix) const {
  if (matrices_.empty()) return none;
  std::uint32_t i = lastMatrixOf_[index(matrix.cosine)];
  while (i != none && !(matrices_[i].matrix == matrix)) i = matrices_[i].previous;
  return i;
}

// A matrix counted in an enclosing body is reused only if it already has a name there.
void Writer::countMatrix(const Packs::Matrix& matrix, std::size_t first) {
  lastMatrixOf_.resize(graph_.size(), none);
  const std::uint32_t found = find(matrix);
  if (found != none && (found >= first || matrices_[found].name < wanted)) {
    matrices_[found].name = std::min(matrices_[found].name, wanted);
    return;
  }
  std::uint32_t& last = lastMatrixOf_[index(matrix.cosine)];
  matrices_.push_back({matrix, last, none});
  last = static_cast<std::uint32_t>(matrices_.size() - 1);
}

bool Writer::wantsName(const Packs::Matrix& matrix) const {
  const std::uint32_t found = find(matrix);
  return found != none && matrices_[found].name == wanted;
}

void Writer::nameMatrix(const Packs::Matrix& matrix, std::string name) {
  matrices_[find(matrix)].name = static_cast<std::uint32_t>(texts_.size());
  texts_.push_back(std::move(name));
}

void Writer::forgetMatrices(std::size_t first) {
  for (; matrices_.size() > first; matrices_.pop_back())
    lastMatrixOf_[index(matrices_.back().matrix.cosine)] = matrices_.back().previous;
}

void Writer::writeMatrix(std::string& text, const Packs::Matrix& matrix) {
  std::string entries;
  for (int i = 0; i < 4; ++i) {
    if (i > 0) entries += ", ";
    if (matrix.minus >> i & 1) entries += '-';
    write(entries, i % 3 == 0 ? matrix.cosine : matrix.sine);
  }
  appendExpanded(text, dialect_.construction,
                 {dialect_.typeName(ops::Type::Float, matrixOf(2, 2)), entries});
}

// dot and cross have the same names in all languages; see names.cpp.
void Writer::writeProduct(std::string& text, std::string_view name, const Packs::Factors& factors) {
  text += name;
  writePart(text, factors.a);
  text += ", ";
  writePart(text, factors.b);
  text += ')';
}

// Needs no parentheses: products are found only where a vector is normalized, which reads each sum
// twice, so that each sum has its own statement.
void Writer::writeProduct(std::string& text, const MatrixProduct& product) {
  std::string entries;
  for (const auto& [factor, isMinus] : product.entries) {
    if (!entries.empty()) entries += ", ";
    if (isMinus) entries += '-';
    open(entries, factor, isMinus ? ops::Precedence::Unary : ops::Precedence::Ternary);
    writePending(entries);
  }
  text += inputNames_[product.vector] + " * ";
  appendExpanded(text, dialect_.construction,
                 {dialect_.typeName(ops::Type::Float, matrixOf(3, 3)), entries});
}

}  // namespace warpjet
