#include "emit/emit.hpp"

#include <gtest/gtest.h>

#include "support.hpp"

namespace warpjet {
namespace {

class EmitTest : public testing::Test {
 protected:
  Graph graph;
  Expression x = scalar(graph, "x");
  Expression y = scalar(graph, "y");
};

TEST_F(EmitTest, ANodeUsedOnceIsWrittenInPlace) {
  EXPECT_EQ(code(sin(x * 2.0) + y), "float y;\n{\n  y = sin(x * 2.0) + y;\n}\n");
}

TEST_F(EmitTest, ASharedNodeIsATemporary) {
  const Expression u = sin(x);
  EXPECT_EQ(code(u * u),
            "float y;\n{\n"
            "  float t0 = sin(x);\n"
            "  y = t0 * t0;\n"
            "}\n");
}

TEST_F(EmitTest, ParenthesesStandOnlyWhereTheyMatter) {
  const auto body = [](Expression e) {
    const std::string text = code(e);
    const std::size_t start = text.find("y = ") + 4;
    return text.substr(start, text.find(';', start) - start);
  };
  const Expression z = scalar(graph, "z");
  EXPECT_EQ(body((x + y) + z), "x + y + z");
  EXPECT_EQ(body((x - y) - z), "x - y - z");
  EXPECT_EQ(body(z - (x - y)), "z - (x - y)");
  EXPECT_EQ(body((x + y) * z), "(x + y) * z");
  EXPECT_EQ(body((x * y) / z), "x * y / z");
  EXPECT_EQ(body(z / (x * y)), "z / (x * y)");
  EXPECT_EQ(body(-(x * y)), "-x * y");
  EXPECT_EQ(body(-(x + y)), "-(x + y)");
  EXPECT_EQ(body(x + (y + z)), "x + (y + z)");
  EXPECT_EQ(body(-(-2.0 / x)), "- -2.0 / x");
  EXPECT_EQ(body(x * -2.0), "x * -2.0");
  EXPECT_EQ(body(ifElse(lt(x, y), x, y * 2.0)), "x < y ? x : y * 2.0");
  EXPECT_EQ(body(ifElse(lt(x, y), x, z) * 2.0), "(x < y ? x : z) * 2.0");
  EXPECT_EQ(body(ifElse(logicalAnd(lt(x, y), logicalOr(lt(y, z), lt(x, z))), x, z)),
            "x < y && (y < z || x < z) ? x : z");
}

TEST_F(EmitTest, TheDepthOfAnExpressionIsBounded) {
  Expression v = x;
  for (int i = 0; i < 4; ++i) v = sin(v);
  EXPECT_EQ(code(v, 2),
            "float y;\n{\n"
            "  float t0 = sin(sin(x));\n"
            "  y = sin(sin(t0));\n"
            "}\n");
}

TEST_F(EmitTest, ADerivativeFollowsItsValue) {
  Differentiator differentiator(graph);
  const Expression u = sin(x);
  const Expression v = sin(u * 2.0);
  const Expression slope{&graph, differentiator.derivative(v.id, x.id)};
  EXPECT_EQ(code(v * slope, 1),
            "float y;\n{\n"
            "  float t0 = sin(x);\n"
            "  float t1 = cos(x);\n"
            "  float t2 = t0 * 2.0;\n"
            "  float t3 = t1 * 2.0;\n"
            "  float t4 = sin(t2);\n"
            "  float t5 = cos(t2);\n"
            "  float t6 = t5 * t3;\n"
            "  y = t4 * t6;\n"
            "}\n");
}

TEST_F(EmitTest, TemporariesAvoidTheNamesInUse) {
  const Expression t0 = scalar(graph, "t0"), u = sin(t0);
  const std::vector<Output> outputs{{"t1", {(u * u).id}}};
  EXPECT_EQ(emit(graph, outputs, {}).code,
            "float t1;\n{\n  float t2 = sin(t0);\n  t1 = t2 * t2;\n}\n");
}

TEST_F(EmitTest, AnExpressionOfTheHostIsComputedOnce) {
  const auto p = vector3(graph, "(uModel * vec4(aPosition, 1.0)).xyz");
  const std::vector<Output> outputs{{"y", {(p[0] + p[1]).id}}};
  EXPECT_EQ(emit(graph, outputs, {}).code,
            "float y;\n{\n"
            "  vec3 t0 = (uModel * vec4(aPosition, 1.0)).xyz;\n"
            "  y = t0.x + t0.y;\n"
            "}\n");
}

TEST_F(EmitTest, VectorsAreWrittenShort) {
  const auto p = vector3(graph, "position");
  const NodeId zero = graph.constant(0);
  const std::vector<Output> outputs{{"whole", {p[0].id, p[1].id, p[2].id}},
                                    {"none", {zero, zero, zero}},
                                    {"turned", {p[1].id, p[0].id, p[2].id}},
                                    {"flag", {lt(x, y).id}}};
  EXPECT_EQ(emit(graph, outputs, {}).code,
            "vec3 whole, none, turned;\nbool flag;\n{\n"
            "  flag = x < y;\n"
            "  whole = position;\n"
            "  none = vec3(0.0);\n"
            "  turned = vec3(position.y, position.x, position.z);\n"
            "}\n");
}

TEST_F(EmitTest, CountsWhatTheResultsNeed) {
  sin(y);
  const std::vector<Output> outputs{{"r", {(sin(x) * sin(x)).id}}};
  const Emitted emitted = emit(graph, outputs, {});
  EXPECT_EQ(emitted.nodes, 3u);
  EXPECT_EQ(emitted.operations, 2u);
  EXPECT_EQ(emitted.temporaries, 1u);
  EXPECT_EQ(emitted.inputs, std::vector<std::uint32_t>{0}) << "y is not read";
}

TEST_F(EmitTest, ALongChainIsManyShortStatements) {
  Expression v = x;
  for (int i = 0; i < 100'000; ++i) v = sin(v);
  const std::vector<Output> outputs{{"r", {v.id}}};
  EXPECT_EQ(emit(graph, outputs, {}).temporaries, 12'499u);
}

}  // namespace
}  // namespace warpjet
