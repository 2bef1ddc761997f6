// The spelling of operations in each language.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "ops/types.hpp"

namespace warpjet::ops {

// From lowest to highest precedence, as in GLSL ES 3.00, section 5.1.
enum class Precedence : std::uint8_t {
  Ternary,
  Logical,
  Equality,
  Relational,
  Additive,
  Multiplicative,
  Unary,
  Primary,
};

// A subset of the operands, as bits.
using SomeOperands = std::uint8_t;
inline constexpr SomeOperands noOperand = 0, firstOperand = 1, secondOperand = 2, thirdOperand = 4;

// The code of an operation; `$0`, `$1`, `$2` stand for the operands. An operand of lower precedence
// than its `operands` entry gets parentheses. If the text is empty, the language lacks the
// operation. The same text applies an operation to vectors, where the operands in `numbers` may
// stay scalars: with two operands either one, with three either all of them or none.
struct Spelling {
  std::string_view text;
  Precedence result = Precedence::Primary;
  Operands<Precedence> operands{};
  SomeOperands numbers = noOperand;

  constexpr bool isMissing() const { return text.empty(); }
};

enum class Language : std::uint8_t { Glsl300, Glsl100, Wgsl };

inline constexpr int languageCount = static_cast<int>(Language::Wgsl) + 1;  // Wgsl is the last one

// The spelling in each language; the same in all for most operations.
struct Spellings {
  std::array<Spelling, languageCount> byLanguage;

  constexpr Spellings(Spelling spelling) : byLanguage{} { byLanguage.fill(spelling); }

  constexpr const Spelling& in(Language language) const {
    return byLanguage[static_cast<std::size_t>(language)];
  }

  constexpr Spellings with(Language language, std::string_view text,
                           SomeOperands numbers = noOperand) const {
    Spellings other = *this;
    other.byLanguage[static_cast<std::size_t>(language)] = {text, Precedence::Primary, {}, numbers};
    return other;
  }

  // Replaces the text, but keeps the precedence.
  constexpr Spellings withText(Language language, std::string_view text) const {
    Spellings other = *this;
    other.byLanguage[static_cast<std::size_t>(language)].text = text;
    return other;
  }

  // A row with a missing spelling must define how it is lowered, or the language rejects it.
  constexpr Spellings missingIn(Language language) const { return with(language, ""); }
};

constexpr Spellings call(std::string_view text, SomeOperands numbers = noOperand) {
  return Spelling{text, Precedence::Primary, {}, numbers};
}

// For built-in functions that are inaccurate: the operation is lowered in every language.
inline constexpr Spellings nowhere = Spelling{""};

// Spells a left-associative operator: a left operand of the same precedence needs no parentheses, a
// right one does. They matter, since floating-point addition isn't associative.
constexpr Spellings infix(std::string_view text, Precedence level) {
  const auto tighter = static_cast<Precedence>(static_cast<int>(level) + 1);
  return Spelling{text, level, {level, tighter, tighter}, firstOperand | secondOperand};
}

// Spells && and ||, which WGSL doesn't allow to be mixed without parentheses.
constexpr Spellings logical(std::string_view text) {
  return Spelling{text, Precedence::Logical, {Precedence::Equality, Precedence::Equality, {}}};
}

// `-x * y` is (-x) * y, which is exactly -(x * y), so a negated product needs no parentheses.
inline constexpr Spellings negation =
    Spelling{"-$0", Precedence::Multiplicative, {Precedence::Multiplicative, {}, {}}};

// Spells a bitwise operator. Operands that are not primary expressions get parentheses, as WGSL
// requires.
constexpr Spellings bits(std::string_view text) {
  return Spelling{text, Precedence::Logical, {Precedence::Unary, Precedence::Unary, {}}};
}

inline constexpr Spellings logicalNegation =
    Spelling{"!$0", Precedence::Unary, {Precedence::Unary, {}, {}}};

inline constexpr Spellings conditional =
    Spellings(Spelling{"$0 ? $1 : $2",
                       Precedence::Ternary,
                       {Precedence::Logical, Precedence::Logical, Precedence::Logical},
                       firstOperand})
        .with(Language::Wgsl, "select($2, $1, $0)", firstOperand);

}  // namespace warpjet::ops
