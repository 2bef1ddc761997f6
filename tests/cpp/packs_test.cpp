// Packs: operations on components become one statement on vectors if that is shorter, and only
// then. The expected code is what a person would write.
#include "emit/packs.hpp"

#include <gtest/gtest.h>

#include "algebra/vectors.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

class PacksTest : public testing::Test {
 protected:
  Graph graph;
  Value p = vector3(graph, "p");
  Expression x = scalar(graph, "x");

  Value vec3(Expression a, Expression b, Expression c) {
    const Expression all[] = {a, b, c};
    return fill(graph, vectorOf(3), [&](int i) { return all[i]; });
  }
  template <class Each>
  Value each(Each formula) {
    return fill(graph, vectorOf(3), [&](int i) { return formula(i); });
  }
  Expression number(double value) { return {&graph, graph.constant(value)}; }

  // Returns the statements that compute the result `y`.
  std::string text(const Value& y, const Dialect& dialect = glsl300) {
    const std::string all = emit(graph, dialect, std::vector{result("y", y)}).code;
    const std::size_t start = all.find("{\n") + 2;
    return all.substr(start, all.rfind("}\n") - start);
  }
};

TEST_F(PacksTest, WritesAResultAsAVector) {
  EXPECT_EQ(text(each([&](int i) { return sin(p[i] * 2.0) + x; })), "  y = sin(p * 2.0) + x;\n");
}

TEST_F(PacksTest, UsesSwizzlesForReorderedComponents) {
  EXPECT_EQ(text(vec3(sin(p[2]), sin(p[0]), sin(p[1]))), "  y = sin(p.zxy);\n");
}

TEST_F(PacksTest, AComponentMayOccurTwice) {
  EXPECT_EQ(text(vec3(sin(p[2]), sin(p[0]), sin(p[0]) * 1.0)),
            "  float t0 = sin(p.x);\n  y = vec3(sin(p.z), t0, t0);\n");
  EXPECT_EQ(text(vec3(p[1] * 2.0, p[0] * 3.0, p[0] * 4.0)), "  y = p.yxx * vec3(2.0, 3.0, 4.0);\n");
}

TEST_F(PacksTest, CombinesConstantsToAVector) {
  const double factors[] = {2, 3, 4};
  EXPECT_EQ(text(each([&](int i) { return sin(p[i] * factors[i]); })),
            "  y = sin(p * vec3(2.0, 3.0, 4.0));\n");
}

TEST_F(PacksTest, WritesDifferentOperationsPerComponent) {
  EXPECT_EQ(text(vec3(sin(p[0]), cos(p[1]), number(0))), "  y = vec3(sin(p.x), cos(p.y), 0.0);\n");
}

TEST_F(PacksTest, TemporariesCanBeVectors) {
  const Value u = each([&](int i) { return sin(p[i] * x); });
  EXPECT_EQ(text(u * u),
            "  vec3 t0 = sin(p * x);\n"
            "  y = t0 * t0;\n");
}

TEST_F(PacksTest, ReadsSingleComponentsOfAVector) {
  const Value u = each([&](int i) { return sin(p[i] * x); });
  EXPECT_EQ(text(each([&](int i) { return u[i] * u[i] + cos(u[0]); })),
            "  vec3 t0 = sin(p * x);\n"
            "  float t1 = cos(t0.x);\n"
            "  y = t0 * t0 + t1;\n");
}

// `mixed` has no vector result, so the vectors of cosines are found only from the vector of angles.
TEST_F(PacksTest, FurtherOperationsOnAVectorAreVectorsToo) {
  const Value angle = each([&](int i) { return p[i] * 3.0 + x; });
  const Value slope = each([&](int i) { return cos(angle[i]) * 5.0; });
  const Expression mixed = slope[0] * slope[1] - slope[2] * slope[0] / slope[1] * slope[2];
  const std::string all =
      emit(graph, glsl300,
           std::vector{result("y", each([&](int i) { return sin(angle[i]); })), result("m", mixed)})
          .code;
  EXPECT_NE(all.find("vec3 t1 = cos(t0) * 5.0;\n"), all.npos) << all;
}

