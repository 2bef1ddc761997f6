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

// The number of operands that an operation takes, or two if it takes any number.
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

int operationNamed(std::string_view name) {
  std::size_t i = 0;
  while (i < operations.size() && operations[i].name != name) ++i;
  require(i < operations.size(), "there is such an operation", std::string(name));
  return static_cast<int>(i);
}

void requireProblem(const Builder& builder) { requireSentence(builder.problem()); }

void requireSentence(const std::string& problem) {
  require(problem.size() > 1 && problem.ends_with('.'), "a problem ends with a full stop", problem);
}

void GraphCalls::run() {
  keep(builder_.input("vec3Param", "position", vectorOf(3)));
  keep(builder_.input("param", "time", scalarShape));
  while (!reader_.isAtEnd() && builder_.graph().size() < maxNodes && values_.size() < maxValues)
    step();
  for (; !repeats_.empty(); repeats_.pop_back()) builder_.dropRepeat();
}

void GraphCalls::keep(int handle) {
  if (handle >= 0)
    values_.push_back(handle);
  else
    requireProblem(builder_);
}

// Prefers recent values.
int GraphCalls::value() {
  const std::size_t back = reader_.byte();
  const std::size_t least = back < 128 ? back / 16 : back - 120;
  return values_[values_.size() - 1 - least % values_.size()];
}

int GraphCalls::valueLike(int handle) {
  const int found = value();
  if (builder_.shape(found) == builder_.shape(handle)) return found;
  for (std::size_t i = values_.size(); i-- > 0;) {
    if (values_[i] < found && builder_.shape(values_[i]) == builder_.shape(handle))
      return values_[i];
  }
  return handle;
}

std::string GraphCalls::name() {
  const int which = reader_.byte();
  if (which < 224) return names[static_cast<std::size_t>(which) % names.size()];
  hasForeignText_ = true;
  return reader_.text(static_cast<std::size_t>(which - 224));
}

// Numbers that JavaScript accepts: 0, or within the range of float32 and nonzero there.
void GraphCalls::constant(double value) {
  const bool isHeld = std::abs(value) <= largest && (value == 0 || static_cast<float>(value) != 0);
  if (isHeld) keep(builder_.constant(value));
}

