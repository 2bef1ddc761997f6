// What `#define` names, and the expansion of it.
#pragma once

#include <deque>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "glsl/tokens.hpp"

namespace warpjet::glsl {

class Macros {
 public:
  Macros(Problems& problems, std::deque<std::string>& made) : problems_(problems), made_(made) {}

  bool has(std::string_view name) const { return macros_.contains(name) || name == "__LINE__"; }

  // One of the language's own.
  void define(std::string_view name, int value);
  // The rest of the line after the word of a directive.
  void define(const Token& word, std::span<const Token> rest);
  void undefine(const Token& word, std::span<const Token> rest);

  // Every token of an expansion has the place where the macro is called, but those of an argument,
  // which have their own.
  void expand(std::span<const Token> tokens, std::vector<Token>& result);

  // All names that are defined, to `visit(name)`.
  template <class Visit>
  void each(Visit visit) const {
    for (const auto& [name, macro] : macros_) visit(name);
  }

 private:
  struct Macro {
    bool hasParameters = false;
    std::vector<std::string_view> parameters;
    std::vector<Token> body;
    std::uint32_t line = 0;
    bool isOfLanguage = false;
  };

  // Macros that are being expanded: none does so within itself.
  using Within = std::vector<std::string_view>;

  // What is being expanded, as far as the token number `at`, within so many macros; and what comes
  // after it, where it is itself an expansion.
  struct Stream {
    std::span<const Token> tokens;
    std::size_t depth;
    Stream* around = nullptr;
    std::size_t at = 0;
  };

  void expand(Stream& stream, std::vector<Token>& result, const Within& within);
  // From the parenthesis at hand to the one that closes it, which may come after an expansion:
  // `stream` is the one where it stands.
  bool readArguments(Stream*& stream, std::size_t count,
                     std::vector<std::vector<Token>>& arguments);
  // Puts in the place of the last token what it stands for as a macro, and says whether it did.
  bool expandLast(Stream& stream, std::vector<Token>& result, const Within& within);
  void substitute(const Macro& macro, const Token& name, std::uint32_t line,
                  std::vector<std::vector<Token>>& arguments, std::vector<Token>& result,
                  Within within, Stream& rest);
  // A call over several lines has the number of the last.
  static std::uint32_t lineOf(const Token& token) {
    return token.callLine ? token.callLine : token.place.shown;
  }
  Token number(std::uint32_t value, const Token& like);
  static bool isSame(const Macro& a, const Macro& b);

  std::map<std::string_view, Macro> macros_;
  // Calls that are being expanded, and the tokens of their arguments.
  int nested_ = 0;
  std::size_t held_ = 0;
  Problems& problems_;
  std::deque<std::string>& made_;
};

}  // namespace warpjet::glsl
