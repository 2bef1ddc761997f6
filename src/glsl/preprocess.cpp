#include "glsl/preprocess.hpp"

#include <algorithm>
#include <map>
#include <span>

#include "glsl/condition.hpp"
#include "glsl/macros.hpp"

namespace warpjet::glsl {

namespace {

using Kind = Token::Kind;
using Line = std::span<const Token>;

class Preprocessor {
 public:
  Preprocessor(std::vector<Token> tokens, Problems& problems)
      : tokens_(std::move(tokens)), problems_(problems), macros_(problems, result_.made) {
    macros_.define("GL_ES", 1);
    macros_.define("GL_FRAGMENT_PRECISION_HIGH", 1);
    macros_.define("__FILE__", 0);
    macros_.define("__VERSION__", 300);
  }

  Preprocessed run() {
    std::size_t at = 0;
    while (at < tokens_.size() && tokens_[at].kind != Kind::End && !problems_.any()) {
      std::size_t end = at + 1;
      const bool isDirective = tokens_[at].is("#") && tokens_[at].startsLine;
      // A macro's arguments may go over several lines, a directive is one.
      while (end < tokens_.size() && tokens_[end].kind != Kind::End &&
             !(tokens_[end].startsLine && (isDirective || tokens_[end].is("#"))))
        ++end;
      shift(at, end);
      const Line line = Line(tokens_).subspan(at, end - at);
      if (isDirective) {
        directive(line);
      } else if (isLive()) {
        macros_.expand(line, result_.tokens);
      }
      at = end;
    }
    if (!blocks_.empty()) problems_.add(blocks_.back().place, "this #if has no #endif");
    Token end = tokens_.back();
    end.place.shown = static_cast<std::uint32_t>(end.place.line + lineShift_);
    result_.tokens.push_back(end);
    return std::move(result_);
  }

 private:
  // An #if with what follows it, until its #endif.
  struct Block {
    Location place;
    bool isLive, wasLive, isOuterLive, hasElse = false;
  };

  bool isLive() const { return blocks_.empty() || blocks_.back().isLive; }

  void shift(std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i)
      tokens_[i].place.shown = static_cast<std::uint32_t>(tokens_[i].place.line + lineShift_);
  }

  void directive(Line line) {
    if (line.size() == 1) return;
    const Token& word = line[1];
    const bool isFirst = &line[0] == &tokens_[0];
    const Line rest = line.subspan(2);
    if (word.is("if") || word.is("ifdef") || word.is("ifndef")) return open(word, rest);
    if (word.is("elif") || word.is("else") || word.is("endif")) return resume(word, rest);
    if (!isLive()) return;
    if (word.is("define")) return macros_.define(word, rest);
    if (word.is("undef")) return macros_.undefine(word, rest);
    if (word.is("version")) return version(word, rest, isFirst);
    if (word.is("line")) return renumber(word, rest);
    if (word.is("error")) {
      std::string text;
      for (const Token& token : rest) (text += text.empty() ? "" : " ") += token.text;
      return problems_.add(word.place, "#error" + (text.empty() ? "" : ": " + text));
    }
    // What a host asks of its driver.
    if (word.is("extension") || word.is("pragma")) return;
    problems_.add(word.place, "there is no directive #" + std::string(word.text));
  }

  void open(const Token& word, Line rest) {
    const bool isOuterLive = isLive();
    bool holds = false;
    if (isOuterLive) {
      if (word.is("if")) {
        holds = isTrue(word, rest);
      } else if (rest.empty() || rest[0].kind != Kind::Name) {
        problems_.add(word.place, "#" + std::string(word.text) + " needs a name");
      } else {
        holds = macros_.has(rest[0].text) == word.is("ifdef");
      }
    }
    blocks_.push_back({word.place, isOuterLive && holds, holds, isOuterLive});
  }

  void resume(const Token& word, Line rest) {
    if (blocks_.empty())
      return problems_.add(word.place, "#" + std::string(word.text) + " has no #if before it");
    Block& block = blocks_.back();
    if (word.is("endif")) return blocks_.pop_back();
    if (block.hasElse)
      return problems_.add(word.place, "#" + std::string(word.text) + " stands after #else");
    block.hasElse = word.is("else");
    const bool mayHold = block.isOuterLive && !block.wasLive;
    block.isLive = mayHold && (block.hasElse || isTrue(word, rest));
    block.wasLive = block.wasLive || block.isLive;
  }

  bool isTrue(const Token& word, Line rest) {
    return evaluateCondition(word, rest, macros_, problems_);
  }

  void version(const Token& word, Line rest, bool isFirst) {
    if (!isFirst) return problems_.add(word.place, "#version must come before everything else");
    const bool isNumber = !rest.empty() && rest[0].kind == Kind::Int;
    const std::uint32_t number = isNumber ? intValue(rest[0], problems_) : 0;
    const bool isWhole = number == 300 ? rest.size() == 2 && rest[1].is("es") : rest.size() == 1;
    if ((number != 100 && number != 300) || !isWhole)
      return problems_.add(word.place, "write #version 300 es or #version 100; WebGL has no other");
    result_.version = static_cast<int>(number);
    macros_.define("__VERSION__", result_.version);
  }

  void renumber(const Token& word, Line rest) {
    std::vector<Token> tokens;
    macros_.expand(rest, tokens);
    if (tokens.empty() || tokens[0].kind != Kind::Int)
      return problems_.add(word.place, "#line needs the number of a line");
    lineShift_ = static_cast<std::int64_t>(intValue(tokens[0], problems_)) - word.place.line - 1;
  }

  std::vector<Token> tokens_;
  Problems& problems_;
  Preprocessed result_;
  Macros macros_;
  std::vector<Block> blocks_;
  std::int64_t lineShift_ = 0;
};

}  // namespace

Preprocessed preprocess(std::vector<Token> tokens, Problems& problems) {
  return Preprocessor(std::move(tokens), problems).run();
}

}  // namespace warpjet::glsl
