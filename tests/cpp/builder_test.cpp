// The code that the builder generates from the calls of a sketch.
#include "builder/builder.hpp"

#include <gtest/gtest.h>

#include "bench.hpp"
#include "eval/program.hpp"

namespace warpjet {
namespace {

class BuilderTest : public testing::Test, protected Bench {};

TEST_F(BuilderTest, ChainedOperationsApplyFromLeftToRight) {
  const int a = input("a"), b = input("b");
  EXPECT_EQ(text(call("sub", {x, a, b})), "x - a - b");
  EXPECT_EQ(text(call("max", {x})), "x");
  EXPECT_EQ(text(method("div", {x, x, a})), "x / x / a");
}

TEST_F(BuilderTest, AtanWithTwoOperandsIsTheAngleOfAPoint) {
  EXPECT_EQ(text(call("atan", {x, input("a")})), "atan(x, a)");
  EXPECT_EQ(text(call("atan", {x})), "atan(x)");
  Bench modern(wgsl);
  EXPECT_EQ(modern.text(modern.method("atan", {modern.x, modern.input("a")})), "atan2(x, a)");
}

TEST_F(BuilderTest, ANumberAppliesToEachComponent) {
  EXPECT_EQ(text(call("min", {v2, number(1)})), "min(v2, 1.0)");
  const int doubled = call("mult", {number(2), m2});
  EXPECT_EQ(builder.shape(doubled), matrixOf(2, 2));
  EXPECT_EQ(text(doubled), "mat2(m2[0].x * 2.0, m2[0].y * 2.0, m2[1].x * 2.0, m2[1].y * 2.0)");
}

TEST_F(BuilderTest, MatrixProductsHaveTheShapesOfLinearAlgebra) {
  const auto shape = [&](int a, int b) { return builder.shape(call("mult", {a, b})); };
  EXPECT_EQ(shape(m23, v2), vectorOf(3));
  EXPECT_EQ(shape(v3, m23), vectorOf(2));
  EXPECT_EQ(shape(m3, m23), matrixOf(2, 3));
  EXPECT_EQ(shape(m23, x), matrixOf(2, 3));
  EXPECT_EQ(text(call("mult", {v2, m2})),
            "vec2(m2[0].x, m2[1].x) * v2.x + vec2(m2[0].y, m2[1].y) * v2.y");
}

TEST_F(BuilderTest, BuildsVectorsFromParts) {
  EXPECT_EQ(text(call("vec3", {v2, x})), "vec3(v2, x)");
  EXPECT_EQ(text(call("vec3", {x})), "vec3(x)");
  EXPECT_EQ(text(call("vec2", {call("lt", {v2, x})})), "vec2(float(v2.x < x), float(v2.y < x))");
  EXPECT_EQ(text(builder.swizzle(v3, 2, 0b00'10)), "v3.zx");
}

TEST_F(BuilderTest, BuildsMatricesFromColumnsOrRows) {
  const int w2 = input("w2", vectorOf(2));
  EXPECT_EQ(text(call("mat2", {v2, w2})), "mat2(v2.x, v2.y, w2.x, w2.y)");
  EXPECT_EQ(text(call("mat2Rows", {v2, w2})), "mat2(v2.x, w2.x, v2.y, w2.y)");
  EXPECT_EQ(text(call("mat2", {x})), "mat2(x, 0.0, 0.0, x)");
  EXPECT_EQ(text(call("mat2Rows", {number(1), number(2), number(3), number(4)})),
            "mat2(1.0, 3.0, 2.0, 4.0)");
}

TEST_F(BuilderTest, TruncatesOrPadsAMatrixOfAnotherSize) {
  EXPECT_EQ(text(call("mat2", {m3})), "mat2(m3[0].x, m3[0].y, m3[1].x, m3[1].y)");
  EXPECT_EQ(text(call("mat3", {m2})),
            "mat3(m2[0].x, m2[0].y, 0.0, m2[1].x, m2[1].y, 0.0, 0.0, 0.0, 1.0)");
}

TEST_F(BuilderTest, ReadsColumnsAndRowsOfAMatrix) {
  EXPECT_EQ(text(method("column", {m23, number(1)})), "m23[1]");
  EXPECT_EQ(text(method("row", {m23, number(2)})), "vec2(m23[0].z, m23[1].z)");
}

TEST_F(BuilderTest, APartOfAVectorReadsTheComponentsOfThatVector) {
  input("position", vectorOf(3));
  const auto inputs = builder.graph().inputCount();
  EXPECT_EQ(text(input("position.y")), "position.y");
  EXPECT_EQ(text(input("position.b")), "position.z");
  EXPECT_EQ(text(input("position.s")), "position.x");
  EXPECT_EQ(text(input("position[2]")), "position.z");
  EXPECT_EQ(text(input("position.zx", vectorOf(2))), "position.zx");
  EXPECT_EQ(text(input("position.yy", vectorOf(2))), "vec2(position.y)");
  EXPECT_EQ(builder.graph().inputCount(), inputs) << "no label added an input";
}

TEST_F(BuilderTest, DerivativesTreatAPartAndItsVectorAsTheSameVariable) {
  const int position = input("position", vectorOf(3)), y = input("position.y");
  const int slope = call("derivative", {call("dot", {position, position}), y});
  EXPECT_EQ(text(slope), "position.y * 2.0");
}

TEST_F(BuilderTest, ANameThatIsNotPartOfAVectorIsASeparateInput) {
  for (const auto& [label, shape] :
       std::vector<std::pair<const char*, Shape>>{{"v2.z", scalarShape},
                                                  {"v2[2]", scalarShape},
                                                  {"v2.xg", vectorOf(2)},
                                                  {"v2.x.y", scalarShape},
                                                  {"v2.xy", scalarShape},
                                                  {"v22.x", scalarShape},
                                                  {"x.x", scalarShape}}) {
    const int separate = input(label, shape);
    ASSERT_GE(separate, 0) << label;
    builder.output("gen", "r" + std::to_string(separate), separate);
  }
  EXPECT_EQ(writeResults().text->emitted.inputs.size(), 7u);
}

TEST_F(BuilderTest, ReturnsTheSameInputForTheSameName) {
  const int again = input("v3", vectorOf(3));
  const int difference = call("sub", {again, v3});
  EXPECT_EQ(text(difference), "vec3(0.0)");
}

TEST_F(BuilderTest, ConvertsBetweenConditionsAndNumbers) {
  const int less = call("lt", {x, number(1)});
  EXPECT_EQ(text(call("ifElse", {less, v2, number(0)})), "x < 1.0 ? v2 : vec2(0.0)");
}

TEST_F(BuilderTest, ReturnsResultsOfAllShapes) {
  builder.output("gen", "moved", v3);
  builder.output("gen", "jacobian", call("jacobian", {v3, v2}));
  builder.output("gen", "near", call("lt", {x, number(1)}));
  EXPECT_EQ(code(),
            "vec3 moved;\nmat2x3 jacobian;\nbool near;\n{\n"
            "  near = x < 1.0;\n"
            "  moved = v3;\n"
            "  jacobian = mat2x3(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\n"
            "}\n");
}

TEST_F(BuilderTest, ASumReadsAnEarlierResult) {
  const int offset = call("mult", {v2, x});
  const int moved = call("add", {v2, offset});
  builder.output("warp", "offset", offset);
  builder.output("warp", "moved", moved);
  EXPECT_EQ(code(),
            "vec2 offset, moved;\n{\n"
            "  offset = v2 * x;\n"
            "  moved = v2 + offset;\n"
            "}\n");
}

TEST_F(BuilderTest, LowersOperationsThatALanguageLacks) {
  const auto codeIn = [](const Dialect& dialect) {
    Bench bench(dialect);
    bench.builder.output("gen", "y", bench.call("trunc", {bench.x}));
    return bench.code();
  };
  EXPECT_EQ(codeIn(glsl100), "float y;\n{\n  y = sign(x) * floor(abs(x));\n}\n");
  EXPECT_EQ(codeIn(glsl300), "float y;\n{\n  y = trunc(x);\n}\n");
}

TEST_F(BuilderTest, WritesCommentsAboveStatements) {
  builder.comment("inputs");
  const int u = call("sin", {x});
  builder.comment("let u = sin(x)");
  builder.output("gen", "y", call("mult", {u, u}));
  builder.comment("return u * u");
  EXPECT_EQ(code(),
            "float y;\n{\n"
            "  // let u = sin(x)\n"
            "  float t0 = sin(x);\n"
            "  // return u * u\n"
            "  y = t0 * t0;\n"
            "}\n");
}

// trunc is lowered in GLSL ES 1.00, so the product is rebuilt.
TEST_F(BuilderTest, WritesCommentsAboveLoweredStatements) {
  Bench old(glsl100);
  old.builder.comment("inputs");
  const int u = old.call("trunc", {old.x});
  old.builder.comment("let u = trunc(x)");
  old.builder.output("gen", "y", old.call("mult", {u, u}));
  old.builder.comment("return u * u");
  EXPECT_EQ(old.code(),
            "float y;\n{\n"
            "  // let u = trunc(x)\n"
            "  float t0 = sign(x) * floor(abs(x));\n"
            "  // return u * u\n"
            "  y = t0 * t0;\n"
            "}\n");
}

TEST_F(BuilderTest, TwentyThousandHandlesStayValid) {
  std::vector<int> handles;
  for (int i = 0; i < 20'000; ++i)
    handles.push_back(call("add", {i % 2 == 0 ? x : m3, number(i + 1)}));
  for (int i = 0; i < 20'000; ++i)
    ASSERT_EQ(builder.shape(handles[i]), i % 2 == 0 ? scalarShape : matrixOf(3, 3)) << i;
  EXPECT_EQ(text(handles[0]), "x + 1.0");
  EXPECT_EQ(text(handles[19'998]), "x + 19999.0");
  EXPECT_EQ(text(method("row", {handles[1], number(0)})), "vec3(m3[0].x, m3[1].x, m3[2].x) + 2.0");
  EXPECT_EQ(text(method("row", {handles[19'999], number(0)})),
            "vec3(m3[0].x, m3[1].x, m3[2].x) + 20000.0");
}

TEST_F(BuilderTest, MakesAProgramOfTheResults) {
  builder.output("gen", "a", call("mult", {v2, number(3)}));
  builder.output("gen", "b", call("trunc", {x}));
  const std::uint32_t both[] = {0, 1};
  const auto program = warpjet::program(builder.module(), both).program;
  ASSERT_TRUE(program);
  // The numbers of all inputs: x, v2, and those that are not read.
  std::vector<double> numbers(1 + 2 + 3 + 4 + 4 + 9 + 6), results(3);
  numbers[0] = -2.5;
  numbers[1] = 10;
  numbers[2] = 20;
  evaluate(program->words, program->instructions, numbers, results);
  EXPECT_EQ(results, (std::vector<double>{30, 60, -2}));
}

}  // namespace
}  // namespace warpjet
