// The differences between the languages: type names, declarations, literals, spellings, and the
// names and expressions of a host that they accept.
#include "emit/dialect.hpp"

#include <gtest/gtest.h>

#include "emit/names.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

using ops::Type;

class DialectTest : public testing::Test {
 protected:
  Graph graph;
  Expression x = scalar(graph, "x"), y = scalar(graph, "y"), z = scalar(graph, "z");

  Expression row(std::string_view name, Expression a) {
    return {&graph, graph.apply(rowNamed(name), {a.id})};
  }
};

TEST_F(DialectTest, FindsDialectsByName) {
  EXPECT_EQ(findDialect("glsl300"), &glsl300);
  EXPECT_EQ(findDialect("glsl100"), &glsl100);
  EXPECT_EQ(findDialect("wgsl"), &wgsl);
  EXPECT_EQ(findDialect("WGSL"), nullptr);
  EXPECT_EQ(findDialect(""), nullptr);
}

TEST_F(DialectTest, NamesTypes) {
  EXPECT_EQ(glsl300.typeName(Type::Float, scalarShape), "float");
  EXPECT_EQ(glsl300.typeName(Type::Bool, scalarShape), "bool");
  EXPECT_EQ(glsl300.typeName(Type::Float, vectorOf(2)), "vec2");
  EXPECT_EQ(glsl300.typeName(Type::Bool, vectorOf(4)), "bvec4");
  EXPECT_EQ(glsl300.typeName(Type::Float, matrixOf(3, 3)), "mat3");
  EXPECT_EQ(glsl300.typeName(Type::Float, matrixOf(2, 3)), "mat2x3") << "columns, then rows";
  EXPECT_EQ(glsl100.typeName(Type::Float, matrixOf(4, 4)), "mat4");
  EXPECT_EQ(glsl100.typeName(Type::Bool, vectorOf(3)), "bvec3");
  EXPECT_EQ(wgsl.typeName(Type::Float, scalarShape), "f32");
  EXPECT_EQ(wgsl.typeName(Type::Bool, scalarShape), "bool");
  EXPECT_EQ(wgsl.typeName(Type::Float, vectorOf(3)), "vec3f");
  EXPECT_EQ(wgsl.typeName(Type::Bool, vectorOf(2)), "vec2<bool>");
  EXPECT_EQ(wgsl.typeName(Type::Float, matrixOf(3, 3)), "mat3x3f");
  EXPECT_EQ(wgsl.typeName(Type::Float, matrixOf(2, 4)), "mat2x4f");
}

TEST_F(DialectTest, WritesDeclarationsTemporariesAndLiterals) {
  const Expression u = sin(x * 2.0);
  const std::string glsl =
      "float y;\n{\n"
      "  float t0 = sin(x * 2.0);\n"
      "  y = t0 * t0 + 1e-5;\n"
      "}\n";
  EXPECT_EQ(code(u * u + 1e-5, 8, glsl300), glsl);
  EXPECT_EQ(code(u * u + 1e-5, 8, glsl100), glsl);
  EXPECT_EQ(code(u * u + 1e-5, 8, wgsl),
            "var y: f32;\n{\n"
            "  let t0 = sin(x * 2.0f);\n"
            "  y = t0 * t0 + 1e-5f;\n"
            "}\n");
}

TEST_F(DialectTest, WgslDeclaresEachResultSeparately) {
  const Value v = variable(graph, "v", vectorOf(2));
  const std::vector<Output> outputs{result("a", v), result("b", v), result("near", lt(x, y))};
  EXPECT_EQ(emit(graph, wgsl, outputs, {}).code,
            "var a: vec2f;\nvar b: vec2f;\nvar near: bool;\n{\n"
            "  near = x < y;\n"
            "  a = v;\n"
            "  b = v;\n"
            "}\n");
  EXPECT_EQ(emit(graph, glsl300, outputs, {}).code,
            "vec2 a, b;\nbool near;\n{\n"
            "  near = x < y;\n"
            "  a = v;\n"
            "  b = v;\n"
            "}\n");
}

TEST_F(DialectTest, ComputesAHostExpressionOnceInWgslToo) {
  const Value p = vector3(graph, "(model * vec4<f32>(p, 1.0)).xyz");
  EXPECT_EQ(code(p[0] + p[1], 8, wgsl),
            "var y: f32;\n{\n"
            "  let t0 = (model * vec4<f32>(p, 1.0)).xyz;\n"
            "  y = t0.x + t0.y;\n"
            "}\n");
}

TEST_F(DialectTest, ConstructsVectorsAndMatricesByTheLanguagesTypes) {
  Value swapped(graph, vectorOf(2)), m(graph, matrixOf(2, 2)), near(graph, vectorOf(2));
  swapped.set(0, y.id);
  swapped.set(1, x.id);
  for (int i = 0; i < 4; ++i) m.set(i, i % 2 == 0 ? x.id : y.id);
  near.set(0, lt(x, y).id);
  near.set(1, lt(y, z).id);
  const std::vector<Output> outputs{result("s", swapped), result("m", m), result("n", near)};
  EXPECT_EQ(emit(graph, wgsl, outputs, {}).code,
            "var s: vec2f;\nvar m: mat2x2f;\nvar n: vec2<bool>;\n{\n"
            "  s = vec2f(y, x);\n"
            "  m = mat2x2f(x, y, x, y);\n"
            "  n = vec2<bool>(x < y, y < z);\n"
            "}\n");
  EXPECT_EQ(emit(graph, glsl100, outputs, {}).code,
            "vec2 s;\nmat2 m;\nbvec2 n;\n{\n"
            "  s = vec2(y, x);\n"
            "  m = mat2(x, y, x, y);\n"
            "  n = bvec2(x < y, y < z);\n"
            "}\n");
}

