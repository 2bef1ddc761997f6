// The front end for shader source, part by part: tokens, preprocessor, types, and recording.
#include "source/glsl/glsl.hpp"

#include <gtest/gtest.h>

#include "source/assumption.hpp"
#include "source/glsl/built_in_table.hpp"
#include "source/glsl/preprocess.hpp"
#include "source/recorder.hpp"
#include "source/typing.hpp"

namespace warpjet::source::glsl {
namespace {

std::string preprocessToText(std::string_view text) {
  Problems problems;
  const PreprocessedSource read = preprocess(readTokens(text, problems), problems);
  if (problems.any()) return problems.message(text);
  std::string all;
  for (const Token& token : read.tokens) {
    if (token.kind != Token::Kind::End) (all += all.empty() ? "" : " ") += token.text;
  }
  return all;
}

Listing lowerToListing(const std::string& text) {
  Source source(parse(text));
  EXPECT_EQ(source.problem(), "");
  Listing listing = source.lower(0, 0);
  EXPECT_EQ(source.problem(), "");
  return listing;
}

// Returns the value of a function whose only result is a known number.
double evaluateConstant(const std::string& body) {
  const Listing listing = lowerToListing("float f() { " + body + " }");
  EXPECT_EQ(listing.words.size(), 2u) << body;
  return listing.constants.empty() ? -1 : listing.constants[0];
}

TEST(GlslTokens, ReadsNumbersNamesAndSymbols) {
  Problems problems;
  const auto tokens = readTokens("a1<<=.5e-3f 0x1Fu//x\n/* y */1.", problems);
  ASSERT_EQ(tokens.size(), 6u);
  EXPECT_EQ(tokens[1].text, "<<=");
  EXPECT_EQ(tokens[2].kind, Token::Kind::Float);
  EXPECT_DOUBLE_EQ(floatValue(tokens[2]), 5e-4);
  EXPECT_EQ(intValue(tokens[3], problems), 31u);
  EXPECT_EQ(tokens[4].location.line, 2u);
  EXPECT_EQ(tokens[4].location.column, 8u);
}

// Returns the message without its line, column and caret.
std::string problemOf(const std::string& text) {
  const std::string problem = Source(parse(text)).problem();
  const auto start = problem.find(": ");
  return problem.empty() ? "" : problem.substr(start + 2, problem.find('\n') - start - 2);
}

TEST(GlslVersions, RejectFeaturesOfTheOtherVersion) {
  const std::string bits = "int f(int n) { return n & 3; }";
  EXPECT_EQ(problemOf(bits), "");
  EXPECT_EQ(problemOf("#version 300 es\n" + bits), "");
  EXPECT_EQ(problemOf("#version 100\n" + bits),
            "\"&\" is not in GLSL ES 1.00, the language of #version 100; use floor() and mod(), or "
            "begin the source with #version 300 es.");
  EXPECT_EQ(problemOf("#version 300 es\nvarying vec2 v;"),
            "\"varying\" is not in GLSL ES 3.00, the language of #version 300 es; write \"out\".");
}

TEST(GlslVersions, LoopsInVersion100MustHaveConstantBounds) {
  const auto loop = [](const std::string& head, const std::string& body = "") {
    return problemOf("#version 100\nfloat f(int n) { const int limit = 4; float s = 0.0; for (" +
                     head + ") { s += 1.0; " + body + " } return s; }");
  };
  for (const char* head : {"int i = 0; i < limit; i++", "int i = 8; i >= 2 * limit; i -= 2",
                           "float t = 0.0; t < 1.0; t += 0.25"})
    EXPECT_EQ(loop(head), "") << head;
  for (const char* head :
       {"int i = 0; i < n; i++", "int i = n; i < 4; i++", "int i = 1; i < 9; i *= 2",
        "int i = 0; i < 4;", "; n < 4; n++", "int i = 0; 4 > i; i++"})
    EXPECT_NE(loop(head), "") << head;
  EXPECT_NE(loop("int i = 0; i < 4; i++", "i += 1;"), "");
}

TEST(GlslPreprocessor, ExpandsEachMacroOnce) {
  EXPECT_EQ(preprocessToText("#define A B\n#define B A\nA B"), "A B");
  EXPECT_EQ(preprocessToText("#define F(x, y) x - y\nF(F(1, 2), (3, 4))"), "1 - 2 - ( 3 , 4 )");
  EXPECT_EQ(preprocessToText("#define F(x) x\nF F(2)"), "F 2");
  EXPECT_EQ(preprocessToText("#define EMPTY\nEMPTY x EMPTY"), "x");
  EXPECT_EQ(preprocessToText("__LINE__\n#line 9\n__LINE__"), "1 9");
}

std::string describeTokens(std::string_view text) {
  const Lines lines(text);
  Problems problems;
  const PreprocessedSource read =
      preprocess(readTokens(lines.joined, problems, lines.joins), problems);
  if (problems.any()) return problems.message(lines.lines);
  std::string all;
  for (const Token& token : read.tokens)
    all += std::string(token.text) + '@' + std::to_string(token.location.line) + ':' +
           std::to_string(token.location.column) + ' ';
  return all;
}

TEST(GlslTokens, ABackslashJoinsLines) {
  EXPECT_EQ(describeTokens("a\\\nb c"), "ab@1:1 c@2:3 @2:4 ");
  EXPECT_EQ(describeTokens("a // \\\nb\nc"), "a@1:1 c@3:1 @3:2 ");
  EXPECT_EQ(describeTokens("a\\\r\n\\\r\nb\rc"), "ab@1:1 c@4:1 @4:2 ");
  EXPECT_EQ(describeTokens("#define A \\\n 1\nA"), "1@3:1 @3:2 ");
  EXPECT_EQ(describeTokens("/* \\\n \n */ a \\ b"),
            "line 3, column 7: shaders do not allow this character: \"\\\".\n"
            "   */ a \\ b\n        ^");
}

TEST(GlslPreprocessor, ExpandsLineAndFileNumbers) {
  EXPECT_EQ(preprocessToText("#line 5 2\n__LINE__ __FILE__\n__LINE__"), "5 2 6");
  EXPECT_EQ(preprocessToText("#define N 3\n#line (N + 4) N * 2\n__LINE__ __FILE__"), "7 6");
  EXPECT_EQ(preprocessToText("#define F(x) x __LINE__\nF(\n__LINE__\n) __LINE__"), "3 4 4");
  EXPECT_EQ(preprocessToText("#define L __LINE__\n#define F(x) L x\nF(\nL\n)"), "5 4");
  EXPECT_EQ(preprocessToText("__VERSION__"), "100");
}

TEST(GlslPreprocessor, AcceptsAnythingInSkippedLines) {
  EXPECT_EQ(preprocessToText("#if 0\n@ \"a' 1.e 0x #\n#nonsense\n#if\n#else A\n#endif\n#endif\na"),
            "a");
  EXPECT_EQ(preprocessToText("#define A @\nb"), "b");
  EXPECT_EQ(preprocessToText("#if 0 && A || 1 || B / 0\na\n#endif"), "a");
}

TEST(GlslPreprocessor, ReadsArgumentsOfAnExpandedMacroNameFromTheFollowingTokens) {
  EXPECT_EQ(preprocessToText("#define F G\n#define G(x) x\nF(1)"), "1");
  EXPECT_EQ(preprocessToText("#define G(x) x\n#define E G\n#define F E\nF (F(2)) F"), "2 G");
  EXPECT_EQ(preprocessToText("#define A(x) x + B\n#define B(x) x\nA(1)(2)(3)"), "1 + 2 ( 3 )");
  EXPECT_EQ(preprocessToText("#define PICK(x) x\n#define G(x) -x\nPICK(G)(1)"), "- 1");
  // A call that begins in an expansion ends in the tokens after it.
  EXPECT_EQ(preprocessToText("#define F(x, y) x - y\n#define OPEN F (\nOPEN 1, 2) + 3"),
            "1 - 2 + 3");
  EXPECT_EQ(preprocessToText("#define F(x) - x\n#define A F(\n#define B A 1\nB) 2"), "- 1 2");
  std::string deep = "#define M F(\n#define F(x) N x\n#define N G(\n#define G(x) M x\nM 1 ";
  for (int i = 0; i < 100'000; ++i) deep += ") ";
  EXPECT_NE(preprocessToText(deep).find("1,000 deep"), std::string::npos);
  // A parenthesis that is still a macro doesn't begin a call, unless the result is expanded again.
  EXPECT_EQ(preprocessToText("#define F(x) - x\n#define L (\nF L 1)"), "F ( 1 )");
  EXPECT_EQ(preprocessToText("#define F(x) - x\n#define L (\n#define E(x) x\nE(F L 1))"), "- 1");
  // A macro isn't expanded within its own expansion, and its name there isn't expanded later
  // either.
  EXPECT_EQ(preprocessToText("#define F(x) x F\nF(1)(2)"), "1 F ( 2 )");
}

TEST(GlslPreprocessor, KeepsLinesWhoseConditionIsTrue) {
  EXPECT_EQ(preprocessToText("#if 1 + 2 * 3 == 7 && !defined(X)\na\n#else\nb\n#endif"), "a");
  EXPECT_EQ(preprocessToText("#define X 2\n#if X == 1\na\n#elif X == 2\nb\n#elif 1\nc\n#endif"),
            "b");
  EXPECT_EQ(preprocessToText("#if 0\n#if 1\na\n#endif\n#nonsense\n#else\nb\n#endif"), "b");
  EXPECT_EQ(preprocessToText("#ifdef GL_ES\na\n#endif\n#ifndef GL_ES\nb\n#endif"), "a");
}

TEST(GlslTypes, OperatorsDoNotConvertTypes) {
  const Types types;
  const auto type = [&](Operator op, Type a, Type b) { return typeOfBinary(op, a, b, types); };
  const Type vec3 = vectorType(Base::Float, 3), vec2 = vectorType(Base::Float, 2);
  EXPECT_EQ(type(Operator::Add, floatType, vec3), vec3);
  EXPECT_EQ(type(Operator::Add, intType, floatType), std::nullopt);
  EXPECT_EQ(type(Operator::Multiply, matrixType(2, 3), vec2), vec3);
  EXPECT_EQ(type(Operator::Multiply, vec3, matrixType(2, 3)), vec2);
  EXPECT_EQ(type(Operator::Multiply, matrixType(2, 3), matrixType(4, 2)), matrixType(4, 3));
  EXPECT_EQ(type(Operator::Multiply, matrixType(2, 3), vec3), std::nullopt);
  EXPECT_EQ(type(Operator::Equal, vec3, vec3), boolType);
  EXPECT_EQ(type(Operator::Less, vec3, vec3), std::nullopt);
  EXPECT_EQ(type(Operator::Remainder, floatType, floatType), std::nullopt);
}

TEST(GlslTypes, ResolvesBuiltInFunctionsByOperandTypes) {
  const Type vec3 = vectorType(Base::Float, 3), bvec3 = vectorType(Base::Bool, 3);
  const auto result = [](std::string_view name, std::vector<Type> operands) {
    const auto found = findBuiltIn(builtIns, name, operands);
    return found ? std::optional(found->result) : std::nullopt;
  };
  EXPECT_EQ(result("mix", {vec3, vec3, floatType}), vec3);
  EXPECT_EQ(result("mix", {vec3, vec3, bvec3}), vec3);
  EXPECT_EQ(result("mix", {vec3, vec3, boolType}), std::nullopt);
  EXPECT_EQ(result("lessThan", {vec3, vec3}), bvec3);
  EXPECT_EQ(result("outerProduct", {vec3, vectorType(Base::Float, 2)}), matrixType(2, 3));
  EXPECT_EQ(result("transpose", {matrixType(2, 3)}), matrixType(3, 2));
  EXPECT_EQ(result("max", {intType, intType}), intType);
  EXPECT_EQ(result("max", {intType, floatType}), std::nullopt);
}

TEST(GlslLowering, FoldsKnownValues) {
  EXPECT_EQ(evaluateConstant(
                "float s = 0.; for (int i = 0; i < 5; i++) { if (i == 3) break; s += float(i); } "
                "return s;"),
            3);
  EXPECT_EQ(evaluateConstant("int i = 7; return float(i / 2 * 2 + i % 2 - -i);"), 14);
  EXPECT_EQ(evaluateConstant("return float(-7 / 2);"), -3);
  EXPECT_EQ(evaluateConstant("return float(2147483647 + 1);"), -2147483648.0);
  EXPECT_EQ(evaluateConstant("return float(0u - 1u);"), static_cast<double>(4294967295.0f));
  EXPECT_EQ(evaluateConstant("return float(-8 >> 1) + float(0xF0u >> 4);"), 11);
  EXPECT_EQ(evaluateConstant("return float(int(-2.9)) + float(int(2.9));"), 0);
  EXPECT_EQ(
      evaluateConstant("int a[3] = int[](4, 5, 6); a[1] += a[2]; return float(a[a.length() - 2]);"),
      11);
  EXPECT_EQ(evaluateConstant("float a[bool(0.5) ? 2 : 3]; return float(a.length());"), 2);
  EXPECT_EQ(evaluateConstant("float a[bool(-0.0) ? 2 : 3]; return float(a.length());"), 3);
  // In float32 the tenth sum of 0.1 is just above 1, so the loop ends after 10 iterations.
  EXPECT_EQ(
      evaluateConstant("float n = 0.; for (float t = 0.; t < 1.; t += .1) n += 1.; return n;"), 10);
}

TEST(GlslLowering, ListsOnlyWhatTheResultNeeds) {
  const Listing listing =
      lowerToListing("float f(float x, float y) { float unused = sin(y); return x; }");
  EXPECT_EQ(listing.words.size(), 4u);
  EXPECT_EQ(listing.words[0], static_cast<std::uint32_t>(Code::Argument));
}

TEST(GlslRecorder, SimplifiesConditions) {
  Recorder recorder;
  const Id c = recorder.apply(
      Code::Lt, Base::Bool, {recorder.leaf(Code::Argument, 0), recorder.constant(Base::Float, 1)});
  const Id yes = recorder.constant(Base::Bool, 1), no = recorder.constant(Base::Bool, 0);
  EXPECT_EQ(recorder.choose(c, yes, no), c);
  EXPECT_EQ(recorder.choose(c, no, yes), recorder.logicalNot(c));
  EXPECT_EQ(recorder.logicalNot(recorder.logicalNot(c)), c);
  EXPECT_EQ(recorder.logicalAnd(c, yes), c);
  EXPECT_EQ(recorder.logicalOr(c, c), c);
  const Id x = recorder.leaf(Code::Argument, 1);
  EXPECT_EQ(recorder.choose(c, x, recorder.undefined(Base::Float)), x);
}

TEST(GlslAssumption, FollowsTheChoicesByPartsOfACondition) {
  Recorder recorder;
  const Id zero = recorder.constant(Base::Float, 0);
  const auto isPositive = [&](int argument) {
    return recorder.apply(Code::Gt, Base::Bool, {recorder.leaf(Code::Argument, argument), zero});
  };
  const Id a = isPositive(0), b = isPositive(1), c = isPositive(2);
  const Id x = recorder.leaf(Code::Argument, 3), y = recorder.leaf(Code::Argument, 4),
           z = recorder.leaf(Code::Argument, 5);
  const Id byA = recorder.choose(a, x, recorder.choose(b, y, z));
  EXPECT_EQ(Assumption(recorder, a, true).apply(byA), x);
  EXPECT_EQ(Assumption(recorder, a, false).apply(byA), recorder.choose(b, y, z));
  const Id isEither = recorder.logicalOr(a, b);
  EXPECT_EQ(Assumption(recorder, isEither, false).apply(byA), z);
  EXPECT_EQ(Assumption(recorder, isEither, true).apply(byA), byA);
  EXPECT_EQ(Assumption(recorder, recorder.logicalAnd(a, c), true).apply(byA), x);
  // a || (!a && b) is false only if b is false, too.
  const Id second = recorder.logicalOr(a, recorder.logicalAnd(recorder.logicalNot(a), b));
  EXPECT_EQ(Assumption(recorder, second, false).apply(byA), z);
  EXPECT_EQ(Assumption(recorder, recorder.logicalNot(a), true).apply(a),
            recorder.constant(Base::Bool, 0));
}

TEST(GlslLowering, LimitsSourceLengthAndIterations) {
  std::string sum = "float f(float x) { return x";
  for (int i = 0; i < 10'000; ++i) sum += " + x";
  EXPECT_EQ(Source(parse(sum + "; }")).problem(), "");
  Source endless(
      parse("float f(float x) { for (int i = 0; i < 2000000; i++) x = sin(x); return x; }"));
  endless.lower(0, 0);
  EXPECT_NE(endless.problem().find("has not ended after 20000 iterations"), std::string::npos)
      << endless.problem();
  const std::string loops = "for (int i = 0; i < 1000; i++) for (int j = 0; j < 1000; j++) ";
  Source wide(parse("float f(float x) { " + loops + "x = sin(x); return x; }"));
  wide.lower(0, 0);
  EXPECT_EQ(wide.problem(), "");
  // Each element of the array is a state, of which a loop in the resulting shader has at most 32,
  // so this loop is unrolled.
  Source many(parse("float f(float x) { float a[40]; " + loops +
                    "a[int(x) + j] += sin(x); return a[3]; }"));
  many.lower(0, 0);
  EXPECT_NE(many.problem().find("more than 250,000 steps"), std::string::npos) << many.problem();
}

}  // namespace
}  // namespace warpjet::source::glsl
