// The preprocessor: from the tokens of a text to those that are left when its directives are
// carried out and its macros expanded. GLSL ES 3.00, section 3.4.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "glsl/tokens.hpp"

namespace warpjet::glsl {

struct Preprocessed {
  std::vector<Token> tokens;
  // 100 or 300; 0 where the text does not say.
  int version = 0;
  // Texts that macros made.
  std::deque<std::string> made;
};

Preprocessed preprocess(std::vector<Token> tokens, Problems& problems);

}  // namespace warpjet::glsl
