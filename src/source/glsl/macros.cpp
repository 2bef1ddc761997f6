#include "source/glsl/macros.hpp"

#include <algorithm>

namespace warpjet::source::glsl {

using Kind = Token::Kind;

namespace {

// The limit per source: macros that call each other twice, nested thirty deep, would expand to a
// billion tokens.
constexpr std::size_t maxTokens = std::size_t{1} << 20;
constexpr const char* tooLong = "this source is too long once its macros are expanded";
constexpr std::size_t maxMacroDepth = 100;
// Limits calls within arguments of calls and within expansions.
constexpr int maxCallDepth = 1'000;

}  // namespace

void Macros::define(std::string_view name, int value) {
  made_.push_back(std::to_string(value));
  macros_[name] = {false, {}, {Token{Kind::Int, false, true, made_.back(), {}}}, 0, true};
}

void Macros::define(const Token& directive, std::span<const Token> rest) {
  if (rest.empty() || rest[0].kind != Kind::Name)
    return problems_.add(directive.location, "#define needs a name");
  const Token& name = rest[0];
  const auto known = macros_.find(name.text);
  const bool isKnown = known != macros_.end();
  if (name.text.starts_with("GL_") || name.is("defined") || name.is("__LINE__") ||
      (isKnown && known->second.isOfLanguage))
    return problems_.add(name.location, quote(name.text) + " cannot be defined: it is predefined");
  Macro macro;
  macro.line = name.location.shown;
  std::size_t at = 1;
  if (at < rest.size() && rest[at].is("(") && !rest[at].followsSpace) {
    macro.hasParameters = true;
    ++at;
    const auto isEnd = [&] { return at < rest.size() && rest[at].is(")"); };
    while (!isEnd()) {
      if (at >= rest.size() || rest[at].kind != Kind::Name)
        return problems_.add(name.location,
                             "the parameters of " + quote(name.text) + " must be names in ( )");
      const std::string_view parameter = rest[at++].text;
      if (std::find(macro.parameters.begin(), macro.parameters.end(), parameter) !=
          macro.parameters.end())
        return problems_.add(rest[at - 1].location,
                             quote(parameter) + " is already a parameter of " + quote(name.text) +
                                 "; give it another name");
      macro.parameters.push_back(parameter);
      if (at < rest.size() && rest[at].is(",")) {
        ++at;
      } else if (!isEnd()) {
        return problems_.add(name.location, "the parameters of " + quote(name.text) +
                                                " need a comma between them and a ) at the end");
      }
    }
    ++at;
  }
  macro.body.assign(rest.begin() + static_cast<std::ptrdiff_t>(at), rest.end());
  if (isKnown && !isSame(macro, known->second))
    return problems_.add(name.location,
                         quote(name.text) + " was defined with another value in line " +
                             std::to_string(known->second.line) + "; write #undef " +
                             std::string(name.text) + " before this line, or use another name");
  macros_[name.text] = std::move(macro);
}

// Returns true if two definitions are equal token by token; the amount of white space doesn't
// matter.
bool Macros::isSame(const Macro& a, const Macro& b) {
  if (a.hasParameters != b.hasParameters || a.parameters != b.parameters ||
      a.body.size() != b.body.size())
    return false;
  for (std::size_t i = 0; i < a.body.size(); ++i) {
    if (a.body[i].text != b.body[i].text) return false;
    if (i > 0 && a.body[i].followsSpace != b.body[i].followsSpace) return false;
  }
  return true;
}

void Macros::undefine(const Token& directive, std::span<const Token> rest) {
  if (rest.empty() || rest[0].kind != Kind::Name)
    return problems_.add(directive.location, "#undef needs a name");
  const std::string_view name = rest[0].text;
  const auto known = macros_.find(name);
  if (name == "__LINE__" || (known != macros_.end() && known->second.isOfLanguage))
    return problems_.add(rest[0].location, quote(name) + " cannot be undefined: it is predefined");
  if (rest.size() > 1)
    return problems_.add(rest[1].location, "#undef takes one name; remove " + quote(rest[1].text) +
                                               " and everything after it");
  macros_.erase(name);
}

void Macros::expand(std::span<const Token> tokens, std::vector<Token>& result) {
  Stream stream{tokens, 0};
  expand(stream, result, {});
}

Token Macros::number(std::uint32_t value, const Token& like) {
  made_.push_back(std::to_string(value));
  return {Kind::Int, like.startsLine, like.followsSpace, made_.back(), like.location};
}

void Macros::expand(Stream& stream, std::vector<Token>& result, const Within& within) {
  for (; stream.at < stream.tokens.size() && !problems_.any(); ++stream.at) {
    const Token& token = stream.tokens[stream.at];
    if (result.size() > maxTokens) return problems_.add(token.location, tooLong);
    if (token.is("__LINE__")) {
      result.push_back(number(lineOf(token), token));
      continue;
    }
    const std::size_t before = result.size();
    result.push_back(token);
    // The last token of an expansion may be a macro that is called by what follows.
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
  if (within.size() >= maxMacroDepth) {
    problems_.add(token.location, "macros are nested more than 100 deep here");
    return false;
  }
  if (nested_ >= maxCallDepth) {
    problems_.add(token.location, "calls of macros are nested more than 1,000 deep here");
    return false;
  }
  std::vector<std::vector<Token>> arguments;
  Stream* rest = &stream;
  std::uint32_t line = lineOf(token);
  if (macro.hasParameters) {
    ++stream.at;
    if (!readArguments(rest, macro.parameters.size(), arguments)) {
      problems_.add(token.location, "the macro " + quote(token.text) + " takes " +
                                        std::to_string(macro.parameters.size()) +
                                        " arguments in ( )");
      return false;
    }
    line = lineOf(rest->tokens[rest->at]);
  }
  result.pop_back();
  // Macros whose expansion has ended before the closing parenthesis may be used again.
  const auto depth = static_cast<Within::difference_type>(rest->depth);
  std::size_t argumentCount = 0;
  for (const std::vector<Token>& argument : arguments) argumentCount += argument.size();
  argumentTokens_ += argumentCount;
  ++nested_;
  if (argumentTokens_ > maxTokens) problems_.add(token.location, tooLong);
  substitute(macro, token, line, arguments, result, {within.begin(), within.begin() + depth},
             *rest);
  --nested_;
  argumentTokens_ -= argumentCount;
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

// Expands the arguments, substitutes them in the body, and expands the result. A macro may be used
// in its own arguments, since these are expanded first, outside of it.
void Macros::substitute(const Macro& macro, const Token& name, std::uint32_t line,
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
      body.back().location = name.location;
      body.back().callLine = line;
    }
    if (body.size() > maxTokens) return problems_.add(name.location, tooLong);
  }
  within.push_back(name.text);
  Stream stream{body, within.size(), &rest};
  expand(stream, result, within);
}

}  // namespace warpjet::source::glsl
