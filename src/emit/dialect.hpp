// A shading language as data: its reserved words, its type names, and its syntax for everything but
// operations, whose spelling is a column of the operation table.
#pragma once

#include <array>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "emit/word_set.hpp"
#include "graph/shape.hpp"
#include "ops/ops.hpp"

namespace warpjet {

// Some strings are templates, in which $0, $1 and $2 are replaced; see `expand`.
struct Dialect {
  std::string_view name;
  ops::Language language;      // its column in the operation table
  std::string_view family;     // the common name of the language and its variants
  std::string_view sourceKey;  // the key of a source of this family in the options of glsl.fn

  // Restrictions on a host's expressions. Lists are separated by spaces, with a space at both ends.
  std::string_view operators;     // the subset of `optionalOperators` that it has
  std::string_view constructors;  // types whose constructor an expression may call
  bool hasTemplates;              // such as `vec4<f32>(…)`
  std::string_view builtIns;      // built-in variables that an expression may read
  std::string_view nonFloats;     // built-in variables that aren't floats
  WordSet keywords;               // keywords, and words reserved for future use
  std::string_view functions;     // built-in functions
  std::size_t maxNameLength;

  // Types, by float, bool and int; vectors from two components up, matrices by columns and rows
  // from two up. The names of missing types are empty; `missingTypes` says what to use instead.
  std::array<std::string_view, ops::typeCount> numbers;
  std::array<std::array<std::string_view, 3>, ops::typeCount> vectors;
  std::array<std::array<std::string_view, 3>, 3> matrices;
  std::string_view image;
  std::string_view missingTypes;

  std::string_view numberSuffix;  // the suffix of literals
  std::string_view declaration;   // the declaration of a variable $1 of type $0, assigned later
  bool declaresSeveral;           // true if a declaration may list more variables
  std::string_view
      definition;             // the start of a definition, up to the value: temporary $1 of type $0
  std::string_view variable;  // the same for a variable that is reassigned later
  std::string_view loop;      // the head of a loop that counts $0 from 0 to $1 - 1
  std::string_view
      construction;           // constructs a vector, matrix or struct of type $0 from the values $1
  std::string_view splat;     // a vector of type $0 with all components equal to $1
  std::string_view function;  // the head of a function that returns $0, is named $1 and takes $2
  std::string_view parameter;  // a parameter of type $0, named $1
  std::string_view structure;  // a struct named $0 with members $1
  std::string_view member;     // a member of type $0, named $1
  std::string_view imageSize;  // width and height of the image $0
  std::string_view texel;      // the function that reads a texel; see src/texture
  std::string_view
      sampledTexel;  // the same with coordinates beyond the edges, which the host's sampler wraps
  std::string_view across, down;  // the functions of screen.hpp

  static bool holds(std::string_view list, std::string_view word) {
    return list.find(' ' + std::string(word) + ' ') != list.npos;
  }

  std::string_view typeName(ops::Type type, Shape shape) const;
  // Returns the source of one of our functions that nodes can't express.
  std::string_view sourceOf(std::string_view functionName) const;
};

// Replaces $0, $1, … in a template by the parts.
using Parts = std::initializer_list<std::string_view>;
std::string expand(std::string_view form, Parts parts);
void appendExpanded(std::string& text, std::string_view form, Parts parts);  // appends to `text`

extern const Dialect glsl300;
extern const Dialect glsl100;
extern const Dialect wgsl;

// Returns all dialects; the first one is the default.
std::span<const Dialect* const> dialects();

// Returns the dialect with that name, or null.
const Dialect* findDialect(std::string_view name);

}  // namespace warpjet