// Besides two vectors, min and max take a vector and a number in GLSL, in this order; not in WGSL.
TEST_F(PacksTest, CombinesVectorsWithNumbersIfTheLanguageAllowsIt) {
  const Value smaller = each([&](int i) { return min(sin(p[i]), x); });
  EXPECT_EQ(text(smaller), "  y = min(sin(p), x);\n");
  EXPECT_EQ(text(smaller, wgsl), "  y = min(sin(p), vec3f(x));\n");
  EXPECT_EQ(text(each([&](int i) { return min(x, sin(p[i])); })), "  y = min(vec3(x), sin(p));\n");
  EXPECT_EQ(text(each([&](int i) { return pow(p[i], x); })), "  y = pow(p, vec3(x));\n");
  EXPECT_EQ(text(each([&](int i) { return x / p[i]; }), wgsl), "  y = x / p;\n");
}

TEST_F(PacksTest, ASharedConditionChoosesBetweenVectors) {
  const Value chosen = each([&](int i) { return ifElse(lt(x, 1.0), p[i], 0.0); });
  EXPECT_EQ(text(chosen), "  y = x < 1.0 ? p : vec3(0.0);\n");
  EXPECT_EQ(text(chosen, wgsl), "  y = select(vec3f(0.0f), p, x < 1.0f);\n");
}

TEST_F(PacksTest, AConditionPerComponentChoosesBetweenNumbers) {
  const std::string all = text(each([&](int i) { return ifElse(lt(p[i], 1.0), p[i], x); }));
  EXPECT_EQ(all, "  y = vec3(p.x < 1.0 ? p.x : x, p.y < 1.0 ? p.y : x, p.z < 1.0 ? p.z : x);\n");
}

// A scalar that one statement reads once is written inline; one that is read again has a name.
TEST_F(PacksTest, WritesANumberInlineIfOneStatementReadsItOnce) {
  const Expression scale = ifElse(gt(x, 0.0), x, 0.5);
  EXPECT_EQ(text(p * scale), "  y = p * (x > 0.0 ? x : 0.5);\n");
  EXPECT_EQ(text(vec3(p[0] * scale, p[1] * scale, scale)),
            "  float t0 = x > 0.0 ? x : 0.5;\n"
            "  y = vec3(p.x * t0, p.y * t0, t0);\n");
  EXPECT_EQ(text(each([&](int i) { return sin(p[i] * scale) * scale; })),
            "  float t0 = x > 0.0 ? x : 0.5;\n"
            "  y = sin(p * t0) * t0;\n");
  const auto mixed = [&](int i) {
    return Expression{&graph, graph.apply(ops::find("mix"), {p[i].id, scale.id, scale.id})};
  };
  EXPECT_EQ(text(each(mixed)),
            "  float t0 = x > 0.0 ? x : 0.5;\n"
            "  y = mix(p, vec3(t0), t0);\n");
  const Value shifted = each([&](int i) { return p[i] + scale; });
  const std::string both =
      emit(graph, glsl300, std::vector{result("y", p * scale), result("z", shifted)}).code;
  EXPECT_NE(both.find("  y = p * t0;\n"), std::string::npos) << both;
}

TEST_F(PacksTest, NamesADeeplyNestedNumberBesideAVector) {
  Expression scale = x;
  for (int i = 0; i < 3; ++i) scale = sin(scale);
  EXPECT_EQ(text(p * scale), "  y = p * sin(sin(sin(x)));\n");
  EXPECT_EQ(text(p * sin(scale)),
            "  float t0 = sin(sin(sin(sin(x))));\n"
            "  y = p * t0;\n");
}

// A rotation is written as a person would write it. A matrix is listed column by column.
TEST_F(PacksTest, WritesARotationAsAMatrixProduct) {
  const Expression u = x * 2.0, s = sin(u), c = cos(u);
  const auto rotate = [&](Expression a, Expression b) {
    return std::array{a * c - b * s, a * s + c * b};
  };
  const auto once = rotate(p[0], p[1]), twice = rotate(once[0], once[1]);
  const Value y = vec3(twice[0] * twice[0], twice[1] * twice[1], number(1));
  EXPECT_EQ(text(y),
            "  float t0 = x * 2.0;\n"
            "  float t1 = sin(t0);\n"
            "  float t2 = cos(t0);\n"
            "  mat2 t3 = mat2(t2, t1, -t1, t2);\n"
            "  vec2 t4 = t3 * p.xy;\n"
            "  vec2 t5 = t3 * t4;\n"
            "  y = vec3(t5.x * t5.x, t5.y * t5.y, 1.0);\n")
      << "a matrix that two statements read has a name";
  EXPECT_NE(text(y, wgsl).find("  let t3 = mat2x2f(t2, t1, -t1, t2);\n"), std::string::npos);
  EXPECT_NE(text(vec3(once[0] * once[0], once[1] * once[1], number(1)))
                .find("  vec2 t3 = mat2(t2, t1, -t1, t2) * p.xy;\n"),
            std::string::npos);
}

