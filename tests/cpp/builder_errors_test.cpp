// Errors of the builder about operations and constants: their messages, and that the builder
// continues to work afterwards.
#include "builder_errors.hpp"

#include <gtest/gtest.h>

namespace warpjet {
namespace {

TEST_F(BuilderErrors, RejectsWrongArgumentCounts) {
  expectRejected(call("sin", {}), "sin: expected 1 argument, got 0.");
  expectRejected(method("sin", {x, x}), "sin: expected no arguments, got 1.");
  expectRejected(call("mix", {x, x}), "mix: expected 3 arguments, got 2.");
  expectRejected(method("mix", {x, x}), "mix: expected 2 arguments, got 1.");
  expectRejected(call("add", {}), "add: expected 2 arguments, got 0.");
  expectRejected(method("add", {x}), "add: expected 1 argument, got 0.");
  expectRejected(call("atan", {x, x, x}), "atan: expected 1 argument, got 3.");
  expectRejected(call("dot", {v3}), "dot: expected 2 arguments, got 1.");
  expectRejected(method("column", {m2}), "column: expected 1 argument, got 0.");
  expectRejected(method("derivative", {x}), "derivative: expected 1 argument, got 0.");
  expectRejected(call("derivative", {}), "derivative: expected 2 arguments, got 0.");
}

TEST_F(BuilderErrors, RejectsIncompatibleShapes) {
  expectRejected(
      call("add", {v2, v3}),
      "add: a vec2 and a vec3 do not fit together; use vectors of the same size, or numbers.");
  expectRejected(
      call("clamp", {v2, x, v3}),
      "clamp: a vec2 and a vec3 do not fit together; use vectors of the same size, or numbers.");
  expectRejected(
      call("dot", {v4, v3}),
      "dot: a vec4 and a vec3 do not fit together; use vectors of the same size, or numbers.");
  expectRejected(call("smoothstep", {x, v2, v3}),
                 "smoothstep: a vec2 and a vec3 do not fit together; use vectors of the same size, "
                 "or numbers.");
  expectRejected(
      call("add", {m2, m3}),
      "add: a mat2 and a mat3 do not fit together; use matrices and vectors of the same size.");
  expectRejected(
      call("add", {m2, v2}),
      "add: a mat2 and a vec2 do not fit together; use matrices and vectors of the same size.");
  expectRejected(
      call("mult", {m2, v3}),
      "mult: a mat2 and a vec3 do not fit together; use matrices and vectors of the same size.");
  expectRejected(
      call("mult", {v2, m23}),
      "mult: a vec2 and a matrix of 2 columns and 3 rows do not fit together; use matrices and "
      "vectors of the same size.");
  expectRejected(
      call("mult", {m2, x, m3}),
      "mult: a mat2 and a mat3 do not fit together; use matrices and vectors of the same size.");
}

TEST_F(BuilderErrors, RejectsMatricesInScalarAndVectorOperations) {
  expectRejected(call("sin", {m2}),
                 "sin: it does not work on matrices; use their columns, such as m.column(0).");
  expectRejected(call("max", {x, m2}),
                 "max: it does not work on matrices; use their columns, such as m.column(0).");
  expectRejected(call("div", {x, m2}), "div: a matrix cannot divide; multiply by its inverse().");
  expectRejected(method("div", {m2, m2}),
                 "div: a matrix cannot divide; multiply by its inverse().");
}

TEST_F(BuilderErrors, RejectsOperandsOfTheWrongKind) {
  expectRejected(call("length", {x}),
                 "length: expected a vector as argument 1, got a single number.");
  expectRejected(method("length", {m2}),
                 "length: expected a vector as the value it is called on, got a mat2.");
  expectRejected(method("cross", {v3, v2}), "cross: expected a vec3 as argument 1, got a vec2.");
  expectRejected(call("cross", {v3, v2}), "cross: expected a vec3 as argument 2, got a vec2.");
  expectRejected(call("refract", {v3, v3, v3}),
                 "refract: expected a single number as argument 3, got a vec3.");
  expectRejected(call("radians", {m3}),
                 "radians: expected a number or a vector as argument 1, got a mat3.");
  expectRejected(method("transpose", {v2}),
                 "transpose: expected a matrix as the value it is called on, got a vec2.");
  expectRejected(
      method("inverse", {m23}),
      "inverse: expected a square matrix as the value it is called on, got a matrix of 2 columns "
      "and 3 rows.");
  expectRejected(call("determinant", {v4}),
                 "determinant: expected a square matrix as argument 1, got a vec4.");
  expectRejected(call("rotate", {v2, x}), "rotate: expected a vec3 as argument 1, got a vec2.");
  expectRejected(call("gradient", {v2, v2}),
                 "gradient: expected a single number as argument 1, got a vec2.");
  expectRejected(call("jacobian", {x, v2}),
                 "jacobian: expected a vector as argument 1, got a single number.");
}

TEST_F(BuilderErrors, RejectsDerivativesWithRespectToNonInputs) {
  expectRejected(
      method("derivative", {x, v3}),
      "derivative: expected a single input (such as position.x()) as argument 1, got a vec3.");
  expectRejected(
      call("derivative", {x, call("sin", {x})}),
      "derivative: argument 2 must be an input such as millis or position.x(), not something "
      "computed.");
  expectRejected(
      call("derivative", {x, number(2)}),
      "derivative: argument 2 must be an input such as millis or position.x(), not something "
      "computed.");
  expectRejected(
      call("gradient", {x, x}),
      "gradient: expected a vector of inputs (such as position) as argument 2, got a single "
      "number.");
  expectRejected(call("jacobian", {v2, call("vec2", {x, x})}),
                 "jacobian: argument 2 must not repeat a component.");
  expectRejected(
      call("jacobian", {v2, call("vec2", {x, number(1)})}),
      "jacobian: argument 2 must be an input such as millis or position.x(), not something "
      "computed.");
  expectRejected(
      call("adjustNormal", {v3, v3, v2}),
      "adjustNormal: expected a vec3 of inputs (such as position) as argument 3, got a vec2.");
}

TEST_F(BuilderErrors, RejectsVectorsAndMatricesBuiltFromWrongParts) {
  expectRejected(call("vec3", {x, x}), "vec3: expected 3 components, got 2.");
  expectRejected(call("vec3", {}), "vec3: expected 3 components, got 0.");
  expectRejected(call("vec3", {v2, v2}), "vec3: expected 3 components, got 4.");
  expectRejected(call("vec4", {m2}),
                 "vec4: expected a vector or a number as argument 1, got a mat2.");
  expectRejected(call("mat2", {}), "mat2: expected 4 components, got 0.");
  expectRejected(call("mat2", {x, x, x}), "mat2: expected 4 components, got 3.");
  expectRejected(call("mat2", {v3, x}), "mat2: expected 2 columns of 2 components, got a vec3.");
  expectRejected(call("mat3Rows", {v3, v2, v4}),
                 "mat3Rows: expected 3 rows of 3 components, got a vec2.");
  expectRejected(call("mat3", {v3, v3}), "mat3: expected 9 components, got 6.");
  expectRejected(call("mat3", {v3, m3}),
                 "mat3: expected a vector or a number as argument 2, got a mat3.");
}

TEST_F(BuilderErrors, RejectsComponentsThatDoNotExist) {
  expectRejected(method("column", {v3, number(0)}),
                 "column: expected a matrix as the value it is called on, got a vec3.");
  expectRejected(method("column", {m23, number(2)}),
                 "column: argument 1 must be a whole number from 0 to 1.");
  expectRejected(method("row", {m23, number(3)}),
                 "row: argument 1 must be a whole number from 0 to 2.");
  expectRejected(method("row", {m23, number(0.5)}),
                 "row: argument 1 must be a whole number from 0 to 2.");
  expectRejected(method("column", {m23, v2}),
                 "column: expected a single number as argument 1, got a vec2.");
  expectRejected(call("row", {m23, x}), "row: argument 2 must be a whole number from 0 to 2.");
  expectRejected(builder.swizzle(v2, 1, 2), "a vec2 has no such components.");
  expectRejected(builder.swizzle(v3, 3, 0b11'00'00), "a vec3 has no such components.");
  expectRejected(builder.swizzle(x, 1, 0), "a single number has no such components.");
  expectRejected(builder.swizzle(m2, 1, 0), "a mat2 has no such components.");
}

TEST_F(BuilderErrors, RejectsConstantsWhoseResultNoShaderCanHold) {
  const std::string message = "the result of these constants is not a finite float32 number.";
  const std::string divides = "a divisor is zero, or too close to zero for float32.";
  expectRejected(call("log", {number(0)}), "log: " + message);
  expectRejected(call("sqrt", {number(-1)}), "sqrt: " + message);
  expectRejected(call("log2", {number(0)}), "log2: " + message);
  expectRejected(call("asin", {number(2)}), "asin: " + message);
  expectRejected(call("atanh", {number(1)}), "atanh: " + message);
  expectRejected(call("pow", {number(-1), number(0.5)}), "pow: " + message);
  expectRejected(call("div", {number(1), number(0)}), "div: " + divides);
  expectRejected(call("div", {x, number(0)}), "div: " + divides);
  expectRejected(call("div", {x, call("mult", {number(1e-30), number(1e-30)})}), "div: " + divides);
  expectRejected(call("mod", {v3, number(0)}), "mod: " + divides);
  expectRejected(call("pow", {number(0), number(-1)}), "pow: " + divides);
  expectRejected(call("mult", {number(1e30), number(1e30)}), "mult: " + message);
  expectRejected(call("acosh", {number(0.5)}), "acosh: " + message);
  expectRejected(call("smoothstep", {number(1), number(1), x}), "smoothstep: " + divides);
  expectRejected(call("atan", {number(0), number(0)}), "atan: the point (0, 0) has no angle.");
  expectRejected(method("inverse", {call("mat2", {number(1), number(2), number(2), number(4)})}),
                 "inverse: the determinant of this matrix is 0, so that it has no inverse.");
  expectRejected(call("inverse", {call("mat2", {x, x, number(0), number(0)})}),
                 "inverse: the determinant of this matrix is 0, so that it has no inverse.");
  expectRejected(call("rotate", {call("vec3", {number(0)}), x}),
                 "rotate: the axis is zero, so that it has no direction.");
}

// A rejected node stays in the graph, so that an equal call returns it without an error: rejecting
// it again would require a search at each call. finish() reports it.
TEST_F(BuilderErrors, FinishReportsARejectedNodeThatOccursAgain) {
  const auto make = [&] { return call("smoothstep", {number(1), number(1), x}); };
  ASSERT_EQ(make(), Builder::failed);
  const int again = make();
  ASSERT_GE(again, 0);
  builder.output("gen", "y", again);
  EXPECT_FALSE(builder.finish());
  EXPECT_EQ(builder.problem(), "A result: a divisor is zero, or too close to zero for float32.");
}

TEST_F(BuilderErrors, RejectedOperationsLeaveNoTraceInTheCode) {
  EXPECT_EQ(call("log", {number(0)}), Builder::failed);
  builder.output("gen", "y", call("sin", {x}));
  ASSERT_TRUE(builder.finish()) << builder.problem();
  EXPECT_EQ(code(), "float y;\n{\n  y = sin(x);\n}\n");
}

// Adds four operations per call, to be faster.
TEST_F(BuilderErrors, RejectsMoreThanFourMillionOperations) {
  int value = v4;
  std::size_t calls = 0;
  for (; value != Builder::failed && calls <= Graph::maxNodes; ++calls)
    value = method("sin", {value});
  EXPECT_EQ(value, Builder::failed);
  EXPECT_GT(calls, Graph::maxNodes / 4 - 100);
  EXPECT_EQ(builder.problem(),
            "sin: more than four million operations; check for an endless loop or a derivative of "
            "very high order.");
}

}  // namespace
}  // namespace warpjet
