// What is assigned to.
#include "glsl/lower.hpp"

namespace warpjet::glsl {

Lowering::Home Lowering::home(Number expression) {
  const Expression& node = tree_.expressions[expression];
  using enum Expression::Kind;
  switch (node.kind) {
    case Part:
      return partOf(home(node.operands[0]), node.index, node.type);
    case Swizzle: {
      Home whole = home(node.operands[0]);
      for (Home::Choice& choice : whole.choices) {
        std::vector<Slot> picked;
        for (int i = 0; i < node.type.components(); ++i)
          picked.push_back(choice.slots[node.index >> (2 * i) & 3]);
        choice.slots = std::move(picked);
      }
      whole.type = node.type;
      return whole;
    }
    case Element: {
      Home whole = home(node.operands[0]);
      whole = elementOf(std::move(whole), node.operands[1]);
      whole.type = node.type;
      return whole;
    }
    default: {
      std::vector<Slot> slots;
      for (int i = 0; i < sizeOf(node.type); ++i) slots.push_back(slotOf(node.index) + i);
      return {{{number(Base::Bool, 1), std::move(slots)}}, node.type};
    }
  }
}

Lowering::Home Lowering::partOf(Home home, int offset, Type type) const {
  for (Home::Choice& choice : home.choices)
    choice.slots = {choice.slots.begin() + offset, choice.slots.begin() + offset + sizeOf(type)};
  home.type = type;
  return home;
}

Lowering::Home Lowering::elementOf(Home home, Number expression) {
  const Type whole = home.type;
  const int count = whole.isArray() ? whole.length : whole.isMatrix() ? whole.columns : whole.rows;
  const int size = sizeOf(whole) / count;
  const Id at = evaluate(expression)[0];
  Home result{{}, whole};
  for (const Home::Choice& choice : home.choices) {
    for (int i = 0; i < count; ++i) {
      const Id isThis = scalar(Operator::Equal, recorder_.base(at), at,
                               recorder_.constant(recorder_.base(at), i));
      const Id holds = recorder_.both(choice.condition, isThis);
      if (recorder_.isFalse(holds)) continue;
      result.choices.push_back(
          {holds, {choice.slots.begin() + i * size, choice.slots.begin() + (i + 1) * size}});
    }
  }
  return result;
}

Lowering::Value Lowering::load(const Home& home) {
  Value value = undefined(home.type);
  for (const Home::Choice& choice : home.choices)
    for (std::size_t i = 0; i < value.size(); ++i)
      value[i] = recorder_.choose(choice.condition, store_.get(choice.slots[i]), value[i]);
  return value;
}

void Lowering::store(const Home& home, const Value& value) {
  for (const Home::Choice& choice : home.choices)
    for (std::size_t i = 0; i < value.size(); ++i) {
      const Slot slot = choice.slots[i];
      store_.set(slot, recorder_.choose(choice.condition, value[i], store_.get(slot)));
    }
}

}  // namespace warpjet::glsl
