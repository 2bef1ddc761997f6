// Functions of ours that a text defines once, however often they are called, so that a value and
// its derivatives share their work. Each is written once, as nodes: text, derivatives of every
// order and evaluation on the CPU follow from those. What nodes cannot say, such as to read an
// image, is a function of a text.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "graph/expression.hpp"

namespace warpjet {

class Library;

using Numbers = std::vector<Expression>;

struct Definition {
  // The values from the arguments. May call other functions of the library.
  using Body = Numbers (*)(Library&, std::uint32_t settings, std::span<const Expression> arguments);

  // Equal names are equal functions.
  Function function;
  Body body;
  // What `body` is told.
  std::uint32_t settings = 0;
  // What each value is known to lie between.
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  // Instead of a body, the function in each language; one that has no derivatives.
  const ops::Helpers* texts = nullptr;

  // The variables, then the other arguments, as far as there are any.
  static constexpr std::string_view variableNames[] = {"x", "y", "z", "w"};
  static constexpr std::string_view noiseParameters[] = {"seed", "lacunarity", "gain"};
  static constexpr std::string_view imageParameters[] = {"image", "width", "height"};
  const std::string_view* parameters = noiseParameters;

  std::string_view argumentName(int i) const {
    return i < function.variables ? variableNames[i] : parameters[i - function.variables];
  }
  Shape argumentShape(int i) const {
    return argumentName(i) == imageParameters[0] ? oneImage : oneNumber;
  }
};

}  // namespace warpjet
