// What one row of the operation table is made of.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>

namespace warpjet::ops {

enum class Type : std::uint8_t { Float, Bool };

inline constexpr int maxArity = 3;

// The types of an operation's result and operands.
struct Signature {
  Type result;
  std::array<Type, maxArity> operands;
};

inline constexpr Signature floats{Type::Float, {Type::Float, Type::Float, Type::Float}};
inline constexpr Signature comparison{Type::Bool, {Type::Float, Type::Float, Type::Float}};
inline constexpr Signature logic{Type::Bool, {Type::Bool, Type::Bool, Type::Bool}};
inline constexpr Signature choice{Type::Float, {Type::Bool, Type::Float, Type::Float}};
inline constexpr Signature toFloat{Type::Float, {Type::Bool, Type::Bool, Type::Bool}};
inline constexpr Signature toBool{Type::Bool, {Type::Float, Type::Float, Type::Float}};

// GLSL ES 3.00, section 5.1, from the loosest binding to the tightest.
enum class Precedence : std::uint8_t {
  Ternary,
  LogicalOr,
  LogicalAnd,
  Equality,
  Relational,
  Additive,
  Multiplicative,
  Unary,
  Primary,
};

// How an operation is written: `$0`, `$1`, `$2` stand for the operands. An operand that binds
// looser than its `operands` entry gets parentheses.
struct Spelling {
  std::string_view text;
  Precedence result = Precedence::Primary;
  std::array<Precedence, maxArity> operands{};
};

constexpr Spelling call(std::string_view text) { return {text}; }

// Left-associative: an equally tight left operand needs no parentheses, a right one does. They
// matter, since the addition of floats is not associative.
constexpr Spelling infix(std::string_view text, Precedence level) {
  const auto tighter = static_cast<Precedence>(static_cast<int>(level) + 1);
  return {text, level, {level, tighter, tighter}};
}

// `-x * y` is (-x) * y, which is exactly -(x * y), so a negated product needs no parentheses.
inline constexpr Spelling negation{
    "-$0", Precedence::Multiplicative, {Precedence::Multiplicative, {}, {}}};

inline constexpr Spelling logicalNegation{"!$0", Precedence::Unary, {Precedence::Unary, {}, {}}};

inline constexpr Spelling conditional{
    "$0 ? $1 : $2",
    Precedence::Ternary,
    {Precedence::LogicalOr, Precedence::LogicalOr, Precedence::LogicalOr}};

struct Interval {
  double low, high;
};

// Where an operation may be sampled: one interval an operand.
using Domain = std::array<Interval, maxArity>;

inline constexpr Interval anywhere{-4, 4};
inline constexpr Interval positive{0.05, 4};
inline constexpr Interval negative{-4, -0.05};
inline constexpr Interval belowRightAngle{-1.4, 1.4};
inline constexpr Interval unitInterval{-0.98, 0.98};

inline constexpr Domain everywhere{anywhere, anywhere, anywhere};

// `value` maps operands to the result. `partials` holds one function an operand, from the operands
// and the result to the partial derivative; an operation without partials is locally constant.
template <class Value, class... Partials>
struct Row {
  std::string_view name;
  int arity;
  Signature signature;
  Spelling glsl;
  Domain domain;
  Value value;
  std::tuple<Partials...> partials;
};

template <class Value, class... Partials>
constexpr auto unary(std::string_view name, Signature signature, Spelling glsl, Domain domain,
                     Value value, Partials... partials) {
  return Row<Value, Partials...>{name, 1, signature, glsl, domain, value, {partials...}};
}

template <class Value, class... Partials>
constexpr auto binary(std::string_view name, Signature signature, Spelling glsl, Domain domain,
                      Value value, Partials... partials) {
  return Row<Value, Partials...>{name, 2, signature, glsl, domain, value, {partials...}};
}

template <class Value, class... Partials>
constexpr auto ternary(std::string_view name, Signature signature, Spelling glsl, Domain domain,
                       Value value, Partials... partials) {
  return Row<Value, Partials...>{name, 3, signature, glsl, domain, value, {partials...}};
}

}  // namespace warpjet::ops
