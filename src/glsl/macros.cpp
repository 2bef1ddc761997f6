#include "glsl/macros.hpp"

#include <algorithm>

namespace warpjet::glsl {

using Kind = Token::Kind;

namespace {

// Of one text: macros that call each other twice, thirty deep, would make a billion.
constexpr std::size_t mostTokens = std::size_t{1} << 20;
constexpr const char* tooLong = "this text is too long once its macros are expanded";
constexpr std::size_t deepestWithin = 100;
// Calls in arguments of calls, and in what expansions have opened.
constexpr int deepestNested = 1'000;

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
  Stream stream{tokens, 0};
  expand(stream, result, {});
}

Token Macros::number(std::uint32_t value, const Token& like) {
  made_.push_back(std::to_string(value));
  return {Kind::Int, like.startsLine, like.followsSpace, made_.back(), like.place};
}

void Macros::expand(Stream& stream, std::vector<Token>& result, const Within& within) {
  for (; stream.at < stream.tokens.size() && !problems_.any(); ++stream.at) {
    const Token& token = stream.tokens[stream.at];
    if (result.size() > mostTokens) return problems_.add(token.place, tooLong);
    if (token.is("__LINE__")) {
      result.push_back(number(token.place.shown, token));
      continue;
    }
    const std::size_t before = result.size();
    result.push_back(token);
    // What an expansion ends with may be called by what follows.
    while (result.size() > before && expandLast(stream, result, within)) {
    }
  }
}

bool Macros::expandLast(Stream& stream, std::vector<Token>& result, const Within& within) {
  const Token token = result.back();
  if (token.kind != Kind::Name || token.isPlain || problems_.any()) return false;
  const auto found = macros_.find(token.text);
  if (found == macros_.end()) return false;
  if (std::find(within.begin(), within.end(), token.text) != within.end()) {
    result.back().isPlain = true;
    return false;
  }
  const Macro& macro = found->second;
  const std::size_t next = stream.at + 1;
  const bool isCalled = next < stream.tokens.size() && stream.tokens[next].is("(");
  if (macro.hasParameters && !isCalled) return false;
  if (within.size() >= deepestWithin) {
    problems_.add(token.place, "macros call each other more than 100 deep here");
    return false;
  }
  if (nested_ >= deepestNested) {
    problems_.add(token.place, "calls of macros stand within each other more than 1,000 deep here");
    return false;
  }
  std::vector<std::vector<Token>> arguments;
  Stream* rest = &stream;
  if (macro.hasParameters) {
    ++stream.at;
    if (!readArguments(rest, macro.parameters.size(), arguments)) {
      problems_.add(token.place, "the macro " + quoted(token.text) + " takes " +
                                     std::to_string(macro.parameters.size()) + " arguments in ( )");
      return false;
    }
  }
  result.pop_back();
  // Macros whose expansion has been left by then may be used again.
  const auto depth = static_cast<Within::difference_type>(rest->depth);
  std::size_t held = 0;
  for (const std::vector<Token>& argument : arguments) held += argument.size();
  held_ += held;
  ++nested_;
  if (held_ > mostTokens) problems_.add(token.place, tooLong);
  substitute(macro, token, arguments, result, {within.begin(), within.begin() + depth}, *rest);
  --nested_;
  held_ -= held;
  return true;
}

bool Macros::readArguments(Stream*& stream, std::size_t count,
                           std::vector<std::vector<Token>>& arguments) {
  int depth = 0;
  arguments.emplace_back();
  for (;; ++stream->at) {
    while (stream->at >= stream->tokens.size()) {
      if (stream->around == nullptr) return false;
      stream = stream->around;
      ++stream->at;
    }
    const Token& token = stream->tokens[stream->at];
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
}

// What is named in arguments is not yet within the macro, so that it is expanded before.
void Macros::substitute(const Macro& macro, const Token& name,
                        std::vector<std::vector<Token>>& arguments, std::vector<Token>& result,
                        Within within, Stream& rest) {
  std::vector<Token> body;
  for (std::vector<Token>& argument : arguments) {
    std::vector<Token> expanded;
    Stream stream{argument, within.size()};
    expand(stream, expanded, within);
    argument = std::move(expanded);
  }
  for (const Token& token : macro.body) {
    const auto parameter = std::find(macro.parameters.begin(), macro.parameters.end(), token.text);
    if (token.kind == Kind::Name && parameter != macro.parameters.end()) {
      const auto& argument = arguments[parameter - macro.parameters.begin()];
      body.insert(body.end(), argument.begin(), argument.end());
    } else {
      body.push_back(token);
      body.back().place = name.place;
    }
    if (body.size() > mostTokens) return problems_.add(name.place, tooLong);
  }
  within.push_back(name.text);
  Stream stream{body, within.size(), &rest};
  expand(stream, result, within);
}

}  // namespace warpjet::glsl
