// Patterns of operations, written like the expressions that they match: `x + -y` builds a constexpr
// tree. The rows of identities.hpp consist of patterns.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "ops/ops.hpp"

namespace warpjet::patterns {

struct Function;

// An operation or a leaf of a pattern. The items of an operation's operands follow it.
struct Item {
  enum class Kind : std::uint8_t {
    Anything,   // a variable: any node, the same one in all places of the variable
    Computed,   // a variable: any node but a constant
    Constant,   // a variable: a constant
    Factor,     // a variable: a common factor, which may be missing; see rotations.hpp
    Literal,    // a known number or condition
    Operation,  //
    Function,   // a function of known items
  };

  Kind kind = Kind::Literal;
  std::uint8_t number = 0;  // of the variable or the operation
  std::uint8_t size = 1;    // number of items, including those of its operands
  bool isKnown = true;      // true if its value is known when the pattern is matched
  ops::Type type = ops::Type::Float;
  double value = 0;
  const Function* function = nullptr;

  constexpr bool is(Op op) const {
    return kind == Kind::Operation && number == static_cast<std::uint8_t>(op);
  }
  constexpr bool isVariable() const {
    return kind != Kind::Literal && kind != Kind::Operation && kind != Kind::Function;
  }
  constexpr Op op() const { return Op{number}; }
};

using Kind = Item::Kind;

// The first item is the root.
struct Pattern {
  static constexpr std::size_t maxSize = 40;

  std::array<Item, maxSize> items{};

  constexpr Pattern(double value) : items{Item{.value = value}} {}
  constexpr Pattern(int value) : Pattern(static_cast<double>(value)) {}
  constexpr Pattern(bool value)
      : items{Item{.type = ops::Type::Bool, .value = value ? 1.0 : 0.0}} {}

  // Makes a variable, named by a letter.
  constexpr Pattern(Kind kind, char letter)
      : items{Item{.kind = kind,
                   .number = static_cast<std::uint8_t>(letter - 'a'),
                   .isKnown = kind == Kind::Constant}} {}

  // Makes an operation or a function.
  template <class... Operands>
  constexpr Pattern(Item root, const Operands&... operands) : items{root} {
    (append(operands), ...);
    items[0].isKnown = (operands.root().isKnown && ...);
  }

  constexpr const Item& root() const { return items[0]; }
  constexpr std::size_t size() const { return items[0].size; }

 private:
  constexpr void append(const Pattern& operand) {
    for (std::size_t i = 0; i < operand.size(); ++i) items[size() + i] = operand.items[i];
    items[0].size = static_cast<std::uint8_t>(size() + operand.size());
  }
};

// A function of a known number, available only in patterns.
struct Function {
  std::string_view name;
  double (*valueOf)(double);

  constexpr Pattern operator()(const Pattern& x) const {
    return {Item{.kind = Kind::Function, .function = this}, x};
  }
};

template <class... Operands>
constexpr Pattern operation(Op op, const Operands&... operands) {
  return {Item{.kind = Kind::Operation, .number = static_cast<std::uint8_t>(op)}, operands...};
}

constexpr Pattern operator-(const Pattern& x) { return operation(ops::find("neg"), x); }
constexpr Pattern operator+(const Pattern& x, const Pattern& y) {
  return operation(ops::find("add"), x, y);
}
constexpr Pattern operator-(const Pattern& x, const Pattern& y) {
  return operation(ops::find("sub"), x, y);
}
constexpr Pattern operator*(const Pattern& x, const Pattern& y) {
  return operation(ops::find("mult"), x, y);
}
constexpr Pattern operator/(const Pattern& x, const Pattern& y) {
  return operation(ops::find("div"), x, y);
}
constexpr Pattern pow(const Pattern& x, const Pattern& y) {
  return operation(ops::find("pow"), x, y);
}
constexpr Pattern sqrt(const Pattern& x) { return operation(ops::find("sqrt"), x); }
constexpr Pattern sin(const Pattern& x) { return operation(ops::find("sin"), x); }
constexpr Pattern cos(const Pattern& x) { return operation(ops::find("cos"), x); }
constexpr Pattern min(const Pattern& x, const Pattern& y) {
  return operation(ops::find("min"), x, y);
}
constexpr Pattern max(const Pattern& x, const Pattern& y) {
  return operation(ops::find("max"), x, y);
}
constexpr Pattern clamp(const Pattern& x, const Pattern& low, const Pattern& high) {
  return operation(ops::find("clamp"), x, low, high);
}
constexpr Pattern mix(const Pattern& x, const Pattern& y, const Pattern& t) {
  return operation(ops::find("mix"), x, y, t);
}
constexpr Pattern operator<(const Pattern& x, const Pattern& y) {
  return operation(ops::find("lt"), x, y);
}
constexpr Pattern operator>(const Pattern& x, const Pattern& y) {
  return operation(ops::find("gt"), x, y);
}
constexpr Pattern operator!(const Pattern& x) { return operation(ops::find("not"), x); }
constexpr Pattern ifElse(const Pattern& condition, const Pattern& yes, const Pattern& no) {
  return operation(ops::find("ifElse"), condition, yes, no);
}
constexpr Pattern intIfElse(const Pattern& condition, const Pattern& yes, const Pattern& no) {
  return operation(ops::find("intIfElse"), condition, yes, no);
}

// How exactly an identity preserves values, in double as well as in float32.
enum class Precision : std::uint8_t {
  Bits,      // all bits, also those of zeros, infinities and NaN
  Value,     // all but the sign of a zero
  Rounding,  // up to a few roundings of the largest intermediate result, if none overflows or
             // underflows
};

struct Keeps {
  Precision precision;
  // The replacement may be a number where the original is NaN, as with x * 0 = 0 for an infinite x.
  bool onlyNumbers = false;
};

inline constexpr Keeps bits{Precision::Bits}, value{Precision::Value},
    rounding{Precision::Rounding};

// Returns the same precision, required only where the left side isn't NaN.
constexpr Keeps ifNumber(Keeps keeps) { return {keeps.precision, true}; }

// A row: pattern, replacement, precision, and a condition on the constants.
struct Identity {
  Pattern from, to;
  Keeps keeps;
  Pattern when = true;

  constexpr bool hasCondition() const { return when.root().kind != Kind::Literal; }
};

}  // namespace warpjet::patterns
