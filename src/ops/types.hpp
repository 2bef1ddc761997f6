// The types of an operation's operands and of its result.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

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

}  // namespace warpjet::ops
