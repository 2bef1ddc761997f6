// How operations are written in each language.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "ops/types.hpp"

namespace warpjet::ops {

// From the loosest binding to the tightest, as in GLSL ES 3.00, section 5.1.
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

// Some of the operands, by bits.
using SomeOperands = std::uint8_t;
inline constexpr SomeOperands noOperand = 0, firstOperand = 1, secondOperand = 2, thirdOperand = 4;

// How an operation is written: `$0`, `$1`, `$2` stand for the operands. An operand that binds
// looser than its `operands` entry gets parentheses. Without a text the language lacks it. The same
// text does an operation on the components of vectors, beside which `numbers` may stay single ones:
// of two either, of three all of them or none.
struct Spelling {
  std::string_view text;
  Precedence result = Precedence::Primary;
  Operands<Precedence> operands{};
  SomeOperands numbers = noOperand;

  constexpr bool isMissing() const { return text.empty(); }
};

enum class Language : std::uint8_t { Glsl300, Glsl100, Wgsl };

inline constexpr int languageCount = 3;

// The spelling in each language; most are the same in all.
struct Spellings {
  std::array<Spelling, languageCount> byLanguage;

  constexpr Spellings(Spelling spelling) : byLanguage{spelling, spelling, spelling} {}

  constexpr const Spelling& in(Language language) const {
    return byLanguage[static_cast<std::size_t>(language)];
  }

  constexpr Spellings with(Language language, std::string_view text,
                           SomeOperands numbers = noOperand) const {
    Spellings other = *this;
    other.byLanguage[static_cast<std::size_t>(language)] = {text, Precedence::Primary, {}, numbers};
    return other;
  }

  // Otherwise, but as tightly bound.
  constexpr Spellings withText(Language language, std::string_view text) const {
    Spellings other = *this;
    other.byLanguage[static_cast<std::size_t>(language)].text = text;
    return other;
  }

  // A row with a missing spelling must say what it is lowered to, or is refused.
  constexpr Spellings missingIn(Language language) const { return with(language, ""); }
};

constexpr Spellings call(std::string_view text, SomeOperands numbers = noOperand) {
  return Spelling{text, Precedence::Primary, {}, numbers};
}

// For what built-in functions get wrong: every language has it lowered.
inline constexpr Spellings nowhere = Spelling{""};

// Left-associative: an equally tight left operand needs no parentheses, a right one does. They
// matter, since the addition of floats is not associative.
constexpr Spellings infix(std::string_view text, Precedence level) {
  const auto tighter = static_cast<Precedence>(static_cast<int>(level) + 1);
  return Spelling{text, level, {level, tighter, tighter}, firstOperand | secondOperand};
}

// WGSL takes no && beside || without parentheses.
constexpr Spellings logical(std::string_view text) {
  return Spelling{text, Precedence::Logical, {Precedence::Equality, Precedence::Equality, {}}};
}

// `-x * y` is (-x) * y, which is exactly -(x * y), so a negated product needs no parentheses.
inline constexpr Spellings negation =
    Spelling{"-$0", Precedence::Multiplicative, {Precedence::Multiplicative, {}, {}}};

// On bits; with parentheses around whatever is no single value, as WGSL wants them.
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
