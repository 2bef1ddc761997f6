// Macros of `#define`, and their expansion.
#pragma once

#include <deque>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "source/glsl/tokens.hpp"

namespace warpjet::source::glsl {

class Macros {
 public:
  Macros(Problems& problems, std::deque<std::string>& made) : problems_(problems), made_(made) {}

  bool has(std::string_view name) const { return macros_.contains(name) || name == "__LINE__"; }

  // Defines a predefined macro.
  void define(std::string_view name, int value);
  // `rest` is the rest of the line after `directive`.
  void define(const Token& directive, std::span<const Token> rest);
  void undefine(const Token& directive, std::span<const Token> rest);

  // Every token of an expansion has the location of the macro's call, except tokens of arguments,
  // which have their own.
  void expand(std::span<const Token> tokens, std::vector<Token>& result);

  // Calls `visit(name)` for all names that are defined.
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

  // The names of the macros being expanded, since a macro isn't expanded within itself.
  using Within = std::vector<std::string_view>;

  // Tokens being expanded, which are nested in `depth` macros; those before index `at` are done. If
  // they are themselves an expansion, `around` is the stream that continues after them.
  struct Stream {
    std::span<const Token> tokens;
    std::size_t depth;
    Stream* around = nullptr;
    std::size_t at = 0;
  };

  void expand(Stream& stream, std::vector<Token>& result, const Within& within);
  // Reads from the current parenthesis to its counterpart, which may be after an expansion;
  // `stream` becomes the stream that contains it.
  bool readArguments(Stream*& stream, std::size_t count,
                     std::vector<std::vector<Token>>& arguments);
  // Replaces the last token by its expansion if it is a macro; returns whether it did.
  bool expandLast(Stream& stream, std::vector<Token>& result, const Within& within);
  void substitute(const Macro& macro, const Token& name, std::uint32_t line,
                  std::vector<std::vector<Token>>& arguments, std::vector<Token>& result,
                  Within within, Stream& rest);
  // Returns the line for __LINE__. A call over several lines has the number of its last line.
  static std::uint32_t lineOf(const Token& token) {
    return token.callLine ? token.callLine : token.location.shown;
  }
  Token number(std::uint32_t value, const Token& like);
  static bool isSame(const Macro& a, const Macro& b);

  std::map<std::string_view, Macro> macros_;
  // The calls being expanded, and the number of tokens in their arguments.
  int nested_ = 0;
  std::size_t argumentTokens_ = 0;
  Problems& problems_;
  std::deque<std::string>& made_;
};

}  // namespace warpjet::source::glsl
