// Checks whether names and expressions of users can be written into a shader.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "emit/dialect.hpp"

namespace warpjet {

// Returns the problem with a host's expression, such as `aPosition` or `(m * vec4(p, 1.0)).xyz`;
// empty if there is none. It must be one balanced expression without statements, comments or
// reserved words.
std::string inputProblem(const Dialect& dialect, std::string_view text);

// Returns the problem with the name of a result; empty if there is none.
std::string outputProblem(const Dialect& dialect, std::string_view name);

// Returns the problem with the name of a host function; empty if there is none.
std::string functionProblem(const Dialect& dialect, std::string_view name);

// The prefix of our own functions.
inline constexpr std::string_view ourPrefix = "warpjet";

// Returns true if `text` calls `word`, one of its `identifiers`, as a function.
bool isCalled(std::string_view text, std::string_view word);

// Returns true for an identifier, optionally with members: `position`, `inputs.uv`.
bool isPlainVariable(std::string_view text);

// Generates the names t0, t1, … and skips those that are in use.
class Temporaries {
 public:
  // Marks the names in this code as used.
  void reserve(std::string_view text);
  std::string next();

 private:
  std::set<std::string, std::less<>> used_;
  int count_ = 0;
};

}  // namespace warpjet
