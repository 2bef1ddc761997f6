// The front end for WGSL: tokens, types, constants, declarations, and messages.
#include "source/wgsl/wgsl.hpp"

#include <gtest/gtest.h>

#include "source/wgsl/tokens.hpp"

namespace warpjet::source::wgsl {
namespace {

std::vector<std::string> textsOf(std::string_view source) {
  Problems problems;
  std::vector<std::string> texts;
  for (const Token& token : readTokens(source, problems))
    if (token.kind != Token::Kind::End) texts.emplace_back(token.text);
  EXPECT_FALSE(problems.any());
  return texts;
}

// Returns the message without its line, column and caret.
std::string problemOf(const std::string& text) {
  const std::string problem = Source(parse(text)).problem();
  const auto start = problem.find(": ");
  return problem.empty() ? "" : problem.substr(start + 2, problem.find('\n') - start - 2);
}

std::string problemIn(const std::string& statements) {
  return problemOf("fn f(p: vec3f) -> f32 { " + statements + " return 1; }");
}

// Returns the listing of the last function.
Listing lowerLast(const std::string& text) {
  Source source(parse(text));
  EXPECT_EQ(source.problem(), "") << text;
  if (!source.problem().empty()) return {};
  Listing listing = source.lower(static_cast<int>(source.functions().back().number), 0);
  EXPECT_EQ(source.problem(), "") << text;
  return listing;
}

// Returns the value of a function whose only result is a known number.
double evaluateConstant(const std::string& body, const std::string& above = "") {
  const Listing listing = lowerLast(above + " fn f() -> f32 { " + body + " }");
  EXPECT_EQ(listing.words.size(), 2u) << body;
  return listing.constants.empty() ? -1 : listing.constants[0];
}

TEST(WgslTokens, SplitsNamesNumbersAndSymbols) {
  const std::vector<std::string> wanted{"a1", "<<=", ".5e-3f", "0x1Fu", "1.", "->", "&&", "x"};
  EXPECT_EQ(textsOf("a1<<=.5e-3f 0x1Fu//x\n/* y /* z */ */1. ->&&x"), wanted);
  const std::vector<std::string> single{">", ">", "=", ">", ">"};
  EXPECT_EQ(textsOf(">>= >>"), single);
}

TEST(WgslTokens, NumbersHaveTheTypeOfTheirSuffix) {
  const auto number = [](std::string_view text) {
    Problems problems;
    const auto read = readNumber(readTokens(text, problems)[0], problems);
    EXPECT_TRUE(read.has_value()) << text;
    return read.value_or(Number{voidType, false, 0});
  };
  EXPECT_EQ(number("0x1p-2f").value, 0.25);
  EXPECT_EQ(number("0x1p-2f").type, floatType);
  EXPECT_EQ(number("7u").type, uintType);
  EXPECT_FALSE(number("7i").isAbstract);
  EXPECT_TRUE(number("7").isAbstract);
  EXPECT_EQ(number("7f").type, floatType);
  EXPECT_EQ(number("0xFFFFFFFFu").value, 4294967295.0);
}

TEST(WgslTokens, LocationsCountLinesInsideOfComments) {
  Problems problems;
  const auto tokens = readTokens("/* \n */ a\n  b", problems);
  EXPECT_EQ(tokens[0].location.line, 2u);
  EXPECT_EQ(tokens[0].location.column, 5u);
  EXPECT_EQ(tokens[1].location.line, 3u);
  EXPECT_EQ(tokens[1].location.column, 3u);
}

TEST(WgslConstants, AbstractNumbersHave64Bits) {
  EXPECT_EQ(evaluateConstant("return (1 << 40) / (1 << 38);"), 4);
  EXPECT_EQ(evaluateConstant("return 1e300 / 1e299;"), static_cast<double>(10.0f));
  EXPECT_EQ(evaluateConstant("return f32(7 / 2) + 7 / 2.0;"), 6.5);
  EXPECT_EQ(evaluateConstant("return -7 % 4;"), -3);
  EXPECT_EQ(evaluateConstant("return f32(0xFFFFFFFFu % 7) + f32(5u - 3);"), 5);
  EXPECT_EQ(evaluateConstant("const a = array(1, 2.5); return a[1] * vec2(2, 3).y;"), 7.5);
  EXPECT_NE(problemIn("let i: i32 = 1.0;"), "");
  EXPECT_NE(problemIn("let i = 2147483648;"), "");
  EXPECT_NE(problemIn("let u: u32 = -1;"), "");
}

TEST(WgslConstants, DeclarationsMayBeInAnyOrder) {
  EXPECT_EQ(evaluateConstant("return a + g();",
                             "fn g() -> f32 { return S(b).x; } const a = b * 2; struct S { "
                             "x: F } alias F = f32; const b = 1.5;"),
            4.5);
  EXPECT_EQ(problemOf("const a = b; const b = a; fn f() { }"), "\"a\" depends on itself.");
}

TEST(WgslLoops, ContinuingReadsVariablesOfTheBody) {
  EXPECT_EQ(evaluateConstant(
                "var s = 0.0; var i = 0; loop { if s > 100 { break; } let x = f32(i) + 1; if i == "
                "2 { i += 2; continue; } continuing { s += x; i++; break if i > 6; } } return s;"),
            1 + 2 + 3 + 6 + 7);
}

// Only the shader knows whether the body goes on after the break.
TEST(WgslLoops, ContinuingReadsVariablesDeclaredAfterABreak) {
  const Listing listing = lowerLast(
      "fn f(p: f32) -> f32 { var s = 0.0; var i = 0; loop { if p > s { break; } let x = "
      "f32(i); continuing { s += x; i++; break if i > 3; } } return s; }");
  EXPECT_EQ(listing.constants, (std::vector<double>{0, 1, 3, 6})) << "the sums of x";
}

TEST(WgslPointers, KeepTheIndexOfTheirElement) {
  EXPECT_EQ(evaluateConstant(
                "var a = array(1f, 2, 3); var i = 1; let q = &a[i]; i = 2; *q = 7; return a[1] * "
                "10 + a[2];"),
            73);
}

TEST(WgslFunctions, MustReturnAtTheirEnd) {
  for (const char* body : {"loop { return 1; }", "if true { return 1; } else { return 2; }",
                           "switch 1 { default: { return 1; } }", "for (;;) { return 1; }"})
    EXPECT_EQ(problemOf(std::string("fn f() -> f32 { ") + body + " }"), "") << body;
  for (const char* body : {"", "if true { return 1; }", "while true { return 1; }",
                           "switch 1 { case 1: { break; } default: { return 1; } }",
                           "loop { if true { break; } return 1; }"})
    EXPECT_EQ(problemOf(std::string("fn f() -> f32 { ") + body + " }"),
              "expected \"f\" to return an f32 at its end, but it may end without a return.")
        << body;
}

// Functions of a shader that aren't run may use features that no warp can use.
TEST(WgslFunctions, FailOnlyForWhatTheyRun) {
  const std::string shader =
      "@group(0) @binding(0) var<storage, read_write> out: array<f32>; "
      "@compute @workgroup_size(1) fn write() { out[0] = 1; discard; } "
      "fn f(p: f32) -> f32 { return p; } fn g() -> f32 { write(); return 1; }";
  Source source(parse(shader));
  ASSERT_EQ(source.problem(), "");
  source.lower(1, 0);
  EXPECT_EQ(source.problem(), "");
  source.lower(2, 0);
  EXPECT_NE(source.problem().find("\"out\" can be written by the shader"), std::string::npos)
      << source.problem();
}

TEST(WgslInputs, AreOnlyThoseThatAreRead) {
  const Listing listing = lowerLast(
      "struct L { at: vec3f, on: u32 } struct U { time: f32, all: array<L, 2>, rest: mat4x4f } "
      "var<uniform> u: U; var<storage> s: array<vec2f>; "
      "fn f(i: i32) -> f32 { return u.time * u.all[1].at.y + s[7].x + u.all[i].at.x; }");
  std::string names;
  for (const HostName& each : listing.names) names += each.type + ' ' + each.name + ", ";
  EXPECT_EQ(names,
            "vec3 u.all[1].at, float u.time, vec2 s[7], vec3 u.all[0].at, uint u.all[0].on, vec3 "
            "u.all[1].at, uint u.all[1].on, ");
}

TEST(WgslMessages, SayWhatToWrite) {
  EXPECT_EQ(Source(parse("fn f() -> f32 {\n  return 1 ? 2 : 3;\n}")).problem(),
            "line 2, column 12: WGSL has no ? : ; write select(valueIfFalse, valueIfTrue, "
            "condition).\n    return 1 ? 2 : 3;\n             ^");
  EXPECT_EQ(
      problemIn("let x = p.x + 1u;"),
      "\"+\" does not take an f32 and a u32; WGSL has no implicit conversions: write f32(x).");
  EXPECT_EQ(
      problemIn("float x = 1.0;"),
      "expected a statement, got \"float\"; WGSL declares a variable by let or var: write let "
      "x = and its value.");
  EXPECT_EQ(
      problemIn("let x = mod(p.x, 2);"),
      "\"mod\" is a function of GLSL; write x - y * floor(x / y), or x % y, which has the sign "
      "of x.");
  EXPECT_EQ(problemIn("let x = siin(p.x);"), "there is no function \"siin\"; did you mean sin?");
  EXPECT_EQ(
      problemIn("let x = p.x; x = 2;"),
      "\"x\" is a value and cannot be changed; copy it to a var first, or assign one component "
      "at a time.");
  EXPECT_EQ(problemIn("let x = a & b | c;"), "\"a\" is not declared.");
  EXPECT_EQ(problemIn("let x = 1 & 2 | 4;"),
            "expected parentheses, since WGSL does not define the order of & and |.");
  EXPECT_EQ(problemIn("let x = 1 * 2 + 3 << 4;"),
            "expected parentheses, since WGSL does not define the order of * and <<.");
  EXPECT_EQ(problemIn("let x = 1--2 & 4;"),
            "expected parentheses, since WGSL does not define the order of - and &.");
  EXPECT_EQ(problemIn("let x = 1 < 2 & 4;"),
            "expected parentheses, since WGSL does not define the order of < and &.");
  EXPECT_EQ(problemIn("let x = true && true & false;"),
            "expected parentheses, since WGSL does not define the order of && and &.");
  EXPECT_EQ(problemIn("var v: vec3h;"), "f16 is not supported; write f32.");
  EXPECT_EQ(problemIn("let t: mat3 = 1;"), "\"mat3\" is a type of GLSL; write mat3x3f.");
  EXPECT_EQ(problemIn("let x = vec3f(p.xy);"), "expected 3 components for vec3f, got 2.");
}

TEST(WgslLimits, DeepNestingIsAProblem) {
  for (const char* open : {"(", "-", "vec3f(", "array<", "p["}) {
    std::string text = "fn f(p: vec3f) -> f32 { let x = ";
    for (int i = 0; i < 5000; ++i) text += open;
    EXPECT_NE(problemOf(text), "") << open;
  }
  std::string blocks = "fn f() { ";
  for (int i = 0; i < 5000; ++i) blocks += "{";
  EXPECT_NE(problemOf(blocks), "");
  std::string sum = "fn f(x: f32) -> f32 { return x";
  for (int i = 0; i < 10'000; ++i) sum += " + x";
  EXPECT_EQ(problemOf(sum + "; }"), "");
}

}  // namespace
}  // namespace warpjet::source::wgsl
