// The identities, arranged by the compiler for matching: all items in one array, the rules of an
// operation side by side, and for each of its operands the rules that the operand can match.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "graph/graph.hpp"
#include "graph/identities.hpp"

namespace warpjet::patterns {

// An identity, or its mirror image for a sum or product: the offsets of its patterns in `items`.
struct Rule {
  std::uint8_t identity;
  bool hasCondition;
  std::uint16_t from, to, when;
};

// Numbers the kinds of an operand: its operation, one of the numbers that occur in identities, or
// another negative number.
inline constexpr std::array<double, 3> namedNumbers{0, 1, -1};
inline constexpr std::size_t negativeNumber = arities.size() + namedNumbers.size();
inline constexpr std::size_t operandKinds = negativeNumber + 1;

inline std::size_t kindOf(const Graph& graph, NodeId id) {
  if (!graph.isConstant(id)) return index(graph.node(id).op);
  const double number = graph.value(id);
  for (std::size_t i = 0; i < namedNumbers.size(); ++i) {
    if (number == namedNumbers[i]) return arities.size() + i;
  }
  return number < 0 ? negativeNumber : index(constantOp);
}

// The rules that replace an operation, starting at `first`. `candidates` has one bit per rule, set
// if the rule can match an operand of that kind in that place; `ofEqual` marks rules that match
// only if the first two operands are the same node.
struct Bucket {
  std::uint8_t first = 0;
  std::uint32_t ofEqual = 0;
  std::array<std::array<std::uint32_t, operandKinds>, ops::maxArity> candidates{};
};

namespace detail {

constexpr Pattern swapOperands(const Pattern& pattern) {
  Pattern other = pattern;
  const std::size_t first = pattern.items[1].size, second = pattern.size() - 1 - first;
  for (std::size_t i = 0; i < second; ++i) other.items[1 + i] = pattern.items[1 + first + i];
  for (std::size_t i = 0; i < first; ++i) other.items[1 + second + i] = pattern.items[1 + i];
  return other;
}

// Returns true if the patterns are equal up to the names of variables.
constexpr bool areAlike(const Pattern& p, const Pattern& q) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Item &left = p.items[i], &right = q.items[i];
    if (left.kind != right.kind || left.size != right.size || left.value != right.value)
      return false;
    if (left.kind == Kind::Operation && left.number != right.number) return false;
  }
  return true;
}

// Returns false if swapping the operands of the root is pointless: a constant always comes last, or
// the swapped order has its own row.
constexpr bool matchesSwapped(const Pattern& pattern) {
  const Item& root = pattern.root();
  if (!ops::has(root.op(), ops::Trait::Commutative)) return false;
  if (pattern.items[1 + pattern.items[1].size].isKnown) return false;
  const Pattern other = swapOperands(pattern);
  for (const Identity& identity : identities) {
    if (areAlike(identity.from, other)) return false;
  }
  return true;
}

constexpr bool isNamedNumber(std::size_t kind) {
  return kind >= arities.size() && kind < negativeNumber;
}

constexpr bool isNegative(std::size_t kind) {
  return kind == negativeNumber || (isNamedNumber(kind) && namedNumbers[kind - arities.size()] < 0);
}

// Returns true if the condition is that the constant is negative: a < 0.
constexpr bool requiresNegative(const Pattern& when, const Item& constant) {
  const Item &left = when.items[1], &right = when.items[2];
  return when.root().is(ops::find("lt")) && left.isVariable() && left.number == constant.number &&
         right.kind == Kind::Literal && right.value == 0;
}

// Returns true if the item can match an operand of this kind, in an identity with the condition
// `when`.
constexpr bool canMatch(const Item& item, const Pattern& when, std::size_t kind) {
  const bool isConstant = kind >= arities.size() || kind == index(constantOp);
  switch (item.kind) {
    case Kind::Computed:
      return !isConstant;
    case Kind::Constant:
      return isConstant && (isNegative(kind) || !requiresNegative(when, item));
    case Kind::Literal:
      if (item.type == ops::Type::Bool) return kind == index(ops::find("bool"));
      return isNamedNumber(kind) && item.value == namedNumbers[kind - arities.size()];
    case Kind::Operation:
      return kind == index(item.op());
    default:
      return true;
  }
}

