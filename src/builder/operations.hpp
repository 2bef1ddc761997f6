// All operations with a public name, indexed by number: table rows, aliases, compositions, and
// the constructors and parts of vectors and matrices.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "builder/compositions.hpp"
#include "ops/ops.hpp"

namespace warpjet {

struct Operation {
  enum class Source : std::uint8_t {
    Row,
    Composition,
    Vector,
    MatrixOfColumns,
    MatrixOfRows,
    Part
  };

  std::string_view name;
  Source source;
  // The index of the row or composition; the size of a constructor; for a part, 1 means a row.
  std::uint8_t index;
  // Used only by the front ends for shader source or by our JavaScript; it has no public method.
  bool isInternal = false;

  // Vectors and matrices are not constructed by a method.
  constexpr bool isConstructor() const {
    return source == Source::Vector || source == Source::MatrixOfColumns ||
           source == Source::MatrixOfRows;
  }
};

namespace detail {

struct Alias {
  std::string_view name, original;
};

// The names that glsl-autodiff uses.
inline constexpr std::array aliases{
    Alias{"sum", "add"},      Alias{"prod", "mult"},  Alias{"vecSum", "add"},
    Alias{"vecProd", "mult"}, Alias{"vecMix", "mix"}, Alias{"vecClamp", "clamp"},
    Alias{"vecMin", "min"},   Alias{"vecMax", "max"}, Alias{"vecIfElse", "ifElse"},
};

constexpr bool isHidden(const ops::Declaration& row) { return row.traits.has(ops::Trait::Hidden); }

using Source = Operation::Source;

inline constexpr std::array vectorOperations{
    Operation{"column", Source::Part, 0},           Operation{"row", Source::Part, 1},
    Operation{"vec2", Source::Vector, 2},           Operation{"vec3", Source::Vector, 3},
    Operation{"vec4", Source::Vector, 4},           Operation{"mat2", Source::MatrixOfColumns, 2},
    Operation{"mat3", Source::MatrixOfColumns, 3},  Operation{"mat4", Source::MatrixOfColumns, 4},
    Operation{"mat2Rows", Source::MatrixOfRows, 2}, Operation{"mat3Rows", Source::MatrixOfRows, 3},
    Operation{"mat4Rows", Source::MatrixOfRows, 4},
};

inline constexpr auto hiddenCount = static_cast<std::size_t>(
    std::count_if(ops::declarations.begin(), ops::declarations.end(), isHidden));

}  // namespace detail

inline constexpr auto operations = [] {
  using Source = Operation::Source;
  std::array<Operation, ops::count - detail::hiddenCount + detail::aliases.size() +
                            compositions.size() + detail::vectorOperations.size()>
      all{};
  std::size_t n = 0;
  const auto toIndex = [](std::size_t i) { return static_cast<std::uint8_t>(i); };
  for (std::size_t i = 0; i < ops::count; ++i) {
    if (!detail::isHidden(ops::declarations[i]))
      all[n++] = {ops::declarations[i].name, Source::Row, toIndex(i),
                  ops::declarations[i].traits.has(ops::Trait::SourceOnly)};
  }
  for (const auto& alias : detail::aliases) {
    for (std::size_t i = 0; i < ops::count; ++i) {
      if (ops::declarations[i].name == alias.original)
        all[n++] = {alias.name, Source::Row, toIndex(i)};
    }
  }
  for (std::size_t i = 0; i < compositions.size(); ++i)
    all[n++] = {compositions[i].title.name, Source::Composition, toIndex(i),
                !compositions[i].isListed};
  for (const Operation& operation : detail::vectorOperations) all[n++] = operation;
  return all;
}();

// The sections of the documentation: each heading applies from its first operation on. Some
// headings occur twice.
struct Heading {
  std::string_view text, first;
};

inline constexpr std::array headings{
    Heading{"Arithmetic", "neg"},
    Heading{"Powers and logarithms", "pow"},
    Heading{"Angles", "sin"},
    Heading{"Hyperbolic functions", "sinh"},
    Heading{"Steps, bounds and blends", "abs"},
    Heading{"Conditions", "lt"},
    Heading{"Vectors", "dot"},
    Heading{"Steps, bounds and blends", "smoothstep"},
    Heading{"Angles", "radians"},
    Heading{"Matrices", "transpose"},
    Heading{"Derivatives", "derivative"},
};

}  // namespace warpjet