void GraphCalls::step() {
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
      keep(builder_.input("param", name(), shape));
      break;
    }
    case Step::Call:
      call(false);
      break;
    case Step::SameShape:
      call(true);
      break;
    case Step::Swizzle: {
      const int of = value(), count = 1 + reader_.below(4);
      keep(builder_.swizzle(of, count, reader_.byte()));
      break;
    }
    case Step::Derivative:
      derivative();
      break;
    case Step::Function: {
      const std::string of = name();
      const int arity = 1 + reader_.below(4);
      const int function =
          builder_.addFunction(of, {{"glsl", "float " + of + "(float a) { return a; }"}}, arity);
      if (function < 0) requireProblem(builder_);
      if (function >= 0) arities_[function] = arity;
      break;
    }
    case Step::CallFunction:
      callFunction();
      break;
    case Step::Noise:
      noise();
      break;
    case Step::Comment:
      builder_.comment(name());
      break;
    case Step::Output:
      output();
      break;
    case Step::Build: {
      if (!builder_.finish()) {
        requireProblem(builder_);
        break;
      }
      const ShaderTextResult made =
          write(builder_.module(), glsl300, {.emit = {1 + reader_.byte()}});
      if (!made.text) requireSentence(made.problem);
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

// The last number of steps exceeds the limit.
void GraphCalls::openRepeat() {
  constexpr std::array counts{0, 1, 2, 3, 7, 10'001};
  const int steps = counts[static_cast<std::size_t>(reader_.below(counts.size()))];
  const int count = 1 + reader_.below(3);
  for (int i = 0; i < count; ++i) builder_.push(value());
  const int step = builder_.openRepeat(steps);
  for (int i = 0; i <= count; ++i) keep(step == Builder::failed ? step : step + i);
  if (step != Builder::failed) repeats_.push_back({step + 1, count});
}

void GraphCalls::closeRepeat() {
  if (repeats_.empty()) return;
  const auto [first, count] = repeats_.back();
  repeats_.pop_back();
  // Whatever a sketch returns from the body; usually states of the right shapes.
  const bool isOdd = reader_.byte() > 240;
  for (int i = 0; i < count; ++i) builder_.push(isOdd ? value() : valueLike(first + i));
  const int outcome = builder_.closeRepeat();
  for (int i = 0; i < count; ++i) keep(outcome == Builder::failed ? outcome : outcome + i);
}

// Called like in JavaScript: on any value, with an integer seed, and with numbers.
void GraphCalls::noise() {
  const auto kind = NoiseKind(reader_.below(noises.size())), base = NoiseKind(reader_.below(3));
  const Noise noise{kind, base, 1 + reader_.below(3)};
  std::vector<int> operands{value(), builder_.constant(reader_.byte())};
  if (isFractal(kind)) {
    operands.push_back(valueLike(operands[1]));
    operands.push_back(builder_.constant(0.5));
  }
  for (const int operand : operands) builder_.push(operand);
  keep(builder_.callNoise(noise, true));
}

void GraphCalls::call(bool isSameShape) {
  const int operation = reader_.below(operations.size());
  const Operation& called = operations[static_cast<std::size_t>(operation)];
  const int style = reader_.byte();
  const std::size_t count = style < 224 ? arityOf(called) : static_cast<std::size_t>(style & 7);
  const bool isMethod = (style & 1) != 0 && count > 0 && !called.isConstructor();
  std::vector<int> operands;
  for (std::size_t i = 0; i < count; ++i)
    operands.push_back(isSameShape && i > 0 ? valueLike(operands[0]) : value());
  callOperation(operation, operands, isMethod);
}

void GraphCalls::callOperation(int operation, const std::vector<int>& operands, bool isMethod) {
  // Repeated like JavaScript does, but with fewer attempts.
  for (int attempt = 0; attempt < 4; ++attempt) {
    for (const int operand : operands) builder_.push(operand);
    const int result = builder_.call(operation, isMethod);
    if (result != Builder::needsPartials) return keep(result);
    givePartials();
  }
}

void GraphCalls::givePartials() {
  const std::vector<NodeId> pending = builder_.pendingCalls();
  require(!pending.empty(), "there are calls without partials");
  for (const NodeId call : pending) {
    const int function = builder_.functionOfCall(call);
    require(arities_.contains(function), "it calls a function that there is");
    std::vector<int> partials;
    for (int i = 0; i < arities_[function]; ++i) {
      const int argument = builder_.argumentOfCall(call, i);
      partials.push_back(reader_.byte() & 1 ? argument : value());
    }
    for (const int partial : partials) builder_.push(partial);
    if (!builder_.setPartials(call)) requireProblem(builder_);
  }
}

void GraphCalls::derivative() {
  static const std::array byPosition{operationNamed("jacobian"),
                                     operationNamed("gradient"),
                                     operationNamed("adjustNormal"),
                                     operationNamed("derivative"),
                                     -1,
                                     operationNamed("adjustTangent")};
  const std::size_t which = static_cast<std::size_t>(reader_.below(byPosition.size()));
  const int of = value(), position = values_[0];
  if (which == 4)
    warp(of);
  else if (which == 2)
    callOperation(byPosition[which], {of, value(), position}, false);
  else if (which == 5)
    callOperation(byPosition[which], {of, value(), value(), position}, false);
  else if (which == 3)
    callOperation(byPosition[which], {of, values_[1]}, false);
  else
    callOperation(byPosition[which], {of, position}, false);
}

// A whole warp; JavaScript only accepts a vec3 as offset.
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
  for (int i = 0; i < count; ++i) builder_.push(value());
  keep(builder_.callFunction(function));
}

void GraphCalls::output() {
  const std::string as =
      reader_.byte() & 1 ? "out" + std::to_string(builder_.module().outputs.size()) : name();
  builder_.output("output", as, value());
}

}  // namespace warpjet