TEST_F(DialectTest, UsesEachLanguagesFunctionNames) {
  struct Spelled {
    Expression e;
    const char *glsl, *wgsl;
  };
  for (const auto& [e, inGlsl, inWgsl] : std::vector<Spelled>{
           {ifElse(lt(x, y), x, z), "x < y ? x : z", "select(z, x, x < y)"},
           {ifElse(lt(x, y), x, z) * 2.0, "(x < y ? x : z) * 2.0", "select(z, x, x < y) * 2.0f"},
           {atan2(y, x), "atan(y, x)", "atan2(y, x)"},
           {atan(x), "atan(x)", "atan(x)"},
           {inversesqrt(x), "inversesqrt(x)", "inverseSqrt(x)"},
           {row("round", x), "roundEven(x)", "round(x)"},
           {lt(x, y) + 1.0, "float(x < y) + 1.0", "f32(x < y) + 1.0f"},
           {ifElse(x, y, z), "bool(x) ? y : z", "select(z, y, bool(x))"},
           {-(-2.0 / x), "- -2.0 / x", "- -2.0f / x"}}) {
    EXPECT_EQ(body(e, glsl300), inGlsl);
    EXPECT_EQ(body(e, wgsl), inWgsl);
  }
}

// WGSL has no precedence between && and ||, and comparisons can't be chained.
TEST_F(DialectTest, ParenthesizesMixedConditionsInWgsl) {
  const Expression a = lt(x, y), b = gt(y, z), c = eq(x, z);
  EXPECT_EQ(body(logicalOr(logicalAnd(a, b), c), wgsl), "(x < y && y > z) || x == z");
  EXPECT_EQ(body(logicalAnd(a, logicalOr(b, c)), wgsl), "x < y && (y > z || x == z)");
  EXPECT_EQ(body(row("not", logicalAnd(a, b)), wgsl), "!(x < y && y > z)");
  EXPECT_EQ(body(lt(lt(x, y) + 0.0, z), wgsl), "f32(x < y) < z");
}

TEST_F(DialectTest, RejectsReservedWordsOfALanguageAsNames) {
  for (const char* word :
       {"fn",         "let",          "var",        "loop",    "override",    "alias",  "enable",
        "diagnostic", "const_assert", "continuing", "default", "switch",      "struct", "true",
        "self",       "Self",         "NULL",       "await",   "mod",         "ref",    "move",
        "target",     "vec3f",        "mat4x4f",    "f32",     "i32",         "array",  "ptr",
        "atomic",     "sampler",      "select",     "atan2",   "inverseSqrt", "_",      "__x"}) {
    EXPECT_NE(outputProblem(wgsl, word), "") << word;
    EXPECT_NE(inputProblem(wgsl, word), "") << word;
  }
  EXPECT_EQ(outputProblem(wgsl, "fn"), "\"fn\" is a reserved word of WGSL");
  EXPECT_EQ(outputProblem(wgsl, "select"), "\"select\" is a function of WGSL");
  for (const char* word : {"fn", "let", "loop", "select", "atan2", "inverseSqrt", "vec3f", "f32"})
    EXPECT_EQ(outputProblem(glsl300, word), "") << word << " has no meaning in GLSL";
  for (const char* word : {"float", "roundEven", "out", "inversesqrt", "uniform", "sampler2D"}) {
    EXPECT_EQ(outputProblem(wgsl, word), "") << word << " has no meaning in WGSL";
    EXPECT_NE(outputProblem(glsl300, word), "") << word;
  }
  EXPECT_NE(outputProblem(glsl300, "sinh"), "");
  EXPECT_EQ(outputProblem(glsl100, "sinh"), "")
      << "GLSL ES 1.00 has no sinh; it is lowered, and never called";
}

TEST_F(DialectTest, AcceptsExpressionsOfAWgslHost) {
  for (const char* text :
       {"position", "inputs.position.xyz", "vec4<f32>(p, 1.0)", "(u.model * vec4<f32>(p, 1.0)).xyz",
        "vec4f(p, 1.0)", "mat3x3<f32>(a, b, c)[0].x", "f32(index)", "select(a, b, c < d)",
        "u.lights[2].x", "1.5f * x", "a % b", "vertices[i32(index)]", "sin(time)", "x < y"})
    EXPECT_EQ(inputProblem(wgsl, text), "") << text;
}

TEST_F(DialectTest, RejectsExpressionsThatWgslLacks) {
  for (const char* text : {"a ? b : c", "a++", "a--", "x; y", "vec4<f32>", "float<f32>(x", "a ^^ b",
                           "fn(x)", "var", "vec3(x", "f32"})
    EXPECT_NE(inputProblem(wgsl, text), "") << text;
  EXPECT_EQ(inputProblem(glsl300, "a ? b : c"), "");
  EXPECT_EQ(inputProblem(glsl300, "a ^^ b"), "");
  EXPECT_NE(inputProblem(glsl300, "vec4<f32>(p, 1.0)"), "");
}

}  // namespace
}  // namespace warpjet
