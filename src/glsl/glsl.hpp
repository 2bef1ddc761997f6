// The room's door: a text, its functions, and one of them as a list of operations in plain words,
// that whoever has a builder makes again, from the first to the last. It is read once.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "glsl/lower.hpp"
#include "glsl/source.hpp"
#include "glsl/tree.hpp"

namespace warpjet::glsl {

// What the host gives: a uniform or an attribute of the text.
struct HostName {
  std::string name, type;
  bool isAttribute;
  bool isRead;                         // by the function
  std::array<std::uint32_t, 2> shape;  // columns and rows
};

struct HeadParameter {
  std::string type, name;  // "?" without a name
  bool isOut;
};

// A function with a body.
struct FunctionHead {
  std::uint32_t number;
  std::string type, name;
  std::vector<HeadParameter> parameters;
};

// Each operation is its code, then:
//   Constant     the number of its value; of an int or uint that is Whole
//   Argument     number, component, layout
//   Uniform      number among the names, component, layout
//                of both, what is whole has two halves: 128 in the layout says that it is the upper
//   Component    operand, component, layout: columns and rows of what it is of, four bits each
//   Texel        number of the image's name, operand; so has FetchedTexel
//   ImageSize    number of the image's name
//   Fold         how often it runs, how many states, and what these start as; the number of the
//   step
//                and the states are operations then, and those of its body follow, until
//   Next         what each step makes of the states, which are as many operations after it
//   Define       a function of the text, by the next of `routines`: how many arguments, and by how
//                many of them, the first ones, it has derivatives. Its body follows, whose
//                operations count from 0 on, until
//   End          how many numbers it gives, and these
//   Parameter    number of an argument, in such a body
//   Call         number of a function, how many arguments, and these; what it gives are as many
//                operations
//   any other    how many operands there are, and these
// An operand is the number of an operation before it.
struct Listing {
  std::vector<std::uint32_t> words;
  std::vector<double> constants;
  std::vector<std::uint32_t> results;
  std::vector<HostName> names;
  std::vector<std::string> routines;  // the names of functions that stay functions
};

class Source {
 public:
  explicit Source(std::string_view text);

  // The sentence with its place; empty where there is none.
  std::string problem() const { return problems_.any() ? problems_.text(text_.separate) : ""; }

  std::vector<FunctionHead> functions() const;

  // Nothing but a problem where the function cannot be lowered.
  Listing lower(int function, int maxIterations);

 private:
  Lines text_;
  Problems problems_;
  Tree tree_;
};

Listing list(const Lowered& lowered, const Types& types);

}  // namespace warpjet::glsl
