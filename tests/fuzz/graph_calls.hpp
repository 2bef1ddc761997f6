// Interprets bytes as the calls that a sketch makes on a builder: everything that JavaScript lets
// through, sensible or not.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "builder/builder.hpp"
#include "emit/text.hpp"
#include "fuzz/reader.hpp"

namespace warpjet {

// The kind of each call; its byte is taken modulo `count`.
enum class Step : std::uint8_t {
  Constant,
  OddConstant,
  Input,
  Call,
  SameShape,  // a call on values of one shape, so that more calls succeed
  Swizzle,
  Derivative,  // or a whole warp
  Function,
  CallFunction,
  Noise,
  Comment,
  Output,
  Build,
  Position,  // the input whose derivatives warps need
  OpenRepeat,
  CloseRepeat,
  count
};

class GraphCalls {
 public:
  GraphCalls(Builder& builder, Reader& reader) : builder_(builder), reader_(reader) {}

  // Calls the builder until the bytes end, or the graph is at the limit that keeps a run short.
  void run();

  // The handles of the results of all calls.
  const std::vector<int>& values() const { return values_; }
  // True if a name or a text was taken from the bytes, so that the shader code may contain
  // anything.
  bool hasForeignText() const { return hasForeignText_; }

 private:
  void runStep();
  void record(int handle);
  int pickValue();
  int pickValueLike(int handle);
  std::string pickName();
  void constant(double value);
  void call(bool isSameShape);
  void callOperation(int operation, const std::vector<int>& operands, bool isMethod);
  void givePartials();
  void callDerivative();
  void warp(int offset);
  void callFunction();
  void callNoise();
  void callOutput();
  void openRepeat();
  void closeRepeat();

  // A repeat whose body is being recorded: the first handle of its states, and their number.
  struct OpenRepeat {
    int first, count;
  };

  Builder& builder_;
  Reader& reader_;
  std::vector<int> values_;
  std::map<int, int> arities_;       // handle of a user function → the number of its arguments
  std::vector<OpenRepeat> repeats_;  // the innermost last
  bool hasForeignText_ = false;
};

int findOperation(std::string_view name);

// Requires a problem to be a message that ends with a full stop.
void requireProblem(const Builder& builder);
void requireMessage(const std::string& problem);

}  // namespace warpjet
