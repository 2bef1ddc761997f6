// Emission: which nodes become statements, in which order, and how they are written.
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

  Expression zero() { return {&graph, graph.constant(0)}; }
};

TEST_F(EmitTest, WritesANodeInlineIfItIsUsedOnce) {
  EXPECT_EQ(code(sin(x * 2.0) + y), "float y;\n{\n  y = sin(x * 2.0) + y;\n}\n");
}

TEST_F(EmitTest, WritesASharedNodeAsATemporary) {
  const Expression u = sin(x);
  EXPECT_EQ(code(u * u),
            "float y;\n{\n"
            "  float t0 = sin(x);\n"
            "  y = t0 * t0;\n"
            "}\n");
}

TEST_F(EmitTest, WritesParenthesesOnlyWhereNeeded) {
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
  EXPECT_EQ(body(ifElse(lt(x, y * 2.0), x, y)), "x < y * 2.0 ? x : y");
  EXPECT_EQ(body(ifElse(lt(x, y), x, z) * 2.0), "(x < y ? x : z) * 2.0");
  EXPECT_EQ(body(ifElse(logicalAnd(lt(x, y), logicalOr(lt(y, z), lt(x, z))), x, z)),
            "x < y && (y < z || x < z) ? x : z");
  EXPECT_EQ(body(ifElse(logicalOr(logicalAnd(x, y), z), x, z)),
            "(bool(x) && bool(y)) || bool(z) ? x : z")
      << "WGSL requires the outer parentheses of the condition";
}

// ANGLE compiles choices between other expressions to branches.
TEST_F(EmitTest, ChoosesOnlyBetweenNamesAndNumbers) {
  const auto choose = [&](Expression yes, Expression no) { return ifElse(lt(x, y), yes, no); };
  EXPECT_EQ(code(choose(x, zero())), "float y;\n{\n  y = x < y ? x : 0.0;\n}\n");
  const Expression yes = -x, no = sin(y);
  EXPECT_EQ(code(choose(yes, no) * 2.0),
            "float y;\n{\n"
            "  float t0 = -x;\n"
            "  float t1 = sin(y);\n"
            "  y = (x < y ? t0 : t1) * 2.0;\n"
            "}\n");
  EXPECT_EQ(code(ifElse(lt(x, 1.0), choose(x, y), x)),
            "float y;\n{\n"
            "  float t0 = x < y ? x : y;\n"
            "  y = x < 1.0 ? t0 : x;\n"
            "}\n");
}

TEST_F(EmitTest, LimitsTheDepthOfExpressions) {
  Expression v = x;
  for (int i = 0; i < 4; ++i) v = sin(v);
  EXPECT_EQ(code(v, 2),
            "float y;\n{\n"
            "  float t0 = sin(sin(x));\n"
            "  y = sin(sin(t0));\n"
            "}\n");
}

// The sum and its derivative read the first angles before the others are computed.
TEST_F(EmitTest, KeepsFewValuesAlive) {
  Expression sum = zero(), slope = zero();
  for (int i = 1; i <= 6; ++i) {
    const Expression angle = x * double(i) + y;
    sum = sum + sin(angle);
    slope = slope + cos(angle) * double(i);
  }
  EXPECT_EQ(emit(graph, glsl300, std::vector{result("sum", sum), result("slope", slope)}).code,
            "float sum, slope;\n{\n"
            "  float t0 = x + y;\n"
            "  float t1 = x * 2.0 + y;\n"
            "  float t2 = x * 3.0 + y;\n"
            "  float t3 = x * 4.0 + y;\n"
            "  float t4 = x * 5.0 + y;\n"
            "  float t5 = sin(t0) + sin(t1) + sin(t2) + sin(t3);\n"
            "  float t6 = cos(t0) + cos(t1) * 2.0 + cos(t2) * 3.0 + cos(t3) * 4.0;\n"
            "  float t7 = x * 6.0 + y;\n"
            "  sum = t5 + sin(t4) + sin(t7);\n"
            "  slope = t6 + cos(t4) * 5.0 + cos(t7) * 6.0;\n"
            "}\n");
}

