// What a shading language keeps for itself and how it writes what is no operation. The spellings of
// operations are in the rows of the table.
#pragma once

#include <string>
#include <string_view>

#include "graph/shape.hpp"
#include "ops/ops.hpp"

namespace warpjet {

struct Dialect {
  std::string_view name;
  ops::Language language;
  std::string_view family;        // what people call it
  std::string_view operators;     // those that not every language has, each a character
  std::string_view numberSuffix;  // after a literal
  bool declaresWithVar;           // `var x: f32` and `let x = 1.0f`, instead of `float x`
  bool hasRectangularMatrices;
  // Lists are separated by spaces, with a space at both ends.
  std::string_view constructors;  // types whose name an expression may call
  std::string_view builtIns;      // variables of the language that an expression may read
  std::string_view otherTypes;    // those of them that are no floats
  std::string_view keywords;      // these, and all words reserved for later
  std::string_view functions;     // of the language

  static bool holds(std::string_view list, std::string_view word) {
    return list.find(' ' + std::string(word) + ' ') != list.npos;
  }

  // `float`, `bvec2`, `mat3`, `highp sampler2D`; `f32`, `vec2<bool>`, `mat3x3f`, `texture_2d<f32>`.
  std::string typeName(ops::Type type, Shape shape) const;
  // A variable that gets its value later, without the end of the statement.
  std::string declaration(const std::string& type, const std::string& variable) const;
  // The beginning of a statement, up to the value, that defines a temporary.
  std::string definition(const std::string& type, const std::string& variable) const;
};

extern const Dialect glsl300;
extern const Dialect glsl100;
extern const Dialect wgsl;

// The dialect of that name, or null.
const Dialect* findDialect(std::string_view name);

}  // namespace warpjet
