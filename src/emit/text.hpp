// Writes a module in a language: returns shader code, or a message that says why there is none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emit/dialect.hpp"
#include "emit/emit.hpp"
#include "module/module.hpp"

namespace warpjet {

// The host's name for an input or a result, by number.
struct Naming {
  std::uint32_t number;
  std::string text;
};

struct ShaderTextOptions {
  std::vector<Naming> results = {};  // the results to write, in this order; empty for all
  std::vector<Naming> inputs = {};   // inputs with other names than in the module
  EmitOptions emit = {};
  // Only a fragment shader can do these: fade noise that is finer than a pixel, and reflect numbers
  // that are outside of the domain of an operation by less than a pixel.
  bool fadesNoise = false;
  bool reflectsAtBorders = false;
};

struct ShaderText {
  EmittedCode emitted;         // for the body of a function
  std::string declarations;    // to be placed above that function
  std::vector<Naming> inputs;  // inputs of the host that the code reads
};

struct ShaderTextResult {
  std::optional<ShaderText> text;
  std::string problem = {};
};

ShaderTextResult write(const Module& module, const Dialect& dialect,
                       const ShaderTextOptions& options = {});

}  // namespace warpjet
