// Host expressions: which of them denote the same value, or components of the same value.
#include "module/label.hpp"

#include <gtest/gtest.h>

namespace warpjet {
namespace {

TEST(Labels, IgnoresSpacesAndRedundantParentheses) {
  for (const char* text : {" p", "p ", "(p)", "( ( p ) )"}) EXPECT_EQ(readLabel(text).text, "p");
  for (const char* text : {"p . x", "(p).x", "((p)) . x", "(p.x)", " p.x "})
    EXPECT_EQ(readLabel(text).text, "p.x") << text;
  EXPECT_EQ(readLabel("m [ 0 ] . x").text, "m[0].x");
  EXPECT_EQ(readLabel("( a+b )").root, readLabel("a + b").root);
  EXPECT_EQ(readLabel("(m*vec4( p , 1.0 )).xyz").root,
            readLabel("( m * vec4((p), 1.0) ) . xyz").root);
}

TEST(Labels, PreservesSignificantParentheses) {
  EXPECT_NE(readLabel("(a + b) * c").root, readLabel("a + b * c").root);
  EXPECT_NE(readLabel("f(a)").root, readLabel("f").root);
  EXPECT_NE(readLabel("a - -b").root, readLabel("a - b").root);
  // In a + b.x, the selector .x applies only to b.
  EXPECT_FALSE(isWithin(readLabel("a + b.x"), readLabel("a + b")));
  EXPECT_TRUE(isWithin(readLabel("(a + b).x"), readLabel("a + b")));
}

using Parts = std::optional<std::vector<int>>;

TEST(Labels, RecognizesPartsOfVectors) {
  const auto componentsOf = [](const char* part) {
    return partOf(readLabel("a.p"), vectorOf(3), readLabel(part));
  };
  EXPECT_EQ(componentsOf("a.p"), (Parts{{0, 1, 2}}));
  EXPECT_EQ(componentsOf("a.p.y"), Parts{{1}});
  EXPECT_EQ(componentsOf("(a.p) [2]"), Parts{{2}});
  EXPECT_EQ(componentsOf("a.p.zx"), (Parts{{2, 0}}));
  EXPECT_EQ(componentsOf("a.p.bgr.yx"), (Parts{{1, 2}}));
  for (const char* other : {"a.p.w", "a.p[3]", "a.q.x", "b.p.x", "a.p.length", "a.p.x.y", "a"})
    EXPECT_EQ(componentsOf(other), Parts{}) << other;
}

TEST(Labels, RecognizesPartsOfMatrices) {
  const auto componentsOf = [](const char* part) {
    return partOf(readLabel("m"), matrixOf(2, 3), readLabel(part));
  };
  EXPECT_EQ(componentsOf("m[1]"), (Parts{{3, 4, 5}}));
  EXPECT_EQ(componentsOf("m[0].x"), Parts{{0}});
  EXPECT_EQ(componentsOf("m[1][2]"), Parts{{5}});
  EXPECT_EQ(componentsOf("m[1].zy"), (Parts{{5, 4}}));
  for (const char* other : {"m[2]", "m.x", "m[0].w", "m[i]"})
    EXPECT_EQ(componentsOf(other), Parts{}) << other;
}

TEST(Labels, RecognizesPartsOfASwizzle) {
  const Label zx = readLabel("p.zx");
  EXPECT_EQ(partOf(zx, vectorOf(2), readLabel("p.x")), Parts{{1}});
  EXPECT_EQ(partOf(zx, vectorOf(2), readLabel("p[2]")), Parts{{0}});
  EXPECT_EQ(partOf(zx, vectorOf(2), readLabel("p.y")), Parts{});
}

TEST(Labels, DetectsExpressionsThatMayOverlap) {
  const auto overlap = [](const char* a, const char* b) {
    return mayOverlap(readLabel(a), readLabel(b));
  };
  EXPECT_TRUE(overlap("p.xy", "p.yz"));
  EXPECT_TRUE(overlap("p.x", "p.r"));
  EXPECT_TRUE(overlap("p", "p.x"));
  EXPECT_FALSE(overlap("p.x", "p.y"));
  EXPECT_FALSE(overlap("p.x", "q.x"));
  EXPECT_FALSE(overlap("inputs.uv", "inputs.position.x"));
}

}  // namespace
}  // namespace warpjet
