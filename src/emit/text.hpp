// A module in a language: the text, or one sentence that says why there is none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emit/dialect.hpp"
#include "emit/emit.hpp"
#include "module/module.hpp"

namespace warpjet {

// What the host calls an input or a result, by number.
struct Naming {
  std::uint32_t number;
  std::string text;
};

struct TextOptions {
  std::vector<Naming> results = {};  // those that are wanted, in this order; all if there are none
  std::vector<Naming> inputs = {};   // those that are called otherwise than in the module
  EmitOptions emit = {};
};

struct Text {
  Emitted emitted;             // for the inside of a function
  std::string declarations;    // for above it
  std::vector<Naming> inputs;  // that the text reads and the host gives
};

struct Written {
  std::optional<Text> text;
  std::string problem = {};
};

Written write(const Module& module, const Dialect& dialect, const TextOptions& options = {});

}  // namespace warpjet
