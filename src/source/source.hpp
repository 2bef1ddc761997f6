// The public interface of this module: lists the functions of a parsed source, and lowers one of
// them to a listing of operations in plain words, which is replayed to a builder from first to
// last.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "source/lower.hpp"
#include "source/problems.hpp"
#include "source/tree.hpp"

namespace warpjet::source {

// An input that the host provides: a uniform or an attribute of the source.
struct HostName {
  std::string name, type;
  bool isAttribute;
  bool isRead;                         // true if the function reads it
  std::array<std::uint32_t, 2> shape;  // columns and rows
};

struct HeadParameter {
  std::string type, name;  // "?" if unnamed
  bool isOut;
};

// A function with a body.
struct FunctionHead {
  std::uint32_t number;
  std::string type, name;
  std::vector<HeadParameter> parameters;
};

// Each operation is its code, followed by:
//   Constant     its index in `constants`; the same for Whole, which is an int or uint
//   Argument     number, component, layout
//   Uniform      number of the name, component, layout
//                for both: an integer has two halves; 128 in the layout marks the upper one
//   Component    operand, component, layout of the operand: columns and rows, four bits each
//   Texel        number of the image's name, operand; the same for FetchedTexel
//   ImageSize    number of the image's name
//   Fold         number of iterations, or 0 to run until the first state is 1, from which on no
//                state changes; number of states, and the states' initial values. The step number
//                and the states are the next operations, followed by the body, until
//   Next         the new values of the states, whose outcomes are the next operations
//   Define       a function of the source, the next of `routines`: the number of arguments, and of
//                those with respect to which it is differentiated, which come first. Its body
//                follows, whose operations are numbered from 0, until
//   End          the number of results, and the results
//   Parameter    number of an argument, in such a body
//   Call         number of a function, number of arguments, and the arguments; its results are the
//                next operations
//   any other    number of operands, and the operands
// An operand is the number of an earlier operation.
struct Listing {
  std::vector<std::uint32_t> words;
  std::vector<double> constants;
  std::vector<std::uint32_t> results;
  std::vector<HostName> names;
  std::vector<std::string> routines;  // names of the functions that stay functions
  // The message about the first loop that is cut off before its end, with its location; empty if
  // there is none.
  std::string cutOff;
};

// A source that a front end has read. The tree refers to `source`.
struct Parsed {
  std::unique_ptr<const Lines> source;
  Problems problems;
  Tree tree;
};

class Source {
 public:
  explicit Source(Parsed parsed) : parsed_(std::move(parsed)) {}

  // Returns the message with its location; empty if there is none.
  std::string problem() const;

  std::vector<FunctionHead> functions() const;

  // Returns an empty listing and adds a problem if the function can't be lowered. `maxIterations`
  // is a number or a value in loops.hpp.
  Listing lower(int function, int maxIterations);

 private:
  Parsed parsed_;
};

Listing list(const Lowered& lowered, const Types& types);

}  // namespace warpjet::source
