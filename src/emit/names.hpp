// Names and expressions that come from outside: are they safe to write into a shader?
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "emit/dialect.hpp"

namespace warpjet {

// What is wrong with a host's expression, such as `aPosition` or `(m * vec4(p, 1.0)).xyz`, or
// nothing. It must be one balanced expression without statements, comments or reserved words.
std::string inputProblem(const Dialect& dialect, std::string_view text);

// What is wrong with the name of a result, or nothing.
std::string outputProblem(const Dialect& dialect, std::string_view name);

// What is wrong with the name of a function of the host, or nothing.
std::string functionProblem(const Dialect& dialect, std::string_view name);

// How the names of our own functions begin.
inline constexpr std::string_view ourPrefix = "warpjet";

// Whether a word of a text, one of its `identifiers`, is what is called there.
bool isCalled(std::string_view text, std::string_view word);

// Whether a text is an identifier, perhaps with members: `position`, `inputs.uv`.
bool isPlainVariable(std::string_view text);

// Hands out t0, t1, … and skips every name in use.
class Temporaries {
 public:
  void reserve(std::string_view text);
  std::string next();

 private:
  std::set<std::string, std::less<>> used_;
  int count_ = 0;
};

}  // namespace warpjet
