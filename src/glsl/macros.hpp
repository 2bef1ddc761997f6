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

  void define(std::string_view name, int value);
  // The rest of the line after the word of a directive.
  void define(const Token& word, std::span<const Token> rest);
  void undefine(const Token& word, std::span<const Token> rest);

  // Every token of an expansion has the place where the macro is called, but those of an argument,
  // which have their own.
  void expand(std::span<const Token> tokens, std::vector<Token>& result);

 private:
  struct Macro {
    bool hasParameters = false;
    std::vector<std::string_view> parameters;
    std::vector<Token> body;
  };

  // Macros that are being expanded: none does so within itself.
  using Within = std::vector<std::string_view>;

  void expand(std::span<const Token> tokens, std::vector<Token>& result, Within& within);
  bool readArguments(std::span<const Token> tokens, std::size_t& at, std::size_t count,
                     std::vector<std::vector<Token>>& arguments);
  // Puts in the place of the last token what it stands for as a macro, and says whether it did.
  // Arguments come after the token number `at`.
  bool expandLast(std::span<const Token> tokens, std::size_t& at, std::vector<Token>& result,
                  Within& within);
  void substitute(const Macro& macro, Location place, std::vector<std::vector<Token>>& arguments,
                  std::vector<Token>& result, Within& within);
  Token number(std::uint32_t value, const Token& like);

  std::map<std::string_view, Macro> macros_;
  Problems& problems_;
  std::deque<std::string>& made_;
};

}  // namespace warpjet::glsl
