// What one row of the operation table is made of.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <tuple>

namespace warpjet::ops {

// Int is 32 bits, which some rows take to have no sign; see whole.hpp.
enum class Type : std::uint8_t { Float, Bool, Int };

inline constexpr std::size_t typeCount = 3;

inline constexpr int maxArity = 3;

// The operands of one operation, as scalars of any kind, or what is said of each of them.
template <class Each>
using Operands = std::array<Each, maxArity>;

// The types of an operation's result and operands.
struct Signature {
  Type result;
  Operands<Type> operands;

  // Whether it has to do with whole numbers.
  constexpr bool hasWhole() const {
    return result == Type::Int || operands[0] == Type::Int || operands[1] == Type::Int;
  }
};

inline constexpr Signature floats{Type::Float, {Type::Float, Type::Float, Type::Float}};
inline constexpr Signature comparison{Type::Bool, {Type::Float, Type::Float, Type::Float}};
inline constexpr Signature logic{Type::Bool, {Type::Bool, Type::Bool, Type::Bool}};
inline constexpr Signature choice{Type::Float, {Type::Bool, Type::Float, Type::Float}};
inline constexpr Signature toFloat{Type::Float, {Type::Bool, Type::Bool, Type::Bool}};
inline constexpr Signature toBool{Type::Bool, {Type::Float, Type::Float, Type::Float}};
inline constexpr Signature wholes{Type::Int, {Type::Int, Type::Int, Type::Int}};
inline constexpr Signature wholeComparison{Type::Bool, {Type::Int, Type::Int, Type::Int}};
inline constexpr Signature wholeChoice{Type::Int, {Type::Bool, Type::Int, Type::Int}};
inline constexpr Signature wholeToFloat{Type::Float, {Type::Int, Type::Int, Type::Int}};
inline constexpr Signature toWhole{Type::Int, {Type::Float, Type::Float, Type::Float}};

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

struct Extent {
  double low, high;
};

// Where an operation may be sampled.
using Domain = Operands<Extent>;

inline constexpr Extent anywhere{-4, 4};
inline constexpr Extent positive{0.05, 4};
inline constexpr Extent negative{-4, -0.05};
inline constexpr Extent belowRightAngle{-1.4, 1.4};
inline constexpr Extent unitInterval{-0.98, 0.98};
inline constexpr Extent aboveOne{1.02, 4};

inline constexpr Domain everywhere{anywhere, anywhere, anywhere};

// What people read of an operation: its name, its operands in order, and what it gives.
struct Title {
  std::string_view name;
  std::string_view operands;
  std::string_view meaning;
};

// What the other rooms ask of an operation.
enum class Trait : std::uint8_t {
  Chained,      // takes any number of operands, from left to right
  OnMatrices,   // matrices have it by component, but for products, and quotients by a matrix
  Commutative,  // x and y may change places
  Branches,     // its value is that of one operand, and what the others are does not matter
  Divides,      // its second operand must not be 0
  Rising,       // of one operand, with which its value never falls
  Hidden,       // no sketch calls it by its name
  ForText,      // only what reads shader text does
};

class Traits {
 public:
  constexpr Traits() = default;
  constexpr Traits(std::initializer_list<Trait> all) {
    for (const Trait trait : all) bits_ |= bit(trait);
  }

  constexpr bool has(Trait trait) const { return (bits_ & bit(trait)) != 0; }

 private:
  static constexpr unsigned bit(Trait trait) { return 1u << static_cast<unsigned>(trait); }

  unsigned bits_ = 0;
};

// In the place of a formula: every language has the operation, or what lacks it refuses it by name.
struct NoFormula {};

// Functions that an operation's spelling calls and that stand above it, by language.
using Helpers = std::array<std::string_view, languageCount>;

// `value` maps operands to the result. It is generic in the scalar: numbers, intervals, and as many
// lanes as a SIMD register has. Written for `double` alone it will do too: lanes are then computed
// one by one, and an interval is anything, unless the row is `Rising`. `partials` holds one
// function an operand, from the operands and the result to the partial derivative, or from those
// and the derivative of the operand to the product of both; an operation without partials is
// locally constant. `lowered` says the operation by others, for languages that lack it.
template <class Value, class Lowered, class... Partials>
struct Row {
  Title title;
  int arity;
  Signature signature;
  Spellings spellings;
  Domain domain;
  Value value;
  std::tuple<Partials...> partials;
  Lowered lowered;
  Helpers helpers = {};
  Traits traits = {};

  template <class... Each>
  constexpr Row with(Each... each) const {
    Row row = *this;
    row.traits = {each...};
    return row;
  }

  constexpr Row helpedBy(const Helpers& texts) const {
    Row row = *this;
    row.helpers = texts;
    return row;
  }

  template <class Formula>
  constexpr Row<Value, Formula, Partials...> loweredTo(Formula formula) const {
    return {title, arity, signature, spellings, domain, value, partials, formula, helpers, traits};
  }
};

template <class Value, class... Partials>
constexpr auto unary(Title title, Signature signature, Spellings spellings, Domain domain,
                     Value value, Partials... partials) {
  return Row<Value, NoFormula, Partials...>{title,  1,     signature,     spellings,
                                            domain, value, {partials...}, {}};
}

template <class Value, class... Partials>
constexpr auto binary(Title title, Signature signature, Spellings spellings, Domain domain,
                      Value value, Partials... partials) {
  return Row<Value, NoFormula, Partials...>{title,  2,     signature,     spellings,
                                            domain, value, {partials...}, {}};
}

template <class Value, class... Partials>
constexpr auto ternary(Title title, Signature signature, Spellings spellings, Domain domain,
                       Value value, Partials... partials) {
  return Row<Value, NoFormula, Partials...>{title,  3,     signature,     spellings,
                                            domain, value, {partials...}, {}};
}

}  // namespace warpjet::ops
