#include "source/glsl/preprocess.hpp"

#include <algorithm>
#include <span>

#include "source/glsl/condition.hpp"
#include "source/glsl/macros.hpp"

namespace warpjet::source::glsl {

using Kind = Token::Kind;

namespace {

using Line = std::span<const Token>;

class Preprocessor {
 public:
  Preprocessor(std::vector<Token> tokens, Problems& problems)
      : tokens_(std::move(tokens)), problems_(problems), macros_(problems, result_.made) {
    macros_.define("GL_ES", 1);
    macros_.define("GL_FRAGMENT_PRECISION_HIGH", 1);
    macros_.define("__FILE__", 0);
    // Browsers treat a source without #version as 1.00.
    macros_.define("__VERSION__", 100);
  }

  PreprocessedSource run() {
    std::size_t start = 0;
    while (start < tokens_.size() && tokens_[start].kind != Kind::End && !problems_.any()) {
      std::size_t end = start + 1;
      const bool isDirective = tokens_[start].is("#") && tokens_[start].startsLine;
      // A directive is a single line, apart from lines joined by a backslash. The arguments of a
      // macro may span several lines.
      while (end < tokens_.size() && tokens_[end].kind != Kind::End &&
             !(tokens_[end].startsLine && (isDirective || tokens_[end].is("#"))))
        ++end;
      applyLineShift(start, end);
      const Line line = Line(tokens_).subspan(start, end - start);
      if (isDirective) {
        directive(line);
      } else if (isLive()) {
        macros_.expand(line, result_.tokens);
      }
      start = end;
    }
    if (!blocks_.empty()) problems_.add(blocks_.back().location, "this #if has no #endif");
    Token end = tokens_.back();
    end.location.shown = static_cast<std::uint32_t>(end.location.line + lineShift_);
    for (const Token& token : result_.tokens)
      if (token.kind == Kind::Other) problems_.add(token.location, problemOf(token));
    result_.tokens.push_back(end);
    return std::move(result_);
  }

 private:
  // An #if with its branches, until its #endif. `isLive` is true if the tokens of the current
  // branch are kept, `wasLive` if a branch has been chosen already.
  struct Block {
    Location location;
    bool isLive, wasLive, isOuterLive, hasElse = false;
  };

  bool isLive() const { return blocks_.empty() || blocks_.back().isLive; }

  // Sets the line numbers that messages show, which `#line` changes.
  void applyLineShift(std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i)
      tokens_[i].location.shown = static_cast<std::uint32_t>(tokens_[i].location.line + lineShift_);
  }

  void directive(Line line) {
    if (line.size() == 1) return;
    const Token& word = line[1];
    const bool isFirst = &line[0] == &tokens_[0];
    const Line rest = line.subspan(2);
    if (word.is("if") || word.is("ifdef") || word.is("ifndef")) return open(word, rest);
    if (word.is("elif") || word.is("else") || word.is("endif"))
      return continueOrCloseBlock(word, rest);
    if (!isLive()) return;
    if (word.is("define")) return macros_.define(word, rest);
    if (word.is("undef")) return macros_.undefine(word, rest);
    if (word.is("version")) return version(word, rest, isFirst);
    if (word.is("line")) return renumber(word, rest);
    if (word.is("error")) {
      std::string text;
      for (const Token& token : rest) (text += text.empty() ? "" : " ") += token.text;
      return problems_.add(word.location, "#error" + (text.empty() ? "" : ": " + text));
    }
    if (word.is("extension")) return extension(word, rest);
    if (word.is("pragma")) return pragma(rest);
    if (word.is("include"))
      return problems_.add(word.location,
                           "GLSL has no #include; replace it with the source in the file");
    problems_.add(word.location, word.kind == Kind::Other
                                     ? problemOf(word)
                                     : "there is no directive #" + std::string(word.text));
  }

  void rejectExtra(const Token& word, Line rest, std::size_t count) {
    if (rest.size() > count)
      problems_.add(rest[count].location, "unexpected " + quote(rest[count].text) + " after #" +
                                              std::string(word.text) +
                                              "; put it into a comment, or on a line of its own");
  }

  void open(const Token& word, Line rest) {
    const bool isOuterLive = isLive();
    bool holds = false;
    if (isOuterLive) {
      if (word.is("if")) {
        holds = isTrue(word, rest);
      } else if (rest.empty() || rest[0].kind != Kind::Name) {
        problems_.add(word.location, "#" + std::string(word.text) + " needs a name");
      } else {
        holds = macros_.has(rest[0].text) == word.is("ifdef");
        rejectExtra(word, rest, 1);
      }
    }
    blocks_.push_back({word.location, isOuterLive && holds, holds, isOuterLive});
  }

