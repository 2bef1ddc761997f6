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
  SameShape,  // a call on values of one shape, so that more of them succeed
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

  // Runs until the bytes end, or the time limit of a run is likely to be reached.
  void run();

  // The results of calls, by handle.
  const std::vector<int>& values() const { return values_; }
  // True if a name or a text was taken from the bytes, so that the shader code may contain
  // anything.
  bool hasForeignText() const { return hasForeignText_; }

 private:
  void step();
  void keep(int handle);
  int value();
  int valueLike(int handle);
  std::string name();
  void constant(double value);
  void call(bool isSameShape);
  void callOperation(int operation, const std::vector<int>& operands, bool isMethod);
  void givePartials();
  void derivative();
  void warp(int offset);
  void callFunction();
  void noise();
  void output();
  void openRepeat();
  void closeRepeat();

  // The handles of the states of a repeat whose body is being recorded.
  struct OpenRepeat {
    int first, count;
  };

  Builder& builder_;
  Reader& reader_;
  std::vector<int> values_;
  std::map<int, int> arities_;       // of functions of the host, by number
  std::vector<OpenRepeat> repeats_;  // the innermost last
  bool hasForeignText_ = false;
};

int operationNamed(std::string_view name);

// Every problem must be one message.
void requireProblem(const Builder& builder);
void requireSentence(const std::string& problem);

}  // namespace warpjet
