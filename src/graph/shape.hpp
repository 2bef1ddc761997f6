// The shape of a value: a number, a vector, or a matrix.
#pragma once

#include <cstdint>

namespace warpjet {

// A number is 1 by 1, a vector is one column. Components are numbered column by column, as in GLSL.
// An image of the host, which is only an argument of our functions, is one node and has 0 columns.
struct Shape {
  std::uint8_t columns = 1;
  std::uint8_t rows = 1;

  constexpr int size() const { return columns == 0 ? 1 : columns * rows; }
  constexpr bool isNumber() const { return columns == 1 && rows == 1; }
  constexpr bool isVector() const { return columns == 1 && rows > 1; }
  constexpr bool isMatrix() const { return columns > 1; }
  constexpr bool isSquare() const { return columns == rows; }
  constexpr bool operator==(const Shape&) const = default;
};

inline constexpr Shape scalarShape{}, imageShape{0, 1};
constexpr Shape vectorOf(int size) { return {1, static_cast<std::uint8_t>(size)}; }
constexpr Shape matrixOf(int columns, int rows) {
  return {static_cast<std::uint8_t>(columns), static_cast<std::uint8_t>(rows)};
}

inline constexpr int maxComponents = 16;

}  // namespace warpjet
