// What a sketch builds its function with: operations by number on values by handle. Whatever is
// wrong becomes one sentence that says what to change; nothing throws and nothing is lost.
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

// What `Builder::warp` takes besides the offset, in this order.
inline constexpr std::array<std::string_view, 10> warpOperands{
    "position",        "normal",          "uv",        "tangent",   "normalXGradient",
    "normalYGradient", "normalZGradient", "uGradient", "vGradient", "color"};

// The results that it asks for, in this order. Those that turn come twice: where normal and uv
// count as constant, and where they vary over the surface.
inline constexpr std::array<std::string_view, 2> movedResults{"offset", "position"};
inline constexpr std::string_view orientationResult = "orientation";
inline constexpr std::array<std::string_view, 4> turnedResults{"normal", "tangent", "direction",
                                                               "determinant"};

class Builder {
 public:
  // In the place of a handle. After `failed`, `problem()` says why; after `needsPartials`, the
  // derivatives of `pendingCalls` are to be given, and then the same call again.
  static constexpr int failed = -1, needsPartials = -2;

  Builder() = default;
  Builder(const Builder&) = delete;
  Builder& operator=(const Builder&) = delete;

  const std::string& problem() const { return problem_; }
  const Module& module() const { return module_; }
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
  // Of the host's image of that name; the operand is a vec2.
  int callTexture(const Sampling& sampling, std::string_view image);

  // A function that a front end recorded, by its module: its number. Calls take numbers, and give
  // the handle of the first value, which the others follow.
  [[gnu::noinline]] int addRecorded(std::string_view name, std::uint32_t variables,
                                    std::span<const std::uint32_t> words);
  [[gnu::noinline]] int callRecorded(int function);

  // Begins the body of a loop of so many steps; the values pushed are what its states start as.
  // Gives the handle of the step's number, which those of the states follow. The values pushed then
  // are what each step makes of them: gives the handle of the first outcome, which the others
  // follow. A body that is given up is dropped.
  [[gnu::noinline]] int openRepeat(int steps);
  [[gnu::noinline]] int closeRepeat();
  void dropRepeat() { repeats_.pop_back(); }

  // Some components of a vector, two bits each, the first one lowest. A problem is told without the
  // method, which goes by three alphabets.
  int swizzle(int handle, int count, unsigned indices);

  // A function of the host from `arity` floats to a float, with the texts that define it there.
  int addFunction(std::string_view name, const std::vector<HostText>& sources, int arity);
  const std::vector<NodeId>& pendingCalls() const { return pendingCalls_; }
  int functionOfCall(NodeId call) const;
  int argumentOfCall(NodeId call, int i);
  // The values pushed are the partial derivatives of that call. Whether they can be.
  bool setPartials(NodeId call);

  // Puts a comment above the statements of all nodes made since the last one.
  void comment(std::string_view text);

  // Asks for a result under a name.
  void output(std::string_view method, std::string_view name, int handle);

  // Asks for all results of a warp. The values pushed are the offset, then `warpOperands`. Gives
  // 1 if it needs the gradients, 0 if not; or `failed` or `needsPartials`.
  int warp(std::string_view method, const WarpOptions& options);

  // The number of an input, by its value.
  std::uint32_t inputOf(int handle);

  // Whether the module is one that can be written and run; otherwise there is a problem.
  bool finish();

 private:
  // The call that is being made, for sentences.
  struct Site {
    std::string_view method;
    bool isMethod;

    std::string place(std::size_t operand) const;
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
  Value wholeInput(std::uint32_t input);
  void nameInput(std::uint32_t number, const Label& label, std::string_view method);
  std::optional<std::optional<Value>> knownInput(std::string_view method, const Label& label,
                                                 Shape shape);

  bool checkCount(int wanted, const Site& site);
  bool fits(Kind kind, const Value& operand, std::size_t place, const Site& site);
  bool fitsInput(const Value& operand, std::size_t place, const Site& site);
  std::optional<Shape> commonShape(std::span<const Value> operands, const Site& site);
  bool hasAllPartials(const Value& value);
  [[gnu::noinline]] bool isOfRepeatOf(NodeId call, std::span<const NodeId> nodes) const;
  int addAll(std::span<const Shape> shapes, std::span<const NodeId> nodes);
  // Whether they read a variable of a loop outside of its fold; of which the number of the step may
  // be one that does not count.
  bool isWithinRepeat(std::span<const NodeId> nodes, bool mayReadStep);
  bool checkOutside(const Value& value, std::string_view asker);

  // The handle of a value, unless nodes made since `before` are not what a shader can hold.
  int finish(std::optional<Value> value, std::size_t before, std::string_view method);
  // Refuses them in a sentence if not.
  bool checkPossible(std::span<const NodeId> results, std::size_t before, std::string_view method);
  const std::string_view* impossible(NodeId id) const;
  const std::string_view* findImpossible(std::span<const NodeId> results, std::size_t before);
  void addOutput(std::string_view method, std::string_view name, const Value& value);
  void commentDerivatives();

  // The parts of a sentence, after the method. Sentences are made seldom and in many places.
  using Parts = std::initializer_list<std::string_view>;
  [[gnu::noinline, gnu::cold]] std::nullopt_t refuse(std::string_view method, Parts parts);
  std::nullopt_t refuseShapes(Shape a, Shape b, const Site& site);

  Module module_;
  Graph& graph_ = module_.graph;
  Differentiator differentiator_{graph_};
  Values values_;
  std::vector<Value> operands_;
  std::vector<Repeat> repeats_;  // the innermost last
  std::vector<Label> labels_;    // by input
  // By the root of their labels: there may be thousands.
  std::map<std::string, std::vector<std::uint32_t>, std::less<>> numbers_;
  std::size_t commented_ = 0;
  std::vector<Derived> derived_;  // since the last comment, if there are comments
  std::vector<NodeId> pendingCalls_;
  Flags needed_;  // kept for its memory
  bool wasImpossible_ = false;
  std::string problem_;
};

}  // namespace warpjet
