#include "emit/names.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "module/syntax.hpp"
#include "ops/rows.hpp"

namespace warpjet {

namespace {

// Lists the functions of a language that our statements call, such as sin for `sin($0)`, separated
// by spaces.
constexpr auto listCalled(ops::Language language) {
  std::array<char, 2048> list{};
  std::size_t size = 0;
  const auto add = [&](std::string_view name) {
    for (const char c : name) list[size++] = c;
    list[size++] = ' ';
  };
  for (const std::string_view name : {"dot", "cross"}) add(name);  // called by the writer for sums
  const auto addCalled = [&](std::string_view text) {
    const std::size_t bracket = text.find('(');
    const std::string_view name = text.substr(0, bracket);
    if (bracket != text.npos && std::all_of(name.begin(), name.end(), isWordPart)) add(name);
  };
  std::apply([&](const auto&... row) { (addCalled(row.spellings.in(language).text), ...); },
             ops::table);
  return list;
}

template <ops::Language language>
constexpr auto calledIn = listCalled(language);

template <std::size_t... languages>
constexpr auto setsOf(std::index_sequence<languages...>) {
  return std::array{WordSet(calledIn<static_cast<ops::Language>(languages)>.data())...};
}
constexpr auto called = setsOf(std::make_index_sequence<ops::languageCount>());

bool isCalledByUs(const Dialect& dialect, std::string_view word) {
  return called[static_cast<std::size_t>(dialect.language)].holds(word);
}

std::string reservedProblem(const Dialect& dialect, std::string_view word) {
  if (word.size() > dialect.maxNameLength)
    return "it is longer than " + std::to_string(dialect.maxNameLength) + " characters";
  const std::string language(dialect.family);
  if (dialect.keywords.holds(word)) return quote(word) + " is a reserved word of " + language;
  for (const std::string_view prefix : {"gl_", "GL_", "webgl_", "_webgl_"}) {
    if (word.starts_with(prefix))
      return "names that start with gl_ or webgl_ are reserved in GLSL, such as " + quote(word);
  }
  if (word.find("__") != std::string_view::npos)
    return "names with two consecutive underscores are reserved in " + language + ", such as " +
           quote(word);
  if (isCalledByUs(dialect, word)) return quote(word) + " is a function of " + language;
  return {};
}

}  // namespace

std::string inputProblem(const Dialect& dialect, std::string_view text) {
  if (text.find_first_not_of(' ') == std::string_view::npos) return "it is empty";
  if (auto problem = syntaxProblem(text, dialect.operators); !problem.empty()) return problem;
  if (Dialect::holds(dialect.nonFloats, text))
    return "it is not a float; write float(" + std::string(text) + ')';
  for (const std::string_view word : identifiers(text)) {
    const std::size_t end = text.find_first_not_of(' ', word.data() - text.data() + word.size());
    const char next = end == text.npos ? ' ' : text[end];
    const bool isTemplate = dialect.hasTemplates && (next == '<' || next == '>');
    if ((next == '(' || isTemplate) && Dialect::holds(dialect.constructors, word)) continue;
    if (next == '(' && isCalledByUs(dialect, word)) continue;
    if (Dialect::holds(dialect.builtIns, word)) continue;
    if (auto problem = reservedProblem(dialect, word); !problem.empty()) return problem;
  }
  return {};
}

std::string outputProblem(const Dialect& dialect, std::string_view name) {
  const bool isIdentifier =
      !name.empty() && isWordStart(name[0]) && std::all_of(name.begin(), name.end(), isWordPart);
  if (!isIdentifier)
    return "a name consists of letters, digits and underscores and does not start with a digit";
  return reservedProblem(dialect, name);
}

std::string functionProblem(const Dialect& dialect, std::string_view name) {
  if (name == "main") return "it is the entry point of a shader";
  if (name.starts_with(ourPrefix)) return "such names are reserved for warpjet; rename it";
  if (Dialect::holds(dialect.functions, name))
    return quote(name) + " is a function of " + std::string(dialect.family);
  return outputProblem(dialect, name);
}

bool isCalled(std::string_view text, std::string_view word) {
  const std::size_t end = static_cast<std::size_t>(word.data() - text.data()) + word.size();
  const std::size_t next = text.find_first_not_of(" \t\n", end);
  return next != text.npos && text[next] == '(';
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
  for (const std::string_view name : identifiers(text)) {
    const bool mayClash = name.size() > 1 && name[0] == 't' && isDigit(name[1]);
    if (mayClash) used_.emplace(name);
  }
}

std::string Temporaries::next() {
  std::string name;
  do {
    name = 't' + std::to_string(count_++);
  } while (used_.contains(name));
  return name;
}

}  // namespace warpjet
