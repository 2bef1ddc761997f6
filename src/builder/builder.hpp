// What a sketch builds its function with: operations by number on values by handle. Whatever is
// wrong becomes one sentence that says what to change; nothing throws and nothing is lost.
#pragma once

#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "algebra/value.hpp"
#include "builder/operations.hpp"
#include "builder/values.hpp"
#include "diff/differentiator.hpp"
#include "emit/dialect.hpp"
#include "emit/emit.hpp"
#include "eval/program.hpp"
#include "functions/library.hpp"

namespace warpjet {

struct Noise;
struct Sampling;

// What a finished builder gives: `code` for the inside of a function, `declarations` for above it.
struct Built {
  Emitted emitted;
  std::string declarations;
};

class Builder {
 public:
  // In the place of a handle. After `failed`, `problem()` says why; after `needsPartials`, the
  // derivatives of `pendingCalls` are to be given, and then the same call again.
  static constexpr int failed = -1, needsPartials = -2;

  explicit Builder(const Dialect& dialect) : dialect_(dialect) {}
  Builder(const Builder&) = delete;
  Builder& operator=(const Builder&) = delete;

  const std::string& problem() const { return problem_; }
  const Graph& graph() const { return graph_; }
  Shape shape(int handle) const { return values_.shape(handle); }

  // `value` must be zero or a float32 other than that.
  int constant(double value);

  // A variable of the host, by the expression that reads it there; `method` asks for it.
  int input(std::string_view method, std::string_view label, Shape shape);

  // Calls an operation, or a function of the host, on the values pushed since the last call. A
  // method's first operand is what it is called on.
  void push(int handle) { operands_.push_back(values_.get(graph_, handle)); }
  int call(int operation, bool isMethod);
  int callFunction(int function);
  int callNoise(const Noise& noise, bool isMethod);
  // The operands are a vec2, an image, and its width and height in texels, a vec2.
  int callTexture(const Sampling& sampling);

  // Some components of a vector, two bits each, the first one lowest. A problem is told without the
  // method, which goes by three alphabets.
  int swizzle(int handle, int count, unsigned indices);

  // A function of the host from `arity` floats to a float, with the text that defines it there.
  int addFunction(std::string_view name, std::string_view source, int arity);
  const std::vector<NodeId>& pendingCalls() const { return pendingCalls_; }
  int functionOfCall(NodeId call) const;
  int argumentOfCall(NodeId call, int i);
  // The values pushed are the partial derivatives of that call. Whether they can be.
  bool setPartials(NodeId call);

  // Puts a comment above the statements of all nodes made since the last one.
  void comment(std::string_view text);

  // Asks for a result under a name. As a sum of an input and the earlier output number `term`,
  // where it is one, its text is shorter. Whether that went well.
  bool output(std::string_view method, std::string_view name, int handle);
  bool outputSum(std::string_view method, std::string_view name, int handle, int input, int term);

  // The text of all outputs, or nothing and a problem. With a `maxDepth`, depth makes a temporary
  // of a node that is used once, and what it reads only far above what a person writes.
  std::optional<Built> build(std::optional<int> maxDepth = {});

  // Whether a value is computed from an input.
  bool dependsOn(int handle, int input);

  const std::vector<Output>& outputs() const { return outputs_; }
  // The values pushed, for the CPU; nothing if a function or an image of the host is needed for
  // them.
  std::optional<Program> program();

 private:
  using Operands = std::span<const Value>;

  // The call that is being made, for sentences.
  struct Site {
    std::string_view method;
    bool isMethod;

    std::string place(std::size_t operand) const;
  };

  std::optional<Value> apply(const Operation& operation, const Site& site);
  std::optional<Value> applyRow(Op op, const Site& site);
  std::optional<Value> applyRowTo(Op op, Operands operands, const Site& site);
  std::optional<Value> applyMatrixProduct(const Value& a, const Value& b, const Site& site);
  std::optional<Value> compose(const Form& form, const Site& site);
  std::optional<Value> makeVector(int size, const Site& site);
  std::optional<Value> makeMatrix(int size, bool ofRows, const Site& site);
  std::optional<Value> takePart(bool isRow, const Site& site);
  std::optional<std::vector<Expression>> components(const Site& site);
  Value resize(const Value& matrix, int size);
  Value wholeInput(std::uint32_t input);
  std::optional<Value> partOfInput(std::uint32_t input, std::string_view label, Shape shape);

  bool checkCount(int wanted, const Site& site);
  bool fits(Kind kind, const Value& operand, std::size_t place, const Site& site);
  bool fitsInput(const Value& operand, std::size_t place, const Site& site);
  std::optional<Shape> commonShape(Operands operands, const Site& site);
  bool hasAllPartials(const Value& value);
  bool isFull() const { return graph_.full() || library_.isFull(); }
  bool hidesWhatIsRead(const Emitted& emitted, std::string_view helpers);
  std::vector<NodeId> roots() const;
  std::vector<Output> lowered(Comments& comments);

  // The handle of a value, unless nodes made since `before` are not what a shader can hold.
  int finish(std::optional<Value> value, std::size_t before, std::string_view method);
  const std::string_view* impossible(NodeId id) const;
  const std::string_view* findImpossible(const Value& value, std::size_t before);

  // The parts of a sentence, after the method. Sentences are made seldom and in many places.
  using Parts = std::initializer_list<std::string_view>;
  [[gnu::noinline, gnu::cold]] std::nullopt_t refuse(std::string_view method, Parts parts);
  std::nullopt_t refuseShapes(Shape a, Shape b, const Site& site);

  const Dialect& dialect_;
  Graph graph_;
  Differentiator differentiator_{graph_};
  Library library_;
  Values values_;
  std::vector<Value> operands_;
  std::vector<Output> outputs_;
  std::set<std::string, std::less<>> outputNames_;
  // By the label of a vector, the first input that is a part of it.
  std::map<std::string, std::string, std::less<>> parts_;
  std::vector<std::string> sources_;  // by function of the host
  Comments comments_;
  std::size_t commented_ = 0;
  std::vector<NodeId> pendingCalls_;
  std::vector<bool> needed_;  // kept for its memory
  bool wasImpossible_ = false;
  std::string problem_;
};

}  // namespace warpjet
