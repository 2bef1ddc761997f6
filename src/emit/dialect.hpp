// A shading language as data: what it keeps for itself, what its types are called, and how it
// writes what is no operation. How it writes operations is its column of the table.
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

// Texts in which $0, $1, $2 stand for parts.
struct Dialect {
  std::string_view name;
  ops::Language language;      // its column
  std::string_view family;     // what people call it, and others like it
  std::string_view sourceKey;  // what glsl.fn calls a source of the family

  // Expressions of a host. Lists are separated by spaces, with a space at both ends.
  std::string_view operators;     // of `allOperators`, those that it has
  std::string_view constructors;  // types whose name an expression may call
  bool hasTemplates;              // such as `vec4<f32>(…)`
  std::string_view builtIns;      // variables of the language that an expression may read
  std::string_view otherTypes;    // those of them that are no floats
  WordSet keywords;               // these, and all words reserved for later
  std::string_view functions;     // of the language
  std::size_t longestName;

  // Types, by float, bool and int; of vectors from two components up, of matrices by columns and
  // rows from two up. What it lacks is empty, and `lacks` says what to do then.
  std::array<std::string_view, ops::typeCount> numbers;
  std::array<std::array<std::string_view, 3>, ops::typeCount> vectors;
  std::array<std::array<std::string_view, 3>, 3> matrices;
  std::string_view image;
  std::string_view lacks;

  std::string_view numberSuffix;  // after a literal
  std::string_view declaration;   // of type $0, a variable $1 that gets its value later
  bool declaresSeveral;           // whether more of the type may follow in it
  std::string_view definition;    // of type $0, the temporary $1, up to its value
  std::string_view variable;      // the same of one that gets other values later
  std::string_view loop;          // that counts $0 from 0 up to below $1, up to its body
  std::string_view construction;  // a vector, matrix or struct of type $0 of the values $1
  std::string_view splat;         // a vector of type $0, all of whose components are $1
  std::string_view function;      // that gives $0, is named $1 and takes $2, up to its body
  std::string_view parameter;     // of type $0, named $1
  std::string_view structure;     // named $0, with members $1
  std::string_view member;        // of type $0, named $1
  std::string_view imageSize;     // width and height of the image $0
  std::string_view texel;         // the function that reads a texel; see src/texture
  std::string_view sampledTexel;  // the same beyond the edges, wrapped by the host's sampler

  static bool holds(std::string_view list, std::string_view word) {
    return list.find(' ' + std::string(word) + ' ') != list.npos;
  }

  std::string_view typeName(ops::Type type, Shape shape) const;
};

// A form of a dialect with its parts in the place of $0, $1, …
using Parts = std::initializer_list<std::string_view>;
std::string filled(std::string_view form, Parts parts);
void fill(std::string& text, std::string_view form, Parts parts);  // behind `text`

extern const Dialect glsl300;
extern const Dialect glsl100;
extern const Dialect wgsl;

// All there are, the one first that counts unless another is asked for.
std::span<const Dialect* const> dialects();

// The dialect of that name, or null.
const Dialect* findDialect(std::string_view name);

}  // namespace warpjet
