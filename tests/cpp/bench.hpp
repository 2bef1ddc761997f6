// A builder with some inputs, and short names for the calls that JavaScript makes.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "builder/builder.hpp"
#include "emit/text.hpp"

namespace warpjet {

struct Bench {
  explicit Bench(const Dialect& dialect = glsl300) : dialect_(dialect) {}

  int number(double value) { return builder.constant(value); }
  int input(std::string_view label, Shape shape = scalarShape) {
    return builder.input("glsl", label, shape);
  }

  static int operationNamed(std::string_view name) {
    std::size_t i = 0;
    while (i < operations.size() && operations[i].name != name) ++i;
    EXPECT_LT(i, operations.size()) << name;
    return static_cast<int>(i);
  }
  int call(std::string_view name, const std::vector<int>& operands, bool isMethod = false) {
    for (const int operand : operands) builder.push(operand);
    return builder.call(operationNamed(name), isMethod);
  }
  int method(std::string_view name, const std::vector<int>& operands) {
    return call(name, operands, true);
  }
  int callFunction(int function, const std::vector<int>& operands) {
    for (const int operand : operands) builder.push(operand);
    return builder.callFunction(function);
  }
  bool givePartials(NodeId call, const std::vector<int>& partials) {
    for (const int partial : partials) builder.push(partial);
    return builder.setPartials(call);
  }

  // Returns the code of this value if it is the only result.
  std::string text(int value) {
    const std::string name = "result" + std::to_string(++texts_);
    if (value < 0) return builder.problem();
    builder.output("gen", name, value);
    const std::vector onlyResult{builder.module().outputs.back()};
    const std::string code = emit(builder.graph(), dialect_, onlyResult).code;
    const std::size_t start = code.find(name + " = ") + name.size() + 3;
    return code.substr(start, code.find(";\n", start) - start);
  }

  // Writes all results, with temporaries chosen only by the depth of expressions.
  ShaderTextResult writeResults() const {
    return write(builder.module(), dialect_, {.emit = {8, EmitOptions::maxTrackedReads}});
  }
  std::string code() const {
    const ShaderTextResult written = writeResults();
    return written.text ? written.text->emitted.code : written.problem;
  }
  // Returns the message if there is no shader code.
  std::string problemOfText() const { return writeResults().problem; }

  int hostFunction(std::string_view name, std::string_view source, int arity) {
    return builder.addFunction(name, {{"glsl", std::string(source)}}, arity);
  }

  Builder builder;
  int x = input("x"), v2 = input("v2", vectorOf(2)), v3 = input("v3", vectorOf(3)),
      v4 = input("v4", vectorOf(4)), m2 = input("m2", matrixOf(2, 2)),
      m3 = input("m3", matrixOf(3, 3)), m23 = input("m23", matrixOf(2, 3));

 private:
  const Dialect& dialect_;
  int texts_ = 0;
};

}  // namespace warpjet
