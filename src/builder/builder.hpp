// The interface that records offset functions. Operations are identified by their number, values by
// handles. Every error becomes a message that says what to change: nothing throws, and no error is
// ignored.
#pragma once

#include <array>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "algebra/value.hpp"
#include "builder/operations.hpp"
#include "builder/values.hpp"
#include "diff/differentiator.hpp"
#include "functions/fold.hpp"
#include "graph/flags.hpp"
#include "graph/folds.hpp"
#include "module/label.hpp"
#include "module/module.hpp"

namespace warpjet {

struct Noise;
struct Sampling;
struct WarpOptions;

// The operands of `Builder::warp` after the offset, in this order.
inline constexpr std::array<std::string_view, 10> warpOperands{
    "position",        "normal",          "uv",        "tangent",   "normalXGradient",
    "normalYGradient", "normalZGradient", "uGradient", "vGradient", "color"};

// The results that `Builder::warp` adds, in this order. `orientedResults` depend on the Jacobian
// and are added twice: with a constant normal and uv, and with normal and uv that vary over the
// surface.
inline constexpr std::array<std::string_view, 2> movedResults{"offset", "position"};
inline constexpr std::string_view orientationResult = "orientation";
inline constexpr std::array<std::string_view, 4> orientedResults{"normal", "tangent", "direction",
                                                                 "determinant"};

class Builder {
 public:
  // Returned in place of a handle. After `failed`, `problem()` has the message. After
  // `needsPartials`, pass the derivatives of `pendingCalls`, then repeat the call.
  static constexpr int failed = -1, needsPartials = -2;

  Builder() = default;
  Builder(const Builder&) = delete;
  Builder& operator=(const Builder&) = delete;

  const std::string& problem() const { return problem_; }
  const Module& module() const { return module_; }
  const Graph& graph() const { return graph_; }
  Shape shape(int handle) const { return values_.shape(handle); }

  // `value` must be zero or a nonzero float32.
  int constant(double value);

  // Reads a variable of the host, identified by the expression that reads it in the shader;
  // `method` is the method that requests it, for messages.
  int input(std::string_view method, std::string_view label, Shape shape);

  // Calls an operation, or a function of the host, on the values pushed since the last call. The
  // first operand of a method is its receiver.
  void push(int handle) { operands_.push_back(values_.get(graph_, handle)); }
  int call(int operationIndex, bool isMethod);
  int callFunction(int functionIndex);
  int callNoise(const Noise& noise, bool isMethod);
  // Samples the host's image of that name; the operand is a vec2.
  int callTexture(const Sampling& sampling, std::string_view image);
  // Returns the width and height of the host's image of that name.
  int imageSize(std::string_view image);

  // Adds a function that a front end recorded as a module; returns its number. Arguments and
  // results are single numbers. A call returns the handle of the first result; the handles of the
  // others follow.
  [[gnu::noinline]] int addRecorded(std::string_view name, std::uint32_t variables,
                                    std::span<const std::uint32_t> words);
  [[gnu::noinline]] int callRecorded(int function);

  // The `steps` of a loop that runs until its first state is more than 0.5. From then on, no step
  // may change any state.
  static constexpr int uncounted = -1;
  // Opens a loop of `steps` iterations; the values pushed are the initial states. Returns the
  // handle of the step number, followed by the handles of the states. `closeRepeat` takes the new
  // states from the values pushed and returns the handle of the first outcome; the other handles
  // follow. If recording the body fails, call `dropRepeat` instead.
  [[gnu::noinline]] int openRepeat(int steps);
  [[gnu::noinline]] int closeRepeat();
  void dropRepeat() { repeats_.pop_back(); }

  // Selects components of a vector, two bits per index, the first one lowest. Its messages don't
  // name the method, which could be spelled in three alphabets (xyzw, rgba, stpq).
  int swizzle(int handle, int count, unsigned indices);

  // Adds a host function from `arity` floats to a float, with its sources.
  int addFunction(std::string_view name, const std::vector<HostText>& sources, int arity);
  const std::vector<NodeId>& pendingCalls() const { return pendingCalls_; }
  int functionOfCall(NodeId call) const;
  int argumentOfCall(NodeId call, int i);
  // Takes the partial derivatives of the call from the values pushed. Returns false if they are
  // invalid.
  bool setPartials(NodeId call);

  // Writes a comment above the statements of all nodes made since the last comment.
  void comment(std::string_view text);

