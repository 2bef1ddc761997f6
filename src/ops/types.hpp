// The types of an operation's operands and of its result.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace warpjet::ops {

// Int has 32 bits; some rows treat it as unsigned, see ints.hpp.
enum class Type : std::uint8_t { Float, Bool, Int };

inline constexpr std::size_t typeCount = 3;

inline constexpr int maxArity = 3;

// An array with one entry per operand of an operation.
template <class Each>
using Operands = std::array<Each, maxArity>;

// The types of an operation's result and operands.
struct Signature {
  Type result;
  Operands<Type> operands;

  // Returns true if an operand or the result is an integer.
  constexpr bool hasInt() const {
    return result == Type::Int || operands[0] == Type::Int || operands[1] == Type::Int;
  }
};

inline constexpr Signature floats{Type::Float, {Type::Float, Type::Float, Type::Float}};
inline constexpr Signature comparison{Type::Bool, {Type::Float, Type::Float, Type::Float}};
inline constexpr Signature logic{Type::Bool, {Type::Bool, Type::Bool, Type::Bool}};
inline constexpr Signature choice{Type::Float, {Type::Bool, Type::Float, Type::Float}};
inline constexpr Signature toFloat{Type::Float, {Type::Bool, Type::Bool, Type::Bool}};
inline constexpr Signature toBool{Type::Bool, {Type::Float, Type::Float, Type::Float}};
inline constexpr Signature ints{Type::Int, {Type::Int, Type::Int, Type::Int}};
inline constexpr Signature intComparison{Type::Bool, {Type::Int, Type::Int, Type::Int}};
inline constexpr Signature intChoice{Type::Int, {Type::Bool, Type::Int, Type::Int}};
inline constexpr Signature fromInt{Type::Float, {Type::Int, Type::Int, Type::Int}};
inline constexpr Signature toInt{Type::Int, {Type::Float, Type::Float, Type::Float}};

}  // namespace warpjet::ops