TEST_F(PacksTest, RecognizesDotProducts) {
  const Value q = vector3(graph, "q");
  EXPECT_EQ(text(dot(p, q)), "  y = dot(p, q);\n");
  EXPECT_EQ(text(x / dot(p, q), wgsl), "  y = x / dot(p, q);\n");
  EXPECT_EQ(text(q[2] * p[2] + p[0] * q[0]), "  y = dot(p.zx, q.zx);\n")
      << "factors in either order";
  const Value u = each([&](int i) { return sin(p[i] * x); });
  EXPECT_EQ(text(u * inversesqrt(dot(u, u))),
            "  vec3 t0 = sin(p * x);\n"
            "  float t1 = inversesqrt(dot(t0, t0));\n"
            "  y = t0 * t1;\n");
  EXPECT_EQ(text(p[0] * q[1] + p[1] * q[0]), "  y = p.x * q.y + p.y * q.x;\n");
  EXPECT_EQ(text(p[0] * p[0] + p[0] * p[0] * x), "  float t0 = p.x * p.x;\n  y = t0 + t0 * x;\n");
}

TEST_F(PacksTest, RecognizesCrossProducts) {
  const Value q = vector3(graph, "q");
  EXPECT_EQ(text(cross(p, q)), "  y = cross(p, q);\n");
  EXPECT_EQ(text(cross(q, p) * x, wgsl), "  y = cross(q, p) * x;\n");
  // These differ from a cross product by one sign, or by one component.
  EXPECT_EQ(
      text(vec3(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[1] * q[0] - p[0] * q[1])),
      "  y = p.yzy * q.zxx - p.zxx * q.yzy;\n");
  EXPECT_EQ(
      text(vec3(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[1])),
      "  y = p.yzx * q.zxy - p.zxy * q.yzy;\n");
}

TEST_F(PacksTest, WritesAdjacentComponentsOfAVectorAsASwizzle) {
  EXPECT_EQ(text(vec3(p[0], p[1], x)), "  y = vec3(p.xy, x);\n");
  EXPECT_EQ(text(vec3(x, p[2], p[1]), wgsl), "  y = vec3f(x, p.zy);\n");
}

TEST_F(PacksTest, WritesPairsAsVec2) {
  const Value pair =
      fill(graph, vectorOf(2), [&](int i) { return sin((i == 0 ? p[0] : p[2]) * x); });
  EXPECT_EQ(text(pair * pair), "  vec2 t0 = sin(p.xz * x);\n  y = t0 * t0;\n");
}

TEST_F(PacksTest, SimplifiesSumsOfSquaredSineAndCosine) {
  const Expression c = cos(x), s = sin(x);
  EXPECT_EQ(text(vec3(c * c + s * s, s * s + c * c, x)), "  y = vec3(1.0, 1.0, x);\n");
}

// b reads a.x, and a.y reads b: a can't be one statement.
TEST_F(PacksTest, DoesNotCombineOperationsThatDependOnEachOther) {
  const Expression first = sin(p[0]), between = exp(first) * first, second = sin(between);
  const Value a = vec3(first * first, second * second, between * between);
  const std::string all = text(a);
  EXPECT_LT(all.find("sin(p.x)"), all.find("exp("));
  EXPECT_LT(all.find("exp("), all.rfind("sin("));
}

TEST_F(PacksTest, WritesOnlyNumbersIfVectorsAreOff) {
  EmitOptions options;
  options.vectors = false;
  const Value u = each([&](int i) { return sin(p[i] * x); });
  const EmittedCode scalar = emit(graph, glsl300, std::vector{result("y", u * u)}, options),
                    packed = emit(graph, glsl300, std::vector{result("y", u * u)});
  EXPECT_EQ(scalar.temporaries, 3u);
  EXPECT_EQ(scalar.vectors, 0u);
  EXPECT_EQ(packed.temporaries, 1u);
  EXPECT_EQ(packed.vectors, 1u);
}

TEST_F(PacksTest, HandlesALongChainOfVectorsWithoutRecursion) {
  Value v = p;
  for (int i = 0; i < 30'000; ++i) v = each([&](int k) { return sin(v[k]); });
  const EmittedCode emitted = emit(graph, glsl300, std::vector{result("y", v)});
  EXPECT_EQ(emitted.vectors, emitted.temporaries);
  EXPECT_LT(emitted.temporaries, 5000u);
}

}  // namespace
}  // namespace warpjet
