// A module: its contents survive serialization, and readers don't modify it.
#include "module/module.hpp"

#include <gtest/gtest.h>

#include <set>

#include "bench.hpp"
#include "eval/program.hpp"
#include "noise/table.hpp"
#include "texture/texture.hpp"
#include "warp/warp.hpp"

namespace warpjet {
namespace {

class ModuleTest : public testing::Test, protected Bench {
 protected:
  static std::string textOf(const Module& module, const Dialect& dialect) {
    const ShaderTextResult written = write(module, dialect);
    if (!written.text) return written.problem;
    return written.text->declarations + "---\n" + written.text->emitted.code;
  }

  // Creates results that use every kind of node.
  void fill() {
    const int inner = call("sin", {call("mult", {v3, x})});
    builder.comment("let inner = sin(v3 * x)");
    const int bump = builder.addFunction("bump",
                                         {{"glsl", "float bump(float a) { return a; }"},
                                          {"wgsl", "fn bump(a: f32) -> f32 { return a; }"}},
                                         1);
    const int truncated = call("trunc", {callFunction(bump, {inner})});
    builder.push(v3);
    builder.push(number(3));
    const int noise = builder.callNoise({noiseNamed("noise")}, true);
    builder.push(v2);
    const int image = builder.callTexture({Filter::Bicubic, Wrap::Mirror}, "picture");
    call("cos", {number(0.25)});
    builder.output("gen", "a", truncated);
    builder.output("gen", "b", call("gradient", {noise, v3}));
    builder.output("gen", "c", image);
    builder.output("gen", "d", call("mod", {m3, number(2)}) == Builder::failed ? m3 : x);
  }
};

TEST_F(ModuleTest, ASavedModuleGeneratesTheSameCodeInEveryLanguage) {
  fill();
  ASSERT_TRUE(builder.finish()) << builder.problem();
  const Module loaded = load(save(builder.module()));
  EXPECT_LT(loaded.graph.size(), builder.graph().size()) << "nodes that no result needs are gone";
  for (const Dialect* dialect : dialects()) {
    const std::string text = textOf(builder.module(), *dialect);
    EXPECT_NE(text.find("---"), text.npos) << text;
    EXPECT_EQ(textOf(loaded, *dialect), text);
    EXPECT_EQ(textOf(load(save(loaded)), *dialect), text);
  }
}

TEST_F(ModuleTest, ReportsWhichInputsAResultDependsOn) {
  const int angle = builder.input("gen", "angle", {1, 1});
  const int unread = builder.input("gen", "unread", {1, 1});
  builder.push(v2);
  const int image = builder.callTexture({Filter::Bicubic, Wrap::Mirror}, "picture");
  builder.output("gen", "a", call("sin", {call("mult", {v3, angle})}));
  builder.output("gen", "b", image);
  builder.output("gen", "c", call("sub", {unread, unread}));
  ASSERT_TRUE(builder.finish()) << builder.problem();
  const Module loaded = load(save(builder.module()));
  const auto namesRead = [&](std::initializer_list<std::uint32_t> results) {
    std::set<std::string> names;
    for (const std::uint32_t input : inputsRead(loaded, std::vector(results)))
      names.insert(loaded.graph.input(input).label);
    return names;
  };
  const auto labelOf = [&](int handle) {
    return builder.graph().input(builder.inputOf(handle)).label;
  };
  EXPECT_EQ(namesRead({0}), (std::set<std::string>{labelOf(v3), "angle"}));
  // The size of an image is an input without a name.
  EXPECT_EQ(namesRead({1}), (std::set<std::string>{labelOf(v2), "picture", ""}));
  EXPECT_EQ(namesRead({2}), std::set<std::string>{});
  EXPECT_EQ(namesRead({0, 1}),
            (std::set<std::string>{labelOf(v2), labelOf(v3), "angle", "picture", ""}));
}

TEST_F(ModuleTest, WritingCodeOrProgramsDoesNotModifyTheModule) {
  fill();
  const Module loaded = load(save(builder.module()));
  const std::vector<std::uint32_t> before = save(loaded);
  const std::string first = textOf(loaded, glsl300);
  textOf(loaded, glsl100);  // lowers trunc
  textOf(loaded, wgsl);
  const std::uint32_t b = 1;
  EXPECT_TRUE(program(loaded, {&b, 1}).program) << "inlines the noise";
  EXPECT_EQ(save(loaded), before);
  EXPECT_EQ(textOf(loaded, glsl300), first);
}

TEST_F(ModuleTest, UsesTheNamesThatTheHostPasses) {
  builder.output("gen", "first", call("mult", {v2, x}));
  builder.output("gen", "second", call("sin", {x}));
  const Module loaded = load(save(builder.module()));
  const ShaderTextResult written =
      write(loaded, glsl300, {.results = {{1, "y"}}, .inputs = {{0, "uTime"}, {1, "inputs.uv"}}});
  ASSERT_TRUE(written.text) << written.problem;
  EXPECT_EQ(written.text->emitted.code, "float y;\n{\n  y = sin(uTime);\n}\n");
  ASSERT_EQ(written.text->inputs.size(), 1u);
  EXPECT_EQ(written.text->inputs[0].number, 0u);
  EXPECT_EQ(written.text->inputs[0].text, "uTime");
}

TEST_F(ModuleTest, AProgramIgnoresImagesThatItsResultsDoNotRead) {
  builder.push(v2);
  builder.callTexture({Filter::Bilinear, Wrap::Clamp}, "picture");
  const int last = input("last");
  builder.output("gen", "y", call("mult", {last, number(2)}));
  const std::uint32_t only = 0;
  const auto compiled = program(load(save(builder.module())), {&only, 1}).program;
  ASSERT_TRUE(compiled);
  // x, v2, v3, v4, m2, m3, m23, the image's size, and `last`.
  std::vector<double> numbers(1 + 2 + 3 + 4 + 4 + 9 + 6 + 2 + 1), results(1);
  numbers.back() = 21;
  evaluate(compiled->words, compiled->instructions, numbers, results);
  EXPECT_EQ(results[0], 42);
}

}  // namespace
}  // namespace warpjet
