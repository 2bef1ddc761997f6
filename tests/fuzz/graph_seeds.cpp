// Calls on a builder, in the format of graph_calls.cpp.
#include "fuzz/graph_calls.hpp"
#include "fuzz/seeds.hpp"
#include "noise/table.hpp"

namespace warpjet {

namespace {

std::uint8_t byte(std::size_t number) { return static_cast<std::uint8_t>(number); }

std::size_t numberOf(std::string_view operation) {
  std::size_t i = 0;
  while (operations.at(i).name != operation) ++i;
  return i;
}

// Writes the bytes of calls. An operand is written as the number of values recorded after it, at
// most 7.
class Calls {
 public:
  Calls(std::size_t dialect, std::size_t style) : bytes_{byte(dialect), byte(style)} {}

  Calls& add(Step step, const std::vector<std::size_t>& arguments = {}) {
    bytes_.push_back(byte(static_cast<std::size_t>(step)));
    for (const std::size_t number : arguments) bytes_.push_back(byte(number));
    return *this;
  }

  Calls& call(std::size_t operation, const std::vector<std::size_t>& operands) {
    std::vector<std::size_t> arguments{operation, 0};
    for (const std::size_t back : operands) arguments.push_back(16 * back);
    return add(Step::Call, arguments);
  }
  Calls& call(std::string_view name, const std::vector<std::size_t>& operands) {
    return call(numberOf(name), operands);
  }

  Calls& position() { return add(Step::Position); }
  Calls& constant(std::size_t which) { return add(Step::Constant, {which}); }
  Calls& component(std::size_t back, std::size_t i) {
    return add(Step::Swizzle, {16 * back, 0, i});
  }
  // `which` is 0 jacobian, 1 gradient, 2 adjustNormal, 3 derivative, 4 a whole warp, 5
  // adjustTangent.
  Calls& derivative(std::size_t which, const std::vector<std::size_t>& operands) {
    std::vector<std::size_t> arguments{which};
    for (const std::size_t back : operands) arguments.push_back(16 * back);
    return add(Step::Derivative, arguments);
  }
  Calls& output() { return add(Step::Output, {1, 0}); }

  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

// Adds calls of an operation, on numbers and on vectors.
void addRow(Calls& calls, std::size_t operation) {
  const auto arity = static_cast<std::size_t>(ops::declarations[operations[operation].index].arity);
  std::vector<std::size_t> operands{2, 1, 0};
  operands.resize(arity);
  calls.position().component(0, 0).component(1, 1).component(2, 2);
  calls.call(operation, operands).output();
  calls.position().call(operation, std::vector<std::size_t>(arity)).output();
}

Calls rows(std::size_t dialect, std::size_t first, std::size_t end) {
  Calls calls(dialect, dialect);
  for (std::size_t i = first; i < end; ++i) {
    if (operations[i].source == Operation::Source::Row) addRow(calls, i);
  }
  return calls;
}

Calls vectors(std::size_t dialect) {
  Calls calls(dialect, 4);
  for (const char* name : {"dot", "cross", "distance", "reflect"})
    calls.position().call("normalize", {0}).call(name, {1, 0}).output();
  calls.position().call("length", {0}).call("refract", {1, 1, 0}).output();
  calls.position().call("faceforward", {0, 0, 0}).call("smoothstep", {0, 1, 0}).output();
  return calls;
}

Calls matrices(std::size_t dialect) {
  Calls calls(dialect, 6);
  calls.position().component(0, 1).call("rotateX", {0}).call("transpose", {0}).output();
  calls.call("mult", {1, 0}).call("inverse", {0}).output().call("determinant", {1}).output();
  calls.position().call("mult", {2, 0}).output();
  calls.position().call("mat3", {0, 0, 0}).constant(2).call("column", {1, 0}).output();
  calls.position().component(0, 2).call("rotate", {1, 0}).output();
  return calls;
}

// A twist as a whole warp, and the operations that such a warp consists of.
Calls warp(std::size_t dialect) {
  Calls calls(dialect, 2);
  calls.position().component(0, 1).call("sin", {0}).call("mult", {0, 1});
  calls.position()
      .call("mult", {0, 1})
      .output()
      .derivative(4, {0})
      .add(Step::Constant, {1})
      .output();
  calls.position().call("normalize", {0}).derivative(2, {3, 0}).output();
  calls.derivative(5, {4, 1, 0}).output();
  return calls;
}

// noise(position.x, position.y) and its derivatives, which the builder requests.
Calls userFunctions(std::size_t dialect) {
  constexpr std::size_t noise = 13;
  Calls calls(dialect, 2);
  calls.add(Step::Function, {noise, 1}).position().component(0, 0).component(1, 1);
  calls.add(Step::CallFunction, {0, 0, 16, 0}).output();
  calls.add(Step::Comment, {16}).position();
  calls.add(Step::Derivative, {1, 16, 1, 1}).output().add(Step::Build, {7});
  return calls;
}

// Each kind of noise of the position, and its derivatives.
Calls everyNoise(std::size_t dialect) {
  Calls calls(dialect, 2);
  for (std::size_t kind = 0; kind < noises.size(); ++kind) {
    calls.position().add(Step::Noise, {kind, kind % 3, 1, 0, kind, 0}).output();
    calls.derivative(1, {0, 16}).output();
  }
  return calls.add(Step::Build, {7});
}

// A repeat of three steps s = sin(s * s), within it a repeat that doubles a number, and derivatives
// of the results.
Calls repeats(std::size_t dialect) {
  Calls calls(dialect, 2);
  calls.position().component(0, 0).add(Step::OpenRepeat, {3, 1, 16, 0});
  calls.call("mult", {0, 0}).add(Step::OpenRepeat, {2, 0, 0}).call("add", {0, 0});
  calls.add(Step::CloseRepeat, {0, 0}).call("sin", {0}).add(Step::CloseRepeat, {0, 0, 16});
  calls.output().position().call("mult", {0, 1}).output().derivative(0, {0}).output();
  calls.position().add(Step::OpenRepeat, {4, 0, 0}).call("sin", {0}).add(Step::CloseRepeat, {0, 0});
  return calls.derivative(4, {0}).add(Step::Constant, {1}).output();
}

Calls oddities(std::size_t dialect) {
  Calls calls(dialect, 1);
  for (std::size_t i = 0; i < 24; ++i) calls.constant(i).call("mult", {0, 1}).output();
  for (std::size_t i = 0; i < 26; ++i) calls.add(Step::Input, {i % 7, i}).output();
  for (std::size_t i = 0; i < 26; ++i) calls.add(Step::Output, {0, i, 0});
  return calls;
}

}  // namespace

void writeGraphSeeds() {
  const char* const dialects[] = {"glsl300", "glsl100", "wgsl"};
  for (std::size_t dialect = 0; dialect < 3; ++dialect) {
    const auto write = [&](const std::string& name, const Calls& calls) {
      writeSeed("graph", name + '-' + dialects[dialect], calls.bytes());
    };
    constexpr std::size_t part = 12;
    for (std::size_t first = 0; first < ops::count; first += part)
      write("rows" + std::to_string(first / part), rows(dialect, first, first + part));
    write("vectors", vectors(dialect));
    write("matrices", matrices(dialect));
    write("warp", warp(dialect));
    write("functions", userFunctions(dialect));
    write("noises", everyNoise(dialect));
    write("repeats", repeats(dialect));
    write("oddities", oddities(dialect));
  }
}

}  // namespace warpjet
