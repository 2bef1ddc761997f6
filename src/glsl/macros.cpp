#include "glsl/macros.hpp"

#include <algorithm>

namespace warpjet::glsl {

using Kind = Token::Kind;

namespace {

// Of one text: macros that call each other twice, thirty deep, would make a billion.
constexpr std::size_t mostTokens = std::size_t{1} << 20;
constexpr std::size_t deepestWithin = 100;

}  // namespace

void Macros::define(std::string_view name, int value) {
  made_.push_back(std::to_string(value));
  macros_[name] = {false, {}, {Token{Kind::Int, false, true, made_.back(), {}}}};
}

void Macros::define(const Token& word, std::span<const Token> rest) {
  if (rest.empty() || rest[0].kind != Kind::Name)
    return problems_.add(word.place, "#define needs a name");
  const Token& name = rest[0];
  if (name.text.starts_with("GL_") || name.is("defined") || name.text.starts_with("__"))
    return problems_.add(name.place,
                         quoted(name.text) + " cannot be defined: it is the language's");
  Macro macro;
  std::size_t at = 1;
  if (at < rest.size() && rest[at].is("(") && !rest[at].followsSpace) {
    macro.hasParameters = true;
    ++at;
    const auto isEnd = [&] { return at < rest.size() && rest[at].is(")"); };
    while (!isEnd()) {
      if (at >= rest.size() || rest[at].kind != Kind::Name)
        return problems_.add(name.place,
                             "the parameters of " + quoted(name.text) + " must be names in ( )");
      macro.parameters.push_back(rest[at++].text);
      if (at < rest.size() && rest[at].is(",")) {
        ++at;
      } else if (!isEnd()) {
        return problems_.add(name.place, "the parameters of " + quoted(name.text) +
                                             " need a comma between them and a ) at the end");
      }
    }
    ++at;
  }
  macro.body.assign(rest.begin() + static_cast<std::ptrdiff_t>(at), rest.end());
  macros_[name.text] = std::move(macro);
}

void Macros::undefine(const Token& word, std::span<const Token> rest) {
  if (rest.empty() || rest[0].kind != Kind::Name)
    return problems_.add(word.place, "#undef needs a name");
  macros_.erase(rest[0].text);
}

void Macros::expand(std::span<const Token> tokens, std::vector<Token>& result) {
  Within within;
  expand(tokens, result, within);
}

Token Macros::number(std::uint32_t value, const Token& like) {
  made_.push_back(std::to_string(value));
  return {Kind::Int, like.startsLine, like.followsSpace, made_.back(), like.place};
}

void Macros::expand(std::span<const Token> tokens, std::vector<Token>& result, Within& within) {
  for (std::size_t at = 0; at < tokens.size() && !problems_.any(); ++at) {
    const Token& token = tokens[at];
    if (result.size() > mostTokens)
      return problems_.add(token.place, "this text is too long once its macros are expanded");
    if (token.is("__LINE__")) {
      result.push_back(number(token.place.shown, token));
      continue;
    }
    const std::size_t before = result.size();
    result.push_back(token);
    // What an expansion ends with may be called by what follows.
    while (result.size() > before && expandLast(tokens, at, result, within)) {
    }
  }
}

bool Macros::expandLast(std::span<const Token> tokens, std::size_t& at, std::vector<Token>& result,
                        Within& within) {
  const Token token = result.back();
  if (token.kind != Kind::Name || token.isPlain || problems_.any()) return false;
  const auto found = macros_.find(token.text);
  if (found == macros_.end()) return false;
  if (std::find(within.begin(), within.end(), token.text) != within.end()) {
    result.back().isPlain = true;
    return false;
  }
  const Macro& macro = found->second;
  const bool isCalled = at + 1 < tokens.size() && tokens[at + 1].is("(");
  if (macro.hasParameters && !isCalled) return false;
  if (within.size() >= deepestWithin) {
    problems_.add(token.place, "macros call each other more than 100 deep here");
    return false;
  }
  std::vector<std::vector<Token>> arguments;
  if (macro.hasParameters) {
    ++at;
    if (!readArguments(tokens, at, macro.parameters.size(), arguments)) {
      problems_.add(token.place, "the macro " + quoted(token.text) + " takes " +
                                     std::to_string(macro.parameters.size()) + " arguments in ( )");
      return false;
    }
  }
  result.pop_back();
  within.push_back(token.text);
  substitute(macro, token.place, arguments, result, within);
  within.pop_back();
  return true;
}

// From the parenthesis at `at` to the one that closes it. What is named there is not yet within
// the macro, so that it is expanded before.
bool Macros::readArguments(std::span<const Token> tokens, std::size_t& at, std::size_t count,
                           std::vector<std::vector<Token>>& arguments) {
  int depth = 0;
  arguments.emplace_back();
  for (; at < tokens.size(); ++at) {
    const Token& token = tokens[at];
    if (token.is("(") && depth++ == 0) continue;
    if (token.is(")") && --depth == 0) {
      if (count == 0 && arguments.size() == 1 && arguments[0].empty()) arguments.clear();
      return arguments.size() == count;
    }
    if (token.is(",") && depth == 1) {
      arguments.emplace_back();
    } else {
      arguments.back().push_back(token);
    }
  }
  return false;
}

void Macros::substitute(const Macro& macro, Location place,
                        std::vector<std::vector<Token>>& arguments, std::vector<Token>& result,
                        Within& within) {
  std::vector<Token> body;
  const std::string_view self = within.back();
  for (std::vector<Token>& argument : arguments) {
    std::vector<Token> expanded;
    within.pop_back();
    expand(argument, expanded, within);
    within.push_back(self);
    argument = std::move(expanded);
  }
  for (const Token& token : macro.body) {
    const auto parameter = std::find(macro.parameters.begin(), macro.parameters.end(), token.text);
    if (token.kind == Kind::Name && parameter != macro.parameters.end()) {
      const auto& argument = arguments[parameter - macro.parameters.begin()];
      body.insert(body.end(), argument.begin(), argument.end());
    } else {
      body.push_back(token);
      body.back().place = place;
    }
    if (body.size() > mostTokens)
      return problems_.add(place, "this text is too long once its macros are expanded");
  }
  expand(body, result, within);
}

}  // namespace warpjet::glsl
