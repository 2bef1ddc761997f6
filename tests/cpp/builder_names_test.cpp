// Errors of the builder about inputs, host functions and results: their names, and their use.
#include <gtest/gtest.h>

#include "builder_errors.hpp"

namespace warpjet {
namespace {

TEST_F(BuilderErrors, RejectsInputsThatNoShaderCanRead) {
  expectRejected(input("x", vectorOf(2)),
                 "glsl: \"x\" was read as a single number before, and now as a vec2.");
  expectRejected(
      input("m2", matrixOf(2, 3)),
      "glsl: \"m2\" was read as a mat2 before, and now as a matrix of 2 columns and 3 rows.");
  expectRejected(input("a +"),
                 "glsl: \"a +\" cannot be read in a shader: an operand is missing in it.");
  expectWriteRejected(
      [](Bench& bench) { EXPECT_GE(bench.input("for"), 0); },
      "glsl: \"for\" cannot be read in a shader: \"for\" is a reserved word of GLSL.");
  expectRejected(
      input("a\nb"),
      "glsl: \"a b\" cannot be read in a shader: only ASCII characters are allowed in it.");
  EXPECT_GE(input("p.x"), 0);
  expectRejected(
      input("p", vectorOf(3)),
      "glsl: \"p.x\" was read before \"p\", of which it is a part; read the vector first.");
  expectRejected(input(""), "glsl: \"\" cannot be read in a shader: it is empty.");
}

TEST_F(BuilderErrors, RejectsHostFunctionsThatTheSourceDoesNotDefine) {
  const std::string problem =
      "fn: \"noise\" is not in the source, which must define a function with that name.";
  for (const char* source : {"float other(float x) { return x; }", "float noise;",
                             "float mynoise(float x) { return x; }", ""})
    expectWriteRejected([&](Bench& bench) { EXPECT_GE(bench.hostFunction("noise", source, 1), 0); },
                        problem);
}

TEST_F(BuilderErrors, RejectsInvalidNamesAndArgumentCountsOfHostFunctions) {
  expectRejected(hostFunction("noise", "float noise() { return 1.0; }", 0),
                 "fn: \"noise\" must have at least one argument.");
  const auto expectNameRejected = [&](const std::string& name, const std::string& reason) {
    expectWriteRejected(
        [&](Bench& bench) {
          EXPECT_GE(bench.hostFunction(name, "float " + name + "(float x) { return x; }", 1), 0);
        },
        "fn: \"" + name + "\" cannot name a function: " + reason);
  };
  expectNameRejected(
      "2d", "a name consists of letters, digits and underscores and does not start with a digit.");
  expectNameRejected("sin", "\"sin\" is a function of GLSL.");
  expectNameRejected("for", "\"for\" is a reserved word of GLSL.");
}

TEST_F(BuilderErrors, RejectsHostFunctionsWithReservedNames) {
  const auto expectNameRejected = [&](const std::string& name, const std::string& reason) {
    expectWriteRejected(
        [&](Bench& bench) {
          EXPECT_GE(bench.hostFunction(name, "float " + name + "(float x) { return x; }", 1), 0);
        },
        "fn: \"" + name + "\" cannot name a function: " + reason);
  };
  expectNameRejected("main", "it is the entry point of a shader.");
  expectNameRejected("radians", "\"radians\" is a function of GLSL.");
  expectRejected(
      hostFunction("warpjetHash", "float warpjetHash(float x) { return x; }", 1),
      "fn: \"warpjetHash\" cannot name a function: such names are reserved for warpjet; rename "
      "it.");
}

TEST_F(BuilderErrors, RejectsAStructVariableNamedLikeAFunction) {
  const int inputs = hostFunction("inputs", "float inputs(float x) {}", 1);
  builder.output("gen", "y", callFunction(inputs, {input("inputs.height")}));
  expectCodeRejected(*this, "\"inputs\" is both a variable and a function; rename one.");
}

TEST_F(BuilderErrors, AcceptsAHostExpressionThatCallsTheFunction) {
  const int wave = hostFunction("wave", "float wave(float x) {}", 1);
  builder.output("gen", "y", callFunction(wave, {input("wave(uTime)")}));
  EXPECT_TRUE(writeResults().text) << problemOfText();
}

TEST_F(BuilderErrors, RejectsASecondFunctionWithTheSameName) {
  const std::string source = "float noise(float x) { return x; }";
  const int noise = hostFunction("noise", source, 1);
  EXPECT_EQ(hostFunction("noise", source, 1), noise) << "the same function may be added again";
  const std::string problem = "fn: \"noise\" is already the name of another function; rename one.";
  expectRejected(hostFunction("noise", source + ' ', 1), problem);
  expectRejected(hostFunction("noise", source, 2), problem);
  EXPECT_EQ(text(callFunction(noise, {x})), "noise(x)");
}

TEST_F(BuilderErrors, RejectsHostFunctionCallsWithWrongArguments) {
  const int noise = hostFunction("noise", "float noise(float x, float y) {}", 2);
  expectRejected(callFunction(noise, {x}), "noise: expected 2 arguments, got 1.");
  expectRejected(
      callFunction(noise, {v2, v3}),
      "noise: a vec2 and a vec3 do not fit together; use vectors of the same size, or numbers.");
  expectRejected(callFunction(noise, {m2, x}),
                 "noise: expected a number or a vector as argument 1, got a mat2.");
  EXPECT_EQ(text(callFunction(noise, {x, x})), "noise(x, x)");
}

TEST_F(BuilderErrors, RejectsAFunctionWithoutSourceInTheTargetLanguage) {
  builder.addFunction("noise", {{"wgsl", "fn noise(x: f32) -> f32 { return x; }"}}, 1);
  expectCodeRejected(
      *this,
      "fn: the option \"source\" of noise must be a source in GLSL for the target glsl300, or "
      "an object { glsl: … } with one.");
}

TEST_F(BuilderErrors, RejectsInvalidResultNames) {
  const auto expectNameRejected = [&](const std::string& name, const std::string& message) {
    expectWriteRejected([&](Bench& bench) { bench.builder.output("gen", name, bench.x); }, message);
  };
  expectNameRejected(
      "a b",
      "gen: \"a b\" cannot name a result: a name consists of letters, digits and underscores "
      "and does not start with a digit.");
  expectNameRejected("cos", "gen: \"cos\" cannot name a result: \"cos\" is a function of GLSL.");
  expectNameRejected("fine", "gen: there are two results named \"fine\"; rename one.");
}

TEST_F(BuilderErrors, RejectsRectangularMatrixResultsInWebGl1) {
  Bench old(glsl100);
  old.builder.output("gen", "j", old.m23);
  expectCodeRejected(
      old,
      "gen: the result \"j\" is a matrix of 2 columns and 3 rows, but WebGL 1 has only "
      "square matrices; use its columns, such as .column(0).");
  Bench square(glsl100);
  square.builder.output("gen", "j", square.m3);
  EXPECT_TRUE(square.writeResults().text);
  builder.output("gen", "j", m23);
  EXPECT_TRUE(writeResults().text) << "WebGL 2 has rectangular matrices";
}

TEST_F(BuilderErrors, RejectsResultsThatHideAVariable) {
  const int uv = input("inputs.uv * scale", vectorOf(2));
  builder.output("gen", "uv", uv);  // a member isn't hidden
  builder.output("gen", "v2", x);   // v2 isn't read
  ASSERT_TRUE(writeResults().text) << problemOfText();
  builder.output("gen", "scale", uv);
  expectCodeRejected(
      *this,
      "The result \"scale\" has the name of a variable or function that its code reads "
      "(\"inputs.uv * scale\"); rename the result.");
}

TEST_F(BuilderErrors, RejectsResultsThatHideAFunction) {
  const int noise = hostFunction("noise", "float noise(float x) {}", 1);
  builder.output("gen", "noise", callFunction(noise, {x}));
  expectCodeRejected(
      *this,
      "The result \"noise\" has the name of a variable or function that its code reads "
      "(\"noise\"); rename the result.");
}

TEST_F(BuilderErrors, RejectsAVariableNamedLikeAFunction) {
  const int noise = hostFunction("noise", "float noise(float x) {}", 1);
  builder.output("gen", "y", callFunction(noise, {input("noise")}));
  expectCodeRejected(*this, "\"noise\" is both a variable and a function; rename one.");
}

// When the offset function was recorded, x and v2 were separate inputs. The host's new names make x
// the same as v2, or a component of it.
TEST_F(BuilderErrors, RejectsNamesThatMergeTwoInputs) {
  builder.output("gen", "y", call("mult", {x, v2}));
  for (const char* name : {"v2", "v2.x", "( v2 ) [1]"}) {
    const ShaderTextResult written = write(builder.module(), glsl300, {.inputs = {{0, name}}});
    EXPECT_EQ(written.problem,
              "glsl: \"" + std::string(name) +
                  "\" is already the name of another input (\"v2\"), but was not when "
                  "the function was compiled; rename one, or compile it with these "
                  "names.");
  }
  const ShaderTextResult written = write(builder.module(), glsl300, {.inputs = {{0, "v22.x"}}});
  EXPECT_TRUE(written.text) << written.problem;
}

}  // namespace
}  // namespace warpjet
