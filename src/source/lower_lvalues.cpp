// Targets of assignments, and reads that don't copy the enclosing value.
#include <algorithm>

#include "source/lower.hpp"

namespace warpjet::source {

namespace {

// Returns the number of elements of an array, a matrix or a vector.
int countOf(Type whole) {
  return whole.isArray() ? whole.length : whole.isMatrix() ? whole.columns : whole.rows;
}

}  // namespace

Lowering::LValue Lowering::lvalue(ExpressionId expression) {
  const Expression& node = tree_.expressions[expression];
  using enum Expression::Kind;
  switch (node.kind) {
    case Part: {
      LValue whole = lvalue(node.operands[0]);
      for (LValue::Choice& choice : whole.choices) choice.first += static_cast<Slot>(node.index);
      whole.type = node.type;
      return whole;
    }
    case Swizzle: {
      LValue whole = lvalue(node.operands[0]);
      std::vector<std::uint8_t> picked;
      for (int i = 0; i < node.type.components(); ++i) {
        const auto k = static_cast<std::uint8_t>(node.index >> (2 * i) & 3);
        picked.push_back(whole.picked.empty() ? k : whole.picked[k]);
      }
      whole.picked = std::move(picked);
      whole.type = node.type;
      return whole;
    }
    case Element: {
      LValue whole = elementOf(lvalue(node.operands[0]), node.operands[1]);
      whole.type = node.type;
      return whole;
    }
    case HostElement:
    case Unsupported:
      evaluate(expression);
      return {{}, node.type};
    default:
      return {{{number(Base::Bool, 1), slotOf(node.index)}}, node.type};
  }
}

Lowering::LValue Lowering::elementOf(LValue whole, ExpressionId expression) {
  if (problems_.any()) return whole;
  const int count = countOf(whole.type);
  const int size = sizeOf(whole.type) / count;
  const Id at = evaluate(expression)[0];
  const bool isKnown = recorder_.isConstant(at);
  const int first =
      isKnown ? static_cast<int>(std::clamp(recorder_.value(at), -1.0, 1.0 * count)) : 0;
  LValue result{{}, whole.type};
  for (const LValue::Choice& choice : whole.choices) {
    for (int i = std::max(first, 0); i < (isKnown ? std::min(first + 1, count) : count); ++i) {
      const Id isThis = scalar(Operator::Equal, recorder_.base(at), at,
                               recorder_.constant(recorder_.base(at), i));
      const Id holds = recorder_.logicalAnd(choice.condition, isThis);
      const auto offset = static_cast<std::size_t>(i) * static_cast<std::size_t>(size);
      if (!recorder_.isFalse(holds)) result.choices.push_back({holds, whole.slot(choice, offset)});
    }
  }
  return result;
}

Lowering::Value Lowering::load(const LValue& from) {
  Value value = undefined(from.type);
  for (const LValue::Choice& choice : from.choices)
    for (std::size_t i = 0; i < value.size(); ++i)
      value[i] = recorder_.choose(choice.condition, store_.get(from.slot(choice, i)), value[i]);
  return value;
}

void Lowering::store(const LValue& to, const Value& value) {
  for (const LValue::Choice& choice : to.choices)
    for (std::size_t i = 0; i < value.size(); ++i) {
      const Slot slot = to.slot(choice, i);
      store_.set(slot, recorder_.choose(choice.condition, value[i], store_.get(slot)));
    }
}

Lowering::Slot Lowering::slotToRead(const Expression& node) {
  const Variable& variable = tree_.variables[node.index];
  if (variable.kind == Variable::Kind::Fragment)
    problems_.add(
        node.location,
        quote(variable.name) +
            " exists only in fragment shaders; a warp moves vertices: use position or uv");
  return slotOf(node.index);
}

// Returns true if the expression has no side effects and is so short that it may be evaluated
// twice.
bool Lowering::isPlain(ExpressionId expression) const {
  const Expression& node = tree_.expressions[expression];
  using enum Expression::Kind;
  switch (node.kind) {
    case Constant:
    case Variable:
      return true;
    case Negate:
    case Plus:
    case Binary:
    case Construct:
      return node.depth < 8 && std::all_of(node.operands.begin(), node.operands.end(),
                                           [&](ExpressionId each) { return isPlain(each); });
    default:
      return false;
  }
}

std::optional<Lowering::Slot> Lowering::knownSlot(const Expression& node) {
  using enum Expression::Kind;
  if (node.kind == Variable) return slotToRead(node);
  if (node.kind != Part && node.kind != Element) return std::nullopt;
  if (node.kind == Element && !isPlain(node.operands[1])) return std::nullopt;
  const std::optional<Slot> whole = knownSlot(tree_.expressions[node.operands[0]]);
  if (!whole) return whole;
  if (node.kind == Part) return *whole + static_cast<Slot>(node.index);
  const Id at = evaluate(node.operands[1])[0];
  if (problems_.any() || !recorder_.isConstant(at)) return std::nullopt;
  // Out-of-range indices are undefined in GLSL; here they are clamped.
  const double last = countOf(tree_.expressions[node.operands[0]].type) - 1;
  const auto i = static_cast<Slot>(std::clamp(recorder_.value(at), 0.0, last));
  return *whole + i * static_cast<Slot>(sizeOf(node.type));
}

}  // namespace warpjet::source