TEST_F(EmitTest, SplitsExpressionsThatReadManyTemporaries) {
  Expression sum = zero();
  for (int i = 0; i < 6; ++i) {
    const Expression wave = sin(x + double(i));
    sum = sum + wave * wave;
  }
  EXPECT_EQ(code(sum),
            "float y;\n{\n"
            "  float t0 = sin(x);\n"
            "  float t1 = sin(x + 1.0);\n"
            "  float t2 = sin(x + 2.0);\n"
            "  float t3 = sin(x + 3.0);\n"
            "  float t4 = t0 * t0 + t1 * t1 + t2 * t2 + t3 * t3;\n"
            "  float t5 = sin(x + 4.0);\n"
            "  float t6 = sin(x + 5.0);\n"
            "  y = t4 + t5 * t5 + t6 * t6;\n"
            "}\n");
}

TEST_F(EmitTest, AssignsAnOutputAsSoonAsThatFreesAValue) {
  const Expression u = sin(x), v = cos(y);
  Value pair(graph, vectorOf(2));
  pair.set(0, (u * 2.0).id);
  pair.set(1, (u * u).id);
  EXPECT_EQ(emit(graph, glsl300, std::vector{result("r", v * v), result("pair", pair)}).code,
            "float r;\nvec2 pair;\n{\n"
            "  float t0 = sin(x);\n"
            "  pair = t0 * vec2(2.0, t0);\n"
            "  float t1 = cos(y);\n"
            "  r = t1 * t1;\n"
            "}\n");
}

TEST_F(EmitTest, TemporariesAvoidNamesInUse) {
  const Expression t0 = scalar(graph, "t0"), u = sin(t0);
  const std::vector<Output> outputs{result("t1", u * u)};
  EXPECT_EQ(emit(graph, glsl300, outputs, {}).code,
            "float t1;\n{\n  float t2 = sin(t0);\n  t1 = t2 * t2;\n}\n");
}

TEST_F(EmitTest, ComputesAHostExpressionOnce) {
  const Value p = vector3(graph, "(uModel * vec4(aPosition, 1.0)).xyz");
  const std::vector<Output> outputs{result("y", p[0] + p[1])};
  EXPECT_EQ(emit(graph, glsl300, outputs, {}).code,
            "float y;\n{\n"
            "  vec3 t0 = (uModel * vec4(aPosition, 1.0)).xyz;\n"
            "  y = t0.x + t0.y;\n"
            "}\n");
}

TEST_F(EmitTest, WritesVectorsInTheShortestForm) {
  const Value p = vector3(graph, "position");
  const Value zero = constantLike(p, 0);
  Value none(graph, vectorOf(3)), swapped = p;
  for (int i = 0; i < 3; ++i) none.set(i, zero[0].id);
  swapped.set(0, p[1].id);
  swapped.set(1, p[0].id);
  const std::vector<Output> outputs{result("whole", p), result("none", none),
                                    result("swapped", swapped), result("flag", lt(x, y))};
  EXPECT_EQ(emit(graph, glsl300, outputs, {}).code,
            "vec3 whole, none, swapped;\nbool flag;\n{\n"
            "  flag = x < y;\n"
            "  whole = position;\n"
            "  none = vec3(0.0);\n"
            "  swapped = position.yxz;\n"
            "}\n");
}

// mat2(1.0) is the unit matrix, so equal components cannot be written as one number.
TEST_F(EmitTest, WritesMatricesInColumnMajorOrder) {
  const Value m = variable(graph, "m", matrixOf(2, 3));
  Value ones(graph, matrixOf(2, 2)), lastRow(graph, vectorOf(2));
  for (int i = 0; i < 4; ++i) ones.set(i, graph.constant(1));
  lastRow.set(0, m.at(0, 2).id);
  lastRow.set(1, m.at(1, 2).id);
  const std::vector<Output> outputs{result("same", m), result("ones", ones),
                                    result("lastRow", lastRow)};
  EXPECT_EQ(emit(graph, glsl300, outputs, {}).code,
            "mat2x3 same;\nmat2 ones;\nvec2 lastRow;\n{\n"
            "  same = m;\n"
            "  ones = mat2(1.0, 1.0, 1.0, 1.0);\n"
            "  lastRow = vec2(m[0].z, m[1].z);\n"
            "}\n");
}

