// Lowers expressions to the numbers of their values.
#include <algorithm>
#include <string>

#include "source/lower.hpp"

namespace warpjet::source {

Lowering::Value Lowering::evaluate(ExpressionId number) {
  const Expression& node = tree_.expressions[number];
  if (exceedsLimits(node.location)) return undefined(node.type);
  ++depth_;
  Value value = evaluateInner(node);
  --depth_;
  // Values of thousands of numbers count as several steps, so that their calls are limited, too.
  steps_ += value.size() / 64;
  return problems_.any() ? undefined(node.type) : value;
}

Lowering::Value Lowering::evaluateInner(const Expression& node) {
  using enum Expression::Kind;
  const auto operand = [&](std::size_t i) { return evaluate(node.operands[i]); };
  switch (node.kind) {
    case Constant:
      return {recorder_.constant(node.type.base, node.value)};
    case Variable:
      return get(slotToRead(node), sizeOf(node.type));
    case Part:
      return part(node);
    case Swizzle: {
      const Value whole = operand(0);
      Value picked;
      for (int i = 0; i < node.type.components(); ++i)
        picked.push_back(whole[node.index >> (2 * i) & 3]);
      return picked;
    }
    case Element:
      return element(node);
    case Negate: {
      Value value = operand(0);
      const Base base = node.type.base;
      for (Id& x : value)
        x = base == Base::Float ? recorder_.apply(Code::Neg, base, {x})
                                : recorder_.apply(Code::IntSub, base, {number(base, 0), x});
      return value;
    }
    case Plus:
      return operand(0);
    case Not:
      return {recorder_.logicalNot(operand(0)[0])};
    case Complement: {
      Value value = operand(0);
      for (Id& x : value) x = recorder_.apply(Code::BitNot, node.type.base, {x});
      return value;
    }
    case Increment:
      return increment(node);
    case Binary:
      return chain(node);
    case Choose:
      return choice(node);
    case Assign:
      return assign(node);
    case Sequence:
      operand(0);
      return operand(1);
    case Construct:
      return construct(node);
    case Call:
      return callOf(node);
    case BuiltIn:
      return builtIn(node);
    case HostElement:
      return hostElement(node);
    case Unsupported:
      problems_.add(node.location, tree_.reasons[node.index]);
      return undefined(node.type);
  }
  return {};
}

// Evaluates a chain of operators. Follows left operands iteratively, so that sums of thousands of
// terms don't recurse.
Lowering::Value Lowering::chain(const Expression& node) {
  std::vector<const Expression*> way;
  const Expression* first = &node;
  const auto isLogical = [](const Expression& each) {
    return each.op == Operator::And || each.op == Operator::Or;
  };
  if (isLogical(node)) return logical(node);
  while (first->kind == Expression::Kind::Binary && !isLogical(*first)) {
    way.push_back(first);
    first = &tree_.expressions[first->operands[0]];
  }
  Value left = evaluate(way.back()->operands[0]);
  for (std::size_t i = way.size(); i-- > 0 && !problems_.any();) {
    const Type a = tree_.expressions[way[i]->operands[0]].type,
               b = tree_.expressions[way[i]->operands[1]].type;
    left = binary(way[i]->op, a, left, b, evaluate(way[i]->operands[1]));
  }
  return left;
}

// Evaluates && and ||: the second operand, with its side effects, only if the first doesn't decide.
Lowering::Value Lowering::logical(const Expression& node) {
  std::vector<const Expression*> way;
  const Expression* first = &node;
  while (first->kind == Expression::Kind::Binary && first->op == node.op) {
    way.push_back(first);
    first = &tree_.expressions[first->operands[0]];
  }
  const bool isAnd = node.op == Operator::And;
  Id value = condition(way.back()->operands[0]);
  for (std::size_t i = way.size(); i-- > 0 && !problems_.any();) {
    const ExpressionId right = way[i]->operands[1];
    Id other = number(Base::Bool, 0);
    const auto run = [&] { other = condition(right); };
    const auto leave = [&] {};
    const Id before = value;
    if (isAnd) {
      if (!recorder_.isFalse(before)) branch(before, run, leave);
      value = recorder_.logicalAnd(before, other);
    } else {
      if (!recorder_.isTrue(before)) branch(before, leave, run);
      value = recorder_.logicalOr(before, other);
    }
  }
  return {value};
}

Lowering::Value Lowering::choice(const Expression& node) {
  const Id test = condition(node.operands[0]);
  Value yes = undefined(node.type), no = yes;
  branch(
      test, [&] { yes = evaluate(node.operands[1]); }, [&] { no = evaluate(node.operands[2]); });
  for (std::size_t i = 0; i < yes.size(); ++i) yes[i] = recorder_.choose(test, yes[i], no[i]);
  return yes;
}

Lowering::Value Lowering::assign(const Expression& node) {
  const Expression& target = tree_.expressions[node.operands[0]];
  const Type type = tree_.expressions[node.operands[1]].type;
  const LValue assigned = lvalue(node.operands[0]);
  Value value = evaluate(node.operands[1]);
  if (node.isCombined) value = binary(node.op, target.type, load(assigned), type, value);
  if (!problems_.any()) store(assigned, value);
  return value;
}

Lowering::Value Lowering::increment(const Expression& node) {
  const LValue assigned = lvalue(node.operands[0]);
  const Value before = load(assigned);
  Value after = before;
  for (Id& x : after) x = scalar(node.op, node.type.base, x, number(node.type.base, 1));
  store(assigned, after);
  return node.index ? before : after;
}

Lowering::Value Lowering::construct(const Expression& node) {
  const Type type = node.type;
  std::vector<Value> operands;
  for (const ExpressionId operand : node.operands) operands.push_back(evaluate(operand));
  const auto join = [&] {
    Value all;
    for (const Value& operand : operands) all.insert(all.end(), operand.begin(), operand.end());
    return all;
  };
  if (type.isArray() || type.isStruct()) return join();
  const Type first = tree_.expressions[node.operands[0]].type;
  const Id zero = number(type.base, 0), one = number(type.base, 1);
  if (operands.size() == 1 && type.isMatrix() && (first.isScalar() || first.isMatrix())) {
    Value matrix;
    for (int c = 0; c < type.columns; ++c)
      for (int r = 0; r < type.rows; ++r) {
        const bool isInside = first.isMatrix() && c < first.columns && r < first.rows;
        const Id unit = c != r             ? zero
                        : first.isScalar() ? recorder_.convert(operands[0][0], type.base)
                                           : one;
        matrix.push_back(isInside ? operands[0][c * first.rows + r] : unit);
      }
    return matrix;
  }
  Value all = join();
  if (operands.size() == 1 && first.isScalar()) all.assign(type.components(), operands[0][0]);
  all.resize(static_cast<std::size_t>(type.components()), zero);
  for (Id& x : all) x = recorder_.convert(x, type.base);
  return all;
}

Lowering::Value Lowering::callOf(const Expression& node) {
  const Function& function = tree_.functions[node.index];
  std::vector<Value> arguments;
  std::vector<LValue> targets;
  for (std::size_t i = 0; i < node.operands.size(); ++i) {
    if (function.parameters[i].direction == Parameter::Direction::In) {
      arguments.push_back(evaluate(node.operands[i]));
    } else {
      targets.push_back(lvalue(node.operands[i]));
      arguments.push_back(load(targets.back()));
    }
  }
  if (problems_.any()) return undefined(node.type);
  return call(node.index, std::move(arguments), targets, node.location);
}

Lowering::Value Lowering::part(const Expression& node) {
  if (const auto slot = knownSlot(node)) return get(*slot, sizeOf(node.type));
  const Value whole = evaluate(node.operands[0]);
  if (problems_.any()) return undefined(node.type);
  const auto first = whole.begin() + node.index;
  return {first, first + sizeOf(node.type)};
}

Lowering::Value Lowering::element(const Expression& node) {
  if (const auto slot = knownSlot(node)) return get(*slot, sizeOf(node.type));
  const Value whole = evaluate(node.operands[0]);
  const Id at = evaluate(node.operands[1])[0];
  if (problems_.any()) return undefined(node.type);
  const int size = sizeOf(node.type);
  std::vector<Value> elements;
  for (std::size_t i = 0; i + size <= whole.size(); i += size)
    elements.emplace_back(whole.begin() + static_cast<std::ptrdiff_t>(i),
                          whole.begin() + static_cast<std::ptrdiff_t>(i + size));
  return pick(elements, at);
}

// Declares an element of a storage buffer as an external. Its name contains its indices, which may
// be known only if loops are unrolled.
Lowering::Value Lowering::hostElement(const Expression& node) {
  std::string name = tree_.made[static_cast<std::size_t>(node.index)];
  std::size_t from = 0;
  for (const ExpressionId each : node.operands) {
    const Id at = evaluate(each)[0];
    const std::size_t open = name.find("[]", from);
    if (!problems_.any() && !recorder_.isConstant(at))
      problems_.add(tree_.expressions[each].location,
                    "the index of " + name.substr(0, open) +
                        ", an array without a length, must be a constant in a warp, or "
                        "follow from the counter of a loop with constant bounds");
    if (problems_.any()) return undefined(node.type);
    const std::string number =
        std::to_string(static_cast<std::int64_t>(std::max(recorder_.value(at), 0.0)));
    name.insert(open + 1, number);
    from = open + number.size();
  }
  const auto known = hostElements_.find(name);
  if (known != hostElements_.end()) return known->second;
  std::vector<Id> leaves;
  addExternal(name, node.type, false, leaves);
  return hostElements_[name] = leaves;
}

// Returns the element with an index. Out-of-range indices are undefined in GLSL; here they are
// clamped.
Lowering::Value Lowering::pick(const std::vector<Value>& elements, Id index) {
  const auto last = static_cast<int>(elements.size()) - 1;
  if (recorder_.isConstant(index)) {
    const double at = recorder_.value(index);
    return elements[at < 0 ? 0 : at > last ? last : static_cast<int>(at)];
  }
  const Base base = recorder_.base(index);
  Value value = elements[last];
  for (int i = last; i-- > 0;) {
    const Id isBefore = scalar(Operator::Less, base, index, number(base, i + 1));
    for (std::size_t k = 0; k < value.size(); ++k)
      value[k] = recorder_.choose(isBefore, elements[i][k], value[k]);
  }
  return value;
}

}  // namespace warpjet::source
