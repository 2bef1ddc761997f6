// Determines what a host's expression reads, as far as it can be parsed: a variable, and which part
// of it. Spaces and redundant parentheses don't matter.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "graph/shape.hpp"

namespace warpjet {

// A selector after a variable: `.position`, `.xz`, `[2]`.
struct Selector {
  std::string name;          // name of a member; empty for components
  std::vector<int> indices;  // components, or the column of a matrix
  bool isIndex;              // written as `[2]`, which is the same as `.z` for a vector

  bool operator==(const Selector& other) const {
    return name == other.name && indices == other.indices;
  }
};

struct Label {
  std::string root;
  std::vector<Selector> selectors;
  std::string text;  // normalized
};

// Parses an expression, which must be syntactically valid.
Label readLabel(std::string_view text);

// Returns which components of `whole`, a value of shape `shape`, the expression `part` reads;
// nullopt if it isn't known to read any.
std::optional<std::vector<int>> partOf(const Label& whole, Shape shape, const Label& part);

// Returns true if `part` has the root of `whole` and starts with its selectors, so that it reads
// `whole` or a part of it.
bool isWithin(const Label& part, const Label& whole);

// Returns true if the two expressions may read the same number.
bool mayOverlap(const Label& a, const Label& b);

}  // namespace warpjet