TEST_F(EmitTest, WritesAnInputAsAWholeOnlyInItsOwnShape) {
  const Value m = variable(graph, "m", matrixOf(2, 2));
  Value v(graph, vectorOf(4)), transposed(graph, matrixOf(2, 2));
  for (int i = 0; i < 4; ++i) v.set(i, m[i].id);
  for (int i = 0; i < 4; ++i) transposed.set(i, m.at(i % 2, i / 2).id);
  const std::vector<Output> outputs{result("v", v), result("transposed", transposed)};
  EXPECT_EQ(emit(graph, glsl300, outputs, {}).code,
            "vec4 v;\nmat2 transposed;\n{\n"
            "  v = vec4(m[0], m[1]);\n"
            "  transposed = mat2(m[0].x, m[1].x, m[0].y, m[1].y);\n"
            "}\n");
}

TEST_F(EmitTest, ReusesAnEarlierResultInASumWithAnInput) {
  const Value p = vector3(graph, "position"), offset = p * 2.0;
  const std::vector<Output> outputs{result("offset", offset), result("moved", p + offset)};
  EXPECT_EQ(emit(graph, glsl300, outputs, {}).code,
            "vec3 offset, moved;\n{\n"
            "  offset = position * 2.0;\n"
            "  moved = position + offset;\n"
            "}\n");
}

TEST_F(EmitTest, CallsAHostFunctionWithItsArgumentsInOrder) {
  const std::uint32_t noise = graph.addFunction({"noise", 3}),
                      unused = graph.addFunction({"other", 1});
  const NodeId arguments[] = {(x + y).id, ifElse(lt(x, y), x, 1.0).id, lt(x, y).id};
  const Expression called{&graph, graph.call(noise, arguments)};
  EXPECT_EQ(body(-(called * 2.0)), "-noise(x + y, t0 ? x : 1.0, float(t0)) * 2.0");
  const std::vector<Output> outputs{result("y", called)};
  const EmittedCode emitted = emit(graph, glsl300, outputs, {});
  EXPECT_EQ(emitted.functions, std::vector<std::uint32_t>{noise}) << unused << " is not called";
  EXPECT_EQ(emitted.operations, 5u)
      << "x + y, x < y, the choice, float and the call, but not the list of arguments";
}

TEST_F(EmitTest, MakesACallOnceIfItIsUsedTwice) {
  const std::uint32_t noise = graph.addFunction({"noise", 2});
  const NodeId arguments[] = {x.id, y.id};
  const Expression called{&graph, graph.call(noise, arguments)};
  EXPECT_EQ(code(called * called),
            "float y;\n{\n"
            "  float t0 = noise(x, y);\n"
            "  y = t0 * t0;\n"
            "}\n");
}

TEST_F(EmitTest, WritesACommentAboveTheStatementsOfItsNodes) {
  const auto nodes = [&] { return NodeId{static_cast<std::uint32_t>(graph.size())}; };
  Comments comments{{"u", "the sum"}, {}};
  const NodeId start = nodes();
  const Expression u = sin(x);
  comments.ranges.push_back({start, nodes(), 0});
  const Expression v = cos(y);
  const NodeId middle = nodes();
  const Expression sum = u * u + v * v;
  comments.ranges.push_back({middle, nodes(), 1});
  EXPECT_EQ(emit(graph, glsl300, std::vector{result("r", sum)}, {}, comments).code,
            "float r;\n{\n"
            "  // u\n"
            "  float t0 = sin(x);\n"
            "  float t1 = cos(y);\n"
            "  // the sum\n"
            "  r = t0 * t0 + t1 * t1;\n"
            "}\n");
}

