#include "emit/names.hpp"

#include <algorithm>
#include <array>

#include "emit/syntax.hpp"

namespace warpjet {

namespace {

bool isKeyword(const Dialect& dialect, std::string_view word) {
  return dialect.keywords.find(" " + std::string(word) + " ") != std::string_view::npos;
}

// Type constructors and the two literals are keywords that an expression may hold.
bool isExpressionKeyword(std::string_view word) {
  constexpr std::array<std::string_view, 20> words{
      "float", "int",   "uint",  "bool", "vec2", "vec3", "vec4",  "ivec2", "ivec3", "ivec4",
      "uvec2", "uvec3", "uvec4", "mat2", "mat3", "mat4", "bvec2", "bvec3", "bvec4", "true"};
  return word == "false" || std::find(words.begin(), words.end(), word) != words.end();
}

// The built-in variables that a vertex or fragment shader may read; no host can declare another.
bool isBuiltIn(std::string_view word) {
  constexpr std::array<std::string_view, 7> words{"gl_VertexID",  "gl_InstanceID", "gl_Position",
                                                  "gl_PointSize", "gl_FragCoord",  "gl_FrontFacing",
                                                  "gl_PointCoord"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string reservedProblem(const Dialect& dialect, std::string_view word) {
  const auto startsWith = [&](std::string_view prefix) { return word.starts_with(prefix); };
  if (isKeyword(dialect, word)) return quoted(word) + " is a word of GLSL itself";
  if (startsWith("gl_") || startsWith("webgl_") || startsWith("_webgl_"))
    return "names that start with gl_ or webgl_ belong to GLSL, as " + quoted(word) + " does";
  if (word.find("__") != std::string_view::npos)
    return "names with two underscores in a row belong to GLSL, as " + quoted(word) + " does";
  return {};
}

}  // namespace

std::vector<std::string_view> identifiers(std::string_view text) {
  std::vector<std::string_view> found;
  for (std::size_t i = 0; i < text.size();) {
    if (!isWordPart(text[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && isWordPart(text[end])) ++end;
    const bool isMember = i > 0 && text[i - 1] == '.';
    if (isWordStart(text[i]) && !isMember) found.push_back(text.substr(i, end - i));
    i = end;
  }
  return found;
}

std::string inputProblem(const Dialect& dialect, std::string_view text) {
  if (text.find_first_not_of(' ') == std::string_view::npos) return "it is empty";
  if (auto problem = syntaxProblem(text); !problem.empty()) return problem;
  for (const std::string_view word : identifiers(text)) {
    if (isExpressionKeyword(word) || isBuiltIn(word)) continue;
    if (auto problem = reservedProblem(dialect, word); !problem.empty()) return problem;
  }
  return {};
}

std::string outputProblem(const Dialect& dialect, std::string_view name) {
  const bool isIdentifier =
      !name.empty() && isWordStart(name[0]) && std::all_of(name.begin(), name.end(), isWordPart);
  if (!isIdentifier)
    return "a name is made of letters, digits and underscores and does not start with a digit";
  return reservedProblem(dialect, name);
}

bool isPlainVariable(std::string_view text) {
  bool atStart = true;
  for (const char c : text) {
    if (atStart ? !isWordStart(c) : !isWordPart(c) && c != '.') return false;
    atStart = c == '.';
  }
  return !atStart;
}

void Temporaries::reserve(std::string_view text) {
  for (const std::string_view name : identifiers(text)) used_.emplace_back(name);
}

std::string Temporaries::next() {
  std::string name;
  do {
    name = 't' + std::to_string(count_++);
  } while (std::find(used_.begin(), used_.end(), name) != used_.end());
  return name;
}

}  // namespace warpjet
