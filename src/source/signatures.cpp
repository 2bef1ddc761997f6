#include "source/signatures.hpp"

namespace warpjet::source {

namespace {

// Matches operands with the letters of a signature. The first operand of a generic letter
// determines its size.
struct Match {
  int size = 0;
  Type matrix;
  int columns = 0, rows = 0;

  bool generic(Base base, Type type, int minSize) {
    if (type.isArray() || type.base != base || type.columns != 1 || type.rows < minSize)
      return false;
    if (size == 0) size = type.rows;
    return size == type.rows;
  }

  bool fits(char letter, Type type) {
    switch (letter) {
      case 'G':
        return generic(Base::Float, type, 1);
      case 'I':
        return generic(Base::Int, type, 1);
      case 'U':
        return generic(Base::Uint, type, 1);
      case 'B':
        return generic(Base::Bool, type, 1);
      case 'V':
        return generic(Base::Float, type, 2);
      case 'W':
        return generic(Base::Int, type, 2);
      case 'X':
        return generic(Base::Uint, type, 2);
      case 'Y':
        return generic(Base::Bool, type, 2);
      case 'M':
      case 'Q':
        if (!type.isMatrix() || (letter == 'Q' && type.columns != type.rows)) return false;
        if (matrix.base == Base::Void) matrix = type;
        return matrix == type;
      default:
        return type == fixed(letter);
    }
  }

  static Type fixed(char letter) {
    switch (letter) {
      case 'F':
        return floatType;
      case 'i':
        return intType;
      case 'u':
        return uintType;
      case 'b':
        return boolType;
      case 'S':
        return samplerType;
      case 'k':
        return vectorType(Base::Int, 2);
      case 'n':
        return vectorType(Base::Int, 4);
      case 'm':
        return vectorType(Base::Uint, 4);
      default:
        return vectorType(Base::Float, letter - '0');
    }
  }

  Type result(char letter) const {
    switch (letter) {
      case 'G':
      case 'V':
        return vectorType(Base::Float, size);
      case 'I':
        return vectorType(Base::Int, size);
      case 'U':
        return vectorType(Base::Uint, size);
      case 'B':
      case 'Y':
        return vectorType(Base::Bool, size);
      case 'M':
      case 'Q':
        return matrix;
      case 'T':
        return matrixType(matrix.rows, matrix.columns);
      case 'O':
        return matrixType(columns, rows);
      default:
        return fixed(letter);
    }
  }
};

}  // namespace

std::optional<Type> matchSignature(std::string_view signature, std::span<const Type> operands) {
  Match match;
  std::size_t i = 0;
  for (const char letter : signature.substr(1)) {
    if (letter == '>') continue;
    if (i >= operands.size()) return std::nullopt;
    // The sizes of the operands of an outer product are independent.
    if (signature[0] == 'O') {
      if (!operands[i].isVector() || operands[i].base != Base::Float) return std::nullopt;
      (i == 0 ? match.rows : match.columns) = operands[i].rows;
    } else if (!match.fits(letter, operands[i])) {
      return std::nullopt;
    }
    ++i;
  }
  if (i != operands.size()) return std::nullopt;
  return match.result(signature[0]);
}

bool isOutParameter(std::string_view signature, std::size_t parameter) {
  std::size_t i = 0;
  bool isNext = false;
  for (const char letter : signature.substr(1)) {
    if (letter == '>') {
      isNext = true;
      continue;
    }
    if (i++ == parameter) return isNext;
    isNext = false;
  }
  return false;
}

}  // namespace warpjet::source
