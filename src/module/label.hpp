// An expression of the host, as far as it tells what it stands for: a variable, and which part of
// it. Spaces and parentheses that mean nothing are gone.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "graph/shape.hpp"

namespace warpjet {

// `.position`, `.xz`, `[2]`: what stands behind a variable and selects a part of it.
struct Selector {
  std::string name;          // of a member; empty for components
  std::vector<int> indices;  // components, or a column of a matrix
  bool isIndex;              // `[2]`, which a vector has as `.z`

  bool operator==(const Selector& other) const {
    return name == other.name && indices == other.indices;
  }
};

struct Label {
  std::string root;
  std::vector<Selector> selectors;
  std::string text;  // as it is to be written
};

// The text must be a syntactically right expression.
Label readLabel(std::string_view text);

// Which components of `whole`, of that shape, the expression `part` reads, if it reads some.
std::optional<std::vector<int>> partOf(const Label& whole, Shape shape, const Label& part);

// Whether the one begins as the other does, so that it is a part of it.
bool isWithin(const Label& part, const Label& whole);

// Whether both may read the same number.
bool mayMeet(const Label& a, const Label& b);

}  // namespace warpjet