// Returns true if all numbers that are operands of the root are among `namedNumbers`.
constexpr bool namesNumbers(const Pattern& pattern) {
  for (std::size_t item = 1; item < pattern.size(); item += pattern.items[item].size) {
    const Item& operand = pattern.items[item];
    bool isNamed = operand.kind != Kind::Literal || operand.type == ops::Type::Bool;
    for (const double number : namedNumbers) isNamed = isNamed || operand.value == number;
    if (!isNamed) return false;
  }
  return true;
}

constexpr bool allNameNumbers() {
  for (const Identity& identity : identities) {
    if (!namesNumbers(identity.from)) return false;
  }
  return true;
}
static_assert(allNameNumbers(), "namedNumbers lacks a number that is an operand in identities.hpp");

// Calls `visit` with the number and pattern of each identity that replaces the operation.
template <class Visit>
constexpr void forEachRule(Op op, Visit visit) {
  for (std::size_t i = 0; i < identities.size(); ++i) {
    if (!identities[i].from.root().is(op)) continue;
    visit(i, identities[i].from);
    if (matchesSwapped(identities[i].from)) visit(i, swapOperands(identities[i].from));
  }
}

struct Sizes {
  std::size_t items = 0, rules = 0, buckets = 0;
};

inline constexpr Sizes sizes = [] {
  Sizes all;
  for (std::size_t op = 0; op < ops::count; ++op) {
    const std::size_t before = all.rules;
    forEachRule(Op(op), [&](std::size_t i, const Pattern& from) {
      all.items += from.size() + identities[i].to.size() + identities[i].when.size();
      ++all.rules;
    });
    all.buckets += all.rules != before;
  }
  return all;
}();

}  // namespace detail

struct Rules {
  static constexpr std::uint8_t noBucket = 255;

  std::array<Item, detail::sizes.items> items{};
  std::array<Rule, detail::sizes.rules> all{};
  std::array<Bucket, detail::sizes.buckets> buckets{};
  std::array<std::uint8_t, ops::count> bucketOf{};
};

inline constexpr Rules rules = [] {
  Rules result;
  std::size_t items = 0, count = 0, buckets = 0;
  const auto add = [&](const Pattern& pattern) {
    const auto first = static_cast<std::uint16_t>(items);
    for (std::size_t i = 0; i < pattern.size(); ++i) result.items[items++] = pattern.items[i];
    return first;
  };
  for (std::size_t op = 0; op < ops::count; ++op) {
    Bucket bucket{static_cast<std::uint8_t>(count)};
    detail::forEachRule(Op(op), [&](std::size_t i, const Pattern& from) {
      const std::uint32_t bit = std::uint32_t{1} << (count - bucket.first);
      const Item &left = from.items[1], &right = from.items[1 + left.size];
      if (left.isVariable() && right.isVariable() && left.number == right.number)
        bucket.ofEqual |= bit;
      std::size_t item = 1;
      for (int place = 0; place < ops::declarations[op].arity; ++place) {
        for (std::size_t kind = 0; kind < operandKinds; ++kind) {
          if (detail::canMatch(from.items[item], identities[i].when, kind))
            bucket.candidates[place][kind] |= bit;
        }
        item += from.items[item].size;
      }
      result.all[count++] = {static_cast<std::uint8_t>(i), identities[i].hasCondition(), add(from),
                             add(identities[i].to), add(identities[i].when)};
    });
    const bool hasRules = count != bucket.first;
    result.bucketOf[op] = hasRules ? static_cast<std::uint8_t>(buckets) : Rules::noBucket;
    if (hasRules) result.buckets[buckets++] = bucket;
  }
  return result;
}();

}  // namespace warpjet::patterns
