// The preprocessor: executes directives and expands macros, and returns the remaining tokens. GLSL
// ES 3.00, section 3.4.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "source/glsl/tokens.hpp"

namespace warpjet::source::glsl {

struct PreprocessedSource {
  std::vector<Token> tokens;
  // 100 or 300; 0 without #version.
  int version = 0;
  // The text of tokens created by macros.
  std::deque<std::string> made;
};

PreprocessedSource preprocess(std::vector<Token> tokens, Problems& problems);

}  // namespace warpjet::source::glsl
