// Binary operators and their precedence: GLSL ES 3.00, section 5.1.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace warpjet::source {

enum class Operator : std::uint8_t {
  Or,
  Xor,
  And,
  BitOr,
  BitXor,
  BitAnd,
  Equal,
  Unequal,
  Less,
  Greater,
  AtMost,
  AtLeast,
  ShiftLeft,
  ShiftRight,
  Add,
  Subtract,
  Multiply,
  Divide,
  Remainder,
};

struct OperatorRow {
  std::string_view text;
  Operator op;
  // From lowest to highest precedence; operators of one level are left-associative.
  int level;
};

inline constexpr std::array operatorRows{
    OperatorRow{"||", Operator::Or, 1},        OperatorRow{"^^", Operator::Xor, 2},
    OperatorRow{"&&", Operator::And, 3},       OperatorRow{"|", Operator::BitOr, 4},
    OperatorRow{"^", Operator::BitXor, 5},     OperatorRow{"&", Operator::BitAnd, 6},
    OperatorRow{"==", Operator::Equal, 7},     OperatorRow{"!=", Operator::Unequal, 7},
    OperatorRow{"<", Operator::Less, 8},       OperatorRow{">", Operator::Greater, 8},
    OperatorRow{"<=", Operator::AtMost, 8},    OperatorRow{">=", Operator::AtLeast, 8},
    OperatorRow{"<<", Operator::ShiftLeft, 9}, OperatorRow{">>", Operator::ShiftRight, 9},
    OperatorRow{"+", Operator::Add, 10},       OperatorRow{"-", Operator::Subtract, 10},
    OperatorRow{"*", Operator::Multiply, 11},  OperatorRow{"/", Operator::Divide, 11},
    OperatorRow{"%", Operator::Remainder, 11},
};

constexpr const OperatorRow* findOperator(std::string_view text) {
  for (const OperatorRow& row : operatorRows)
    if (row.text == text) return &row;
  return nullptr;
}

constexpr std::string_view textOf(Operator op) {
  return operatorRows[static_cast<std::size_t>(op)].text;
}

}  // namespace warpjet::source
