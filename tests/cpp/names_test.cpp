// Names and expressions from outside: which of them may be used in a shader.
#include "emit/names.hpp"

#include <gtest/gtest.h>

#include "module/syntax.hpp"

namespace warpjet {
namespace {

TEST(Names, AcceptsHostExpressions) {
  for (const char* text :
       {"position", "aPosition", "inputs.position", "(uModel * vec4(aPosition, 1.0)).xyz", "-x",
        "1.5e-3 * x", "f()", "f(a, b[2].c)", "a < b ? a : b", "a - -b", "float(gl_VertexID)",
        "!flag && x >= .5", "mat3(m)[0].x", "a ? b ? c : d : e", "sin(x)", "2.0 * vec2(x).y",
        "1e3"})
    EXPECT_EQ(inputProblem(glsl300, text), "") << text;
}

TEST(Names, RejectsBrokenExpressions) {
  for (const char* text :
       {"",       " ",      "a b",      "a +",  "* a",    "(a",     "a)",    "(a]",   "a; b",
        "a = b",  "a += b", "a++",      "--a",  "a // b", "a /* b", "f(,a)", "f(a,)", "a, b",
        "a ? b",  "a : b",  "a[",       "a[]",  "{a}",    "a.",     ".a",    "a\nb",  "#define",
        "a$b",    "\"a\"",  "a.5b.c d", "()",   "x!",     "2x",     "2(x)",  "2.xyz", "1.0.xyz",
        "(a)(b)", "float",  "vec3",     "true", "sin",    "1e"})
    EXPECT_NE(inputProblem(glsl300, text), "") << text;
}

TEST(Names, RejectsReservedWords) {
  for (const char* text : {"for", "while", "sampler2D", "gl_Foo", "a__b", "__x", "webgl_x",
                           "_webgl_x", "struct", "return", "in", "a + discard"})
    EXPECT_NE(inputProblem(glsl300, text), "") << text;
  EXPECT_NE(inputProblem(glsl300, "switch"), "");
  EXPECT_NE(inputProblem(glsl300, "sample"), "");
  EXPECT_EQ(inputProblem(glsl100, "sample"), "") << "reserved only since GLSL ES 3.00";
  for (const char* text : {"float(gl_VertexID)", "float(a % 2)", "float(a << 1)"}) {
    EXPECT_EQ(inputProblem(glsl300, text), "") << text;
    EXPECT_NE(inputProblem(glsl100, text), "") << text << " is new in GLSL ES 3.00";
  }
  EXPECT_EQ(inputProblem(glsl100, "a && b || c ^^ d"), "");
}

TEST(Names, BuiltInVariablesOfOtherTypesNeedAConversion) {
  EXPECT_EQ(inputProblem(glsl300, "gl_VertexID"), "it is not a float; write float(gl_VertexID)");
  EXPECT_EQ(inputProblem(glsl300, "float(gl_VertexID)"), "");
  EXPECT_EQ(inputProblem(glsl300, "gl_FragCoord"), "");
}

TEST(Names, ResultsNeedIdentifiers) {
  EXPECT_EQ(outputProblem(glsl300, "dzdx"), "");
  EXPECT_EQ(outputProblem(glsl300, "length"), "") << "a function that we never call";
  for (const char* name :
       {"", "2x", "a b", "a.b", "a-b", "vec3", "float", "gl_Position", "a__b", "cos", "mix"})
    EXPECT_NE(outputProblem(glsl300, name), "") << name;
}

TEST(Names, MembersAreNotIdentifiers) {
  const auto found = identifiers("inputs.uv * scale + f(2.0).x");
  EXPECT_EQ(found, (std::vector<std::string_view>{"inputs", "scale", "f"}));
}

TEST(Names, RecognizesPlainVariables) {
  EXPECT_TRUE(isPlainVariable("position"));
  EXPECT_TRUE(isPlainVariable("inputs.uv"));
  EXPECT_FALSE(isPlainVariable("f(x)"));
  EXPECT_FALSE(isPlainVariable("a + b"));
  EXPECT_FALSE(isPlainVariable("1.0"));
}

}  // namespace
}  // namespace warpjet