TEST_F(EmitTest, WritesNothingWithoutResults) { EXPECT_EQ(emit(graph, glsl300, {}, {}).code, ""); }

TEST_F(EmitTest, CountsOnlyWhatTheResultsNeed) {
  sin(y);
  const std::vector<Output> outputs{result("r", sin(x) * sin(x))};
  const EmittedCode emitted = emit(graph, glsl300, outputs, {});
  EXPECT_EQ(emitted.nodes, 3u);
  EXPECT_EQ(emitted.operations, 2u);
  EXPECT_EQ(emitted.temporaries, 1u);
  EXPECT_EQ(emitted.inputs, std::vector<std::uint32_t>{0}) << "y is not read";
}

TEST_F(EmitTest, LimitsTheDepthOfNestedCalls) {
  const std::uint32_t noise = graph.addFunction({"noise", 2});
  Expression v = x;
  for (int i = 0; i < 9; ++i) {
    const NodeId arguments[] = {v.id, y.id};
    v = {&graph, graph.call(noise, arguments)};
  }
  EXPECT_EQ(code(v, 4),
            "float y;\n{\n"
            "  float t0 = noise(noise(noise(noise(x, y), y), y), y);\n"
            "  float t1 = noise(noise(noise(noise(t0, y), y), y), y);\n"
            "  y = noise(t1, y);\n"
            "}\n");
}

TEST_F(EmitTest, EmitsASumOfManyTemporariesInLittleMemory) {
  Expression sum = zero();
  for (int i = 1; i <= 20'000; ++i) {
    const Expression wave = sin(x * double(i));
    sum = sum + wave * wave;
  }
  EmitOptions options;
  options.maxDepth = 1 << 30;
  options.maxReads = EmitOptions::maxTrackedReads;
  EXPECT_EQ(emit(graph, glsl300, std::vector{result("r", sum)}, options).temporaries, 20'317u);
}

TEST_F(EmitTest, SplitsALongChainIntoShortStatements) {
  Expression v = x;
  for (int i = 0; i < 100'000; ++i) v = sin(v);
  const std::vector<Output> outputs{result("r", v)};
  EXPECT_EQ(emit(graph, glsl300, outputs, {}).temporaries, 12'499u);
}

// The sum is recognized however the graph simplified it.
TEST_F(EmitTest, RecognizesAnInputPlusAnEarlierResultInSimplifiedSums) {
  const Value p = vector3(graph, "p"), q = vector3(graph, "q");
  const auto vec3 = [&](Expression a, Expression b, Expression c) {
    const Expression all[] = {a, b, c};
    return fill(graph, vectorOf(3), [&](int i) { return all[i]; });
  };
  const auto constant = [&](double value) { return Expression{&graph, graph.constant(value)}; };
  const auto assigned = [&](const Value& offset, const Value& moved) {
    const std::string text =
        emit(graph, glsl300, std::vector{result("offset", offset), result("moved", moved)}).code;
    const std::size_t start = text.find("moved = ") + 8;
    return text.substr(start, text.find(';', start) - start);
  };
  for (const Value& offset :
       {vec3(x, sin(x), q[0]), vec3(-x, constant(0), x), vec3(constant(-2), constant(3), -p[0]),
        vec3(p[2], p[1] * x - x, -sin(x))}) {
    EXPECT_EQ(assigned(offset, p + offset), "p + offset");
    EXPECT_EQ(assigned(offset, offset + p), "p + offset");
  }
  EXPECT_NE(assigned(q * x, p + q), "p + offset");
  EXPECT_NE(assigned(vec3(x, x, x), vec3(p[0] + x, p[2] + x, p[1] + x)), "p + offset");
  EXPECT_EQ(assigned(constantLike(p, 0), p), "p") << "nothing is added";
}

}  // namespace
}  // namespace warpjet