  // Handles #elif, #else and #endif.
  void continueOrCloseBlock(const Token& word, Line rest) {
    if (blocks_.empty())
      return problems_.add(word.location, "#" + std::string(word.text) + " has no #if before it");
    Block& block = blocks_.back();
    if (word.is("endif")) {
      rejectExtra(word, rest, 0);
      return blocks_.pop_back();
    }
    if (!block.isOuterLive) return;
    if (word.is("else")) rejectExtra(word, rest, 0);
    if (block.hasElse)
      return problems_.add(word.location, "#" + std::string(word.text) + " comes after #else");
    block.hasElse = word.is("else");
    const bool mayHold = !block.wasLive;
    block.isLive = mayHold && (block.hasElse || isTrue(word, rest));
    block.wasLive = block.wasLive || block.isLive;
  }

  bool isTrue(const Token& word, Line rest) {
    return evaluateCondition(word, rest, macros_, problems_);
  }

  void version(const Token& word, Line rest, bool isFirst) {
    if (!isFirst) return problems_.add(word.location, "#version must come before everything else");
    const bool isNumber = !rest.empty() && rest[0].kind == Kind::Int;
    const std::uint32_t number = isNumber ? intValue(rest[0], problems_) : 0;
    const bool isWhole = number == 300 ? rest.size() == 2 && rest[1].is("es") : rest.size() == 1;
    if ((number != 100 && number != 300) || !isWhole)
      return problems_.add(word.location,
                           "write #version 300 es or #version 100; WebGL has no other");
    result_.version = static_cast<int>(number);
    macros_.define("__VERSION__", result_.version);
  }

  void renumber(const Token& word, Line rest) {
    const LineNumbers numbers = evaluateLine(word, rest, macros_, problems_);
    // A directive may span several lines that are joined by a backslash.
    const std::uint32_t last = rest.empty() ? word.location.line : rest.back().location.line;
    lineShift_ = static_cast<std::int64_t>(numbers.line) - last - 1;
    if (numbers.file) macros_.define("__FILE__", *numbers.file);
  }

  // Reads `name : behavior`: GLSL ES 3.00, section 3.5. Doesn't check whether the extension is
  // available: only the host can query that.
  void extension(const Token& word, Line rest) {
    const bool isName = !rest.empty() && rest[0].kind == Kind::Name;
    if (!isName || rest.size() < 3 || !rest[1].is(":") || rest.size() > 3)
      return problems_.add(word.location,
                           "write it as #extension NAME : enable; instead of enable, "
                           "require, warn or disable are allowed");
    const Token &name = rest[0], &behavior = rest[2];
    const bool requires_ = behavior.is("require"), enables = requires_ || behavior.is("enable");
    if (!enables && !behavior.is("warn") && !behavior.is("disable"))
      return problems_.add(behavior.location,
                           quote(behavior.text) +
                               " is not a behavior of an extension; write enable, "
                               "require, warn or disable");
    if (name.is("all") && enables)
      return problems_.add(behavior.location, "#extension all allows only warn and disable; to " +
                                                  std::string(behavior.text) +
                                                  " an extension, name it");
    if (requires_ && !isExtension(name.text))
      return problems_.add(name.location, "WebGL has no extension " + quote(name.text) +
                                              "; write enable to go on without it");
    if (result_.version == 300 && !result_.tokens.empty())
      problems_.add(word.location,
                    "#extension must come before everything but other directives in "
                    "#version 300 es; move it up");
  }

  static bool isExtension(std::string_view name) {
    for (const std::string_view prefix : {"GL_OES_", "GL_EXT_", "GL_ARB_", "GL_ANGLE_", "GL_OVR_",
                                          "GL_KHR_", "GL_NV_", "GL_WEBGL_"})
      if (name.starts_with(prefix)) return true;
    return false;
  }

  void pragma(Line rest) {
    const bool isSwitch = rest.size() == 1 && (rest[0].is("optimize") || rest[0].is("debug"));
    if (isSwitch)
      problems_.add(rest[0].location,
                    "write #pragma " + std::string(rest[0].text) + "(on) or (off)");
  }

  std::vector<Token> tokens_;
  Problems& problems_;
  PreprocessedSource result_;
  Macros macros_;
  std::vector<Block> blocks_;
  std::int64_t lineShift_ = 0;
};

}  // namespace

PreprocessedSource preprocess(std::vector<Token> tokens, Problems& problems) {
  return Preprocessor(std::move(tokens), problems).run();
}

}  // namespace warpjet::source::glsl
