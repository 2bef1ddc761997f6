// Writes patterns in readable form, for tests and the documentation.
#pragma once

#include <cstdio>
#include <string>

#include "graph/pattern.hpp"

namespace warpjet::patterns {

namespace detail {

// Returns true for a minus, which gets its own parentheses: in shader code, a minus may move out of
// a product, but the text of a pattern shows where it is.
inline bool isMinus(const Item& item) { return item.is(ops::find("neg")); }

inline ops::Precedence precedence(const Item& item) {
  if (item.kind != Kind::Operation) return ops::Precedence::Primary;
  return isMinus(item) ? ops::Precedence::Unary
                       : ops::spelling(item.op(), ops::Language::Glsl300).result;
}

inline std::string literalText(const Item& item) {
  if (item.type == ops::Type::Bool) return item.value != 0 ? "true" : "false";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", item.value);
  return text.data();
}

inline std::string text(const Item* item) {
  if (item->isVariable()) return {static_cast<char>('a' + item->number)};
  if (item->kind == Kind::Literal) return literalText(*item);
  if (item->kind == Kind::Function)
    return std::string(item->function->name) + "(" + text(item + 1) + ")";
  const ops::Spelling& spelling = ops::spelling(item->op(), ops::Language::Glsl300);
  std::array<const Item*, ops::maxArity> operands{item + 1};
  for (std::size_t i = 1; i < operands.size(); ++i)
    operands[i] = operands[i - 1] + operands[i - 1]->size;
  std::string all;
  for (std::size_t i = 0; i < spelling.text.size(); ++i) {
    if (spelling.text[i] != '$') {
      all += spelling.text[i];
      continue;
    }
    const auto place = static_cast<std::size_t>(spelling.text[++i] - '0');
    const Item& operand = *operands[place];
    const ops::Precedence needed =
        isMinus(*item) ? ops::Precedence::Primary : spelling.operands[place];
    const bool isLoose = precedence(operand) < needed;
    all += isLoose ? "(" + text(&operand) + ")" : text(&operand);
  }
  return all;
}

}  // namespace detail

inline std::string text(const Pattern& pattern) { return detail::text(pattern.items.data()); }

inline std::string text(const Identity& identity) {
  std::string all = text(identity.from) + " becomes " + text(identity.to);
  if (identity.hasCondition()) all += " if " + text(identity.when);
  return all;
}

}  // namespace warpjet::patterns
