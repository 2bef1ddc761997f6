#include "fuzz/graph_calls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "fuzz/require.hpp"
#include "noise/table.hpp"
#include "warp/warp.hpp"

namespace warpjet {

namespace {

// Repeated differentiation makes expressions grow without limit.
constexpr std::size_t maxNodes = 4000, maxValues = 1000;

constexpr double largest = std::numeric_limits<float>::max();
constexpr double tiny = std::numeric_limits<float>::denorm_min();

constexpr std::array constants{0.0,
                               -0.0,
                               1.0,
                               -1.0,
                               2.0,
                               0.5,
                               3.0,
                               1e-7,
                               0.1,
                               1e10,
                               1e38,
                               largest,
                               -largest,
                               tiny,
                               -tiny,
                               1e-38,
                               16777217.0,
                               255.0,
                               3.14159265358979,
                               1.5707963267948966,
                               2147483648.0,
                               1e-30,
                               -0.7,
                               1024.0};

constexpr std::array names{"x",      "y",           "position", "position.x", "position[0]",
                           "normal", "t0",          "t1",       "uv",         "sin",
                           "float",  "gl_Position", "a.b.c",    "noise",      "bump",
                           "main",   "(a + b)",     "f32",      "m * v",      "vec3",
                           "offset", "position.xz", "result",   "__x",        "texture2D(s, uv).r",
                           ""};

constexpr std::array shapes{scalarShape,    vectorOf(2),    vectorOf(3),   vectorOf(4),
                            matrixOf(2, 2), matrixOf(3, 3), matrixOf(4, 4)};

// Returns the number of operands that an operation takes, or two if it takes any number.
std::size_t arityOf(const Operation& operation) {
  using Source = Operation::Source;
  switch (operation.source) {
    case Source::Row:
      return static_cast<std::size_t>(ops::declarations[operation.index].arity);
    case Source::Composition:
      return forms[operation.index].operands.size();
    case Source::Part:
      return 2;
    default:
      return operation.index;
  }
}

}  // namespace

int findOperation(std::string_view name) {
  std::size_t i = 0;
  while (i < operations.size() && operations[i].name != name) ++i;
  require(i < operations.size(), "there is such an operation", std::string(name));
  return static_cast<int>(i);
}

void requireProblem(const Builder& builder) { requireMessage(builder.problem()); }

void requireMessage(const std::string& problem) {
  require(problem.size() > 1 && problem.ends_with('.'), "a problem ends with a full stop", problem);
}

void GraphCalls::run() {
  record(builder_.input("vec3Param", "position", vectorOf(3)));
  record(builder_.input("param", "time", scalarShape));
  while (!reader_.isAtEnd() && builder_.graph().size() < maxNodes && values_.size() < maxValues)
    runStep();
  for (; !repeats_.empty(); repeats_.pop_back()) builder_.dropRepeat();
}

void GraphCalls::record(int handle) {
  if (handle >= 0)
    values_.push_back(handle);
  else
    requireProblem(builder_);
}

// Returns a recorded value; recent ones are more likely.
int GraphCalls::pickValue() {
  const std::size_t back = reader_.byte();
  const std::size_t distance = back < 128 ? back / 16 : back - 120;
  return values_[values_.size() - 1 - distance % values_.size()];
}

// Returns a recorded value with the shape of `handle`; `handle` itself if it finds no other.
int GraphCalls::pickValueLike(int handle) {
  const int picked = pickValue();
  if (builder_.shape(picked) == builder_.shape(handle)) return picked;
  for (std::size_t i = values_.size(); i-- > 0;) {
    if (values_[i] < picked && builder_.shape(values_[i]) == builder_.shape(handle))
      return values_[i];
  }
  return handle;
}

std::string GraphCalls::pickName() {
  const int which = reader_.byte();
  if (which < 224) return names[static_cast<std::size_t>(which) % names.size()];
  hasForeignText_ = true;
  return reader_.text(static_cast<std::size_t>(which - 224));
}

// Adds a number that JavaScript accepts: 0, or within the range of float32 and nonzero there.
void GraphCalls::constant(double value) {
  const bool isAccepted =
      std::abs(value) <= largest && (value == 0 || static_cast<float>(value) != 0);
  if (isAccepted) record(builder_.constant(value));
}

void GraphCalls::runStep() {
  switch (static_cast<Step>(reader_.below(static_cast<std::size_t>(Step::count)))) {
    case Step::Constant:
      constant(constants[static_cast<std::size_t>(reader_.byte()) % constants.size()]);
      break;
    case Step::OddConstant:
      if (reader_.byte() & 1)
        constant(reader_.number<double>());
      else
        constant(static_cast<double>(reader_.number<float>()));
      break;
    case Step::Input: {
      const Shape shape = shapes[static_cast<std::size_t>(reader_.below(shapes.size()))];
      record(builder_.input("param", pickName(), shape));
      break;
    }
    case Step::Call:
      call(false);
      break;
    case Step::SameShape:
      call(true);
      break;
    case Step::Swizzle: {
      const int vector = pickValue(), count = 1 + reader_.below(4);
      record(builder_.swizzle(vector, count, reader_.byte()));
      break;
    }
    case Step::Derivative:
      callDerivative();
      break;
    case Step::Function: {
      const std::string functionName = pickName();
      const int arity = 1 + reader_.below(4);
      const int function = builder_.addFunction(
          functionName, {{"glsl", "float " + functionName + "(float a) { return a; }"}}, arity);
      if (function < 0) requireProblem(builder_);
      if (function >= 0) arities_[function] = arity;
      break;
    }
    case Step::CallFunction:
      callFunction();
      break;
    case Step::Noise:
      callNoise();
      break;
    case Step::Comment:
      builder_.comment(pickName());
      break;
    case Step::Output:
      callOutput();
      break;
    case Step::Build: {
      if (!builder_.finish()) {
        requireProblem(builder_);
        break;
      }
      const ShaderTextResult result =
          write(builder_.module(), glsl300, {.emit = {1 + reader_.byte()}});
      if (!result.text) requireMessage(result.problem);
      break;
    }
    case Step::Position:
      values_.push_back(values_[0]);
      break;
    case Step::OpenRepeat:
      openRepeat();
      break;
    case Step::CloseRepeat:
      closeRepeat();
      break;
    case Step::count:
      break;
  }
}

void GraphCalls::openRepeat() {
  // The last number exceeds the limit.
  constexpr std::array counts{0, 1, 2, 3, 7, 10'001};
  const int steps = counts[static_cast<std::size_t>(reader_.below(counts.size()))];
  const int count = 1 + reader_.below(3);
  for (int i = 0; i < count; ++i) builder_.push(pickValue());
  const int step = builder_.openRepeat(steps);
  for (int i = 0; i <= count; ++i) record(step == Builder::failed ? step : step + i);
  if (step != Builder::failed) repeats_.push_back({step + 1, count});
}

void GraphCalls::closeRepeat() {
  if (repeats_.empty()) return;
  const auto [first, count] = repeats_.back();
  repeats_.pop_back();
  // A sketch may return anything from the body. We pass values of any shape if the next byte is
  // above 240, and otherwise states of the right shapes.
  const bool isOdd = reader_.byte() > 240;
  for (int i = 0; i < count; ++i) builder_.push(isOdd ? pickValue() : pickValueLike(first + i));
  const int outcome = builder_.closeRepeat();
  for (int i = 0; i < count; ++i) record(outcome == Builder::failed ? outcome : outcome + i);
}

// Calls noise like JavaScript does: on any value, with an integer seed, and with numbers as
// options.
void GraphCalls::callNoise() {
  const auto kind = NoiseKind(reader_.below(noises.size())), base = NoiseKind(reader_.below(3));
  const Noise noise{kind, base, 1 + reader_.below(3)};
  std::vector<int> operands{pickValue(), builder_.constant(reader_.byte())};
  if (isFractal(kind)) {
    operands.push_back(pickValueLike(operands[1]));
    operands.push_back(builder_.constant(0.5));
  }
  for (const int operand : operands) builder_.push(operand);
  record(builder_.callNoise(noise, true));
}

void GraphCalls::call(bool isSameShape) {
  const int operation = reader_.below(operations.size());
  const Operation& called = operations[static_cast<std::size_t>(operation)];
  const int style = reader_.byte();
  const std::size_t count = style < 224 ? arityOf(called) : static_cast<std::size_t>(style & 7);
  const bool isMethod = (style & 1) != 0 && count > 0 && !called.isConstructor();
  std::vector<int> operands;
  for (std::size_t i = 0; i < count; ++i)
    operands.push_back(isSameShape && i > 0 ? pickValueLike(operands[0]) : pickValue());
  callOperation(operation, operands, isMethod);
}

void GraphCalls::callOperation(int operation, const std::vector<int>& operands, bool isMethod) {
  // Repeats the call like JavaScript does, but with fewer attempts.
  for (int attempt = 0; attempt < 4; ++attempt) {
    for (const int operand : operands) builder_.push(operand);
    const int result = builder_.call(operation, isMethod);
    if (result != Builder::needsPartials) return record(result);
    givePartials();
  }
}

void GraphCalls::givePartials() {
  const std::vector<NodeId> pending = builder_.pendingCalls();
  require(!pending.empty(), "there are calls without partials");
  for (const NodeId call : pending) {
    const int function = builder_.functionOfCall(call);
    require(arities_.contains(function), "a call calls an existing function");
    std::vector<int> partials;
    for (int i = 0; i < arities_[function]; ++i) {
      const int argument = builder_.argumentOfCall(call, i);
      partials.push_back(reader_.byte() & 1 ? argument : pickValue());
    }
    for (const int partial : partials) builder_.push(partial);
    if (!builder_.setPartials(call)) requireProblem(builder_);
  }
}

void GraphCalls::callDerivative() {
  static const std::array byPosition{findOperation("jacobian"),
                                     findOperation("gradient"),
                                     findOperation("adjustNormal"),
                                     findOperation("derivative"),
                                     -1,
                                     findOperation("adjustTangent")};
  const std::size_t which = static_cast<std::size_t>(reader_.below(byPosition.size()));
  const int operand = pickValue(), position = values_[0];
  if (which == 4)
    warp(operand);
  else if (which == 2)
    callOperation(byPosition[which], {operand, pickValue(), position}, false);
  else if (which == 5)
    callOperation(byPosition[which], {operand, pickValue(), pickValue(), position}, false);
  else if (which == 3)
    callOperation(byPosition[which], {operand, values_[1]}, false);
  else
    callOperation(byPosition[which], {operand, position}, false);
}

// Builds a whole warp from an offset, for which JavaScript only accepts a vec3.
void GraphCalls::warp(int offset) {
  if (builder_.shape(offset) != vectorOf(3)) return;
  const auto input = [&](const char* name, int size) {
    return builder_.input("compileWarp", name, vectorOf(size));
  };
  std::vector<int> inputs{input("normal", 3), input("uv", 2), input("tangent", 4)};
  for (const char* name : {"nx", "ny", "nz", "u", "v"}) inputs.push_back(input(name, 3));
  inputs.push_back(input("color", 4));
  if (std::find(inputs.begin(), inputs.end(), Builder::failed) != inputs.end())
    return requireProblem(builder_);
  const WarpOptions options{(reader_.byte() & 3) != 0, (reader_.byte() & 1) != 0};
  for (int attempt = 0; attempt < 4; ++attempt) {
    for (const int operand : {offset, values_[0]}) builder_.push(operand);
    for (const int operand : inputs) builder_.push(operand);
    const int result = builder_.warp("compileWarp", options);
    if (result == Builder::failed) return requireProblem(builder_);
    if (result != Builder::needsPartials) return;
    givePartials();
  }
}

void GraphCalls::callFunction() {
  if (arities_.empty()) return;
  const auto [function, arity] = *std::next(arities_.begin(), reader_.below(arities_.size()));
  const int count = reader_.byte() < 240 ? arity : 2;
  for (int i = 0; i < count; ++i) builder_.push(pickValue());
  record(builder_.callFunction(function));
}

void GraphCalls::callOutput() {
  const std::string outputName =
      reader_.byte() & 1 ? "out" + std::to_string(builder_.module().outputs.size()) : pickName();
  builder_.output("output", outputName, pickValue());
}

}  // namespace warpjet