  // Adds a result with a name.
  void output(std::string_view method, std::string_view name, int handle);

  // Adds all results of a warp. The values pushed are the offset, then `warpOperands`. Returns 1 if
  // the normal depends on the gradients of normal and uv, 0 if not; or `failed` or `needsPartials`.
  int warp(std::string_view method, const WarpOptions& options);

  // Returns the number of the input that the value is, or is a component of.
  std::uint32_t inputOf(int handle);

  // Returns true if the module can be written and run; otherwise sets the problem.
  bool finish();

 private:
  // The call being made, for messages.
  struct Site {
    std::string_view method;
    bool isMethod;

    std::string describeOperand(std::size_t operand) const;
  };

  // A loop whose body is being recorded.
  struct Repeat {
    OpenFold fold;
    std::vector<Shape> shapes;
  };

  std::optional<Value> apply(const Operation& operation, const Site& site);
  std::optional<Value> applyRow(Op op, const Site& site);
  std::optional<Value> applyRowTo(Op op, std::span<const Value> operands, const Site& site);
  std::optional<Value> applyMatrixProduct(const Value& a, const Value& b, const Site& site);
  std::optional<Value> compose(const Form& form, const Site& site);
  std::optional<Value> makeVector(int size, const Site& site);
  std::optional<Value> makeMatrix(int size, bool ofRows, const Site& site);
  std::optional<Value> takePart(bool isRow, const Site& site);
  std::optional<std::vector<Expression>> components(const Site& site);
  Value resize(const Value& matrix, int size);
  Value allComponents(std::uint32_t input);
  Value sizeOf(std::uint32_t image);
  void nameInput(std::uint32_t number, const Label& label, std::string_view method);
  std::optional<std::optional<Value>> findKnownInput(std::string_view method, const Label& label,
                                                     Shape shape);

  bool checkCount(int wanted, const Site& site);
  bool fits(Kind kind, const Value& operand, std::size_t place, const Site& site);
  bool fitsInput(const Value& operand, std::size_t place, const Site& site);
  std::optional<Shape> commonShape(std::span<const Value> operands, const Site& site);
  bool hasAllPartials(const Value& value);
  [[gnu::noinline]] bool dependsOnLoopOf(NodeId call, std::span<const NodeId> nodes) const;
  int addAll(std::span<const Shape> shapes, std::span<const NodeId> nodes);
  // Returns true if a node reads a variable of a loop outside of its fold. With `mayReadStep`, the
  // step number is ignored.
  bool readsOpenRepeat(std::span<const NodeId> nodes, bool mayReadStep);
  bool checkReadsNoRepeat(const Value& value, std::string_view method);

  // Returns the handle of a value; `failed` if a node made since `before`, which is a size of the
  // graph, can't be computed in a shader.
  int addResult(std::optional<Value> value, std::size_t before, std::string_view method);
  // Sets the problem and returns false if a result can't be computed.
  bool checkPossible(std::span<const NodeId> results, std::size_t before, std::string_view method);
  const std::string_view* explainImpossible(NodeId id) const;
  const std::string_view* findImpossible(std::span<const NodeId> results, std::size_t before);
  void addOutput(std::string_view method, std::string_view name, const Value& value);
  void commentDerivatives();

  // The parts of a message, after the method. Messages are rare, but made in many places.
  using Parts = std::initializer_list<std::string_view>;
  [[gnu::noinline, gnu::cold]] std::nullopt_t reject(std::string_view method, Parts parts);
  std::nullopt_t rejectShapes(Shape a, Shape b, const Site& site);

  Module module_;
  Graph& graph_ = module_.graph;
  Differentiator differentiator_{graph_};
  Values values_;
  std::vector<Value> operands_;
  std::vector<Repeat> repeats_;  // innermost last
  std::vector<Label> labels_;    // by input
  // Maps the root of a label → the numbers of the inputs with that root. There may be thousands of
  // inputs.
  std::map<std::string, std::vector<std::uint32_t>, std::less<>> numbers_;
  std::size_t commentedCount_ = 0;     // the size of the graph at the last comment
  std::vector<DerivedNodes> derived_;  // since the last comment, if there are comments
  std::vector<NodeId> pendingCalls_;
  Flags needed_;  // a member to reuse its memory
  bool wasImpossible_ = false;
  std::string problem_;
};

}  // namespace warpjet
