// The listing of lowered source: its functions (Define, Call) and its loops (Fold, Next). The
// interpreter below runs it in double; the results are compared with those of the same code in C++.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "source/glsl/glsl.hpp"
#include "source/loops.hpp"

namespace warpjet::source::glsl {
namespace {

using Numbers = std::vector<double>;

Listing lowerToListing(const std::string& text, int function, int maxIterations = 0) {
  Source source(parse(text));
  EXPECT_EQ(source.problem(), "");
  Listing listing = source.lower(function, maxIterations);
  EXPECT_EQ(source.problem(), "");
  return listing;
}

class Interpreter {
 public:
  Interpreter(const Listing& listing, Numbers arguments, Numbers uniforms = {})
      : listing_(listing), arguments_(std::move(arguments)), uniforms_(std::move(uniforms)) {
    Numbers computed;
    run(computed, {});
    for (const std::uint32_t result : listing.results) results.push_back(computed.at(result));
  }

  Numbers results;
  // The numbers of functions defined, calls made and loops run.
  int defined = 0, called = 0, folds = 0;
  // The numbers of parameters and of variables of each function, as in Define.
  std::vector<std::uint32_t> sizes, variables;
  // The number of iterations of the last loop; 0 if it ends by itself.
  std::uint32_t steps = 0;

 private:
  std::uint32_t word() { return listing_.words.at(at_++); }

  Numbers operands(const Numbers& made, std::uint32_t count) {
    Numbers all;
    for (; count > 0; --count) all.push_back(made.at(word()));
    return all;
  }

  // Runs until Next, End or the end of the list.
  void run(Numbers& made, const Numbers& parameters) {
    while (at_ < listing_.words.size()) {
      const auto code = static_cast<Code>(word());
      switch (code) {
        case Code::Next:
        case Code::End:
          return;
        case Code::Define:
          define();
          break;
        case Code::Call: {
          const std::uint32_t routine = word();
          const Numbers arguments = operands(made, word());
          ++called;
          const std::size_t back = std::exchange(at_, bodies_.at(routine));
          Numbers inner;
          run(inner, arguments);
          const Numbers found = operands(inner, word());
          made.insert(made.end(), found.begin(), found.end());
          at_ = back;
          break;
        }
        case Code::Fold:
          fold(made, parameters);
          break;
        case Code::Constant:
        case Code::Whole:
          made.push_back(listing_.constants.at(word()));
          break;
        case Code::Parameter:
          made.push_back(parameters.at(word()));
          break;
        case Code::Argument:
          made.push_back(arguments_.at(word()));
          at_ += 2;
          break;
        case Code::Uniform:
          made.push_back(uniforms_.at(word()));
          at_ += 2;
          break;
        default:
          made.push_back(value(code, operands(made, word())));
      }
    }
  }

  // Skips the body of a function by running it once, since its instructions differ in length.
  void define() {
    ++defined;
    sizes.push_back(word());
    variables.push_back(word());
    bodies_.push_back(at_);
    Numbers inner;
    run(inner, Numbers(sizes.back()));
    at_ += word();
  }

  void fold(Numbers& made, const Numbers& parameters) {
    ++folds;
    const std::uint32_t count = word(), size = word();
    steps = count;
    Numbers states = operands(made, size);
    const std::size_t body = at_, before = made.size();
    for (std::uint32_t i = 0; count > 0 ? i < count : states[0] < 0.5; ++i) {
      at_ = body;
      made.resize(before);
      made.push_back(i);
      made.insert(made.end(), states.begin(), states.end());
      run(made, parameters);
      states = operands(made, size);
    }
    made.insert(made.end(), states.begin(), states.end());
  }

  static std::uint32_t bits(double x) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(x));
  }
  // Returns the bits of an int or uint as an int.
  static double wrap(double x) { return static_cast<std::int32_t>(bits(x)); }

  static double value(Code code, const Numbers& x) {
    switch (code) {
      case Code::Neg:
        return -x[0];
      case Code::Add:
        return x[0] + x[1];
      case Code::Sub:
        return x[0] - x[1];
      case Code::Mult:
        return x[0] * x[1];
      case Code::Div:
        return x[0] / x[1];
      case Code::Sin:
        return std::sin(x[0]);
      case Code::Cos:
        return std::cos(x[0]);
      case Code::Lt:
        return x[0] < x[1];
      case Code::Gt:
        return x[0] > x[1];
      case Code::Le:
        return x[0] <= x[1];
      case Code::Ge:
        return x[0] >= x[1];
      case Code::And:
        return x[0] != 0 && x[1] != 0;
      case Code::Or:
        return x[0] != 0 || x[1] != 0;
      case Code::Not:
        return x[0] == 0;
      case Code::IfElse:
      case Code::IntIfElse:
        return x[0] != 0 ? x[1] : x[2];
      case Code::IntAdd:
        return wrap(x[0] + x[1]);
      case Code::IntSub:
        return wrap(x[0] - x[1]);
      case Code::IntMult:
        return wrap(bits(x[0]) * bits(x[1]));
      case Code::IntDiv:
        return std::trunc(x[0] / x[1]);
      case Code::UintDiv:
        return wrap(bits(x[0]) / bits(x[1]));
      case Code::UintShiftRight:
        return wrap(bits(x[0]) >> bits(x[1]));
      case Code::UintLt:
        return bits(x[0]) < bits(x[1]);
      case Code::UintOf:
        return wrap(x[0]);
      case Code::FloatOfUint:
        return bits(x[0]);
      case Code::IntLt:
        return x[0] < x[1];
      case Code::IntEq:
        return x[0] == x[1];
      case Code::IntOf:
        return std::trunc(x[0]);
      case Code::FloatOf:
        return x[0];
      case Code::IntOfHalves:
        return x[1] * 65536 + x[0];
      case Code::IntMod:
        return std::fmod(x[0], x[1]);
      default:
        ADD_FAILURE() << codeNames[static_cast<std::size_t>(code)] << " is not known here";
        return 0;
    }
  }

  const Listing& listing_;
  Numbers arguments_, uniforms_;
  std::vector<std::size_t> bodies_;
  std::size_t at_ = 0;
};

// A function that is long enough not to be inlined.
const std::string wave = R"(
float wave(float x, float y, float steep) {
  float s = sin(x * 1.5 + y) * steep;
  s += cos(y * 2.5 - x) * s + sin(s * 3.0);
  return s * sin(x + s) + cos(s - y);
}
)";

double waveAt(double x, double y, double steep) {
  double s = std::sin(x * 1.5 + y) * steep;
  s += std::cos(y * 2.5 - x) * s + std::sin(s * 3);
  return s * std::sin(x + s) + std::cos(s - y);
}

TEST(GlslDefine, AFunctionCalledOftenIsDefinedOnce) {
  const Listing listing = lowerToListing(
      wave +
          "float f(float x, float y) { return wave(x, y, 0.5) + wave(y, x * x, 0.5) * "
          "wave(x + 1.0, 2.0, 0.5); }",
      1);
  const Interpreter run(listing, {0.3, -0.7});
  EXPECT_EQ(run.defined, 1);
  EXPECT_EQ(run.called, 3);
  EXPECT_EQ(listing.routines, std::vector<std::string>{"wave"});
  const double expected =
      waveAt(0.3, -0.7, 0.5) + waveAt(-0.7, 0.3 * 0.3, 0.5) * waveAt(1.3, 2, 0.5);
  EXPECT_NEAR(run.results.at(0), expected, 1e-12);
}

TEST(GlslDefine, VaryingArgumentsComeFirstAndAreDifferentiated) {
  // The first argument is the same constant in all calls.
  const std::string text =
      "float swapped(float steep, float x, float y) { float s = sin(x * 1.5 + y) "
      "* steep; s += cos(y * 2.5 - x) * s + sin(s * 3.0); return s * sin(x + s) "
      "+ cos(s - y); }\n"
      "float f(float x, float y) { return swapped(0.25, x, y) + swapped(0.25, "
      "y, x) + swapped(0.25, x * y, y); }";
  const Listing listing = lowerToListing(text, 1);
  const Interpreter run(listing, {0.4, 1.1});
  ASSERT_EQ(run.defined, 1);
  EXPECT_EQ(run.sizes[0], 3u);
  EXPECT_EQ(run.variables[0], 2u);
  EXPECT_NEAR(run.results.at(0),
              waveAt(0.4, 1.1, 0.25) + waveAt(1.1, 0.4, 0.25) + waveAt(0.44, 1.1, 0.25), 1e-12);
}

TEST(GlslDefine, AUniformThatAFunctionReadsBecomesAnArgument) {
  std::string text = "uniform float steep;\n" + wave;
  text.replace(text.find(", float steep"), 13, "");
  const Listing listing = lowerToListing(
      text + "float f(float x) { return wave(x, 1.0) + wave(1.0, x) + wave(x, x); }", 1);
  const Interpreter run(listing, {0.6}, {0.8});
  EXPECT_EQ(run.defined, 1);
  EXPECT_EQ(run.sizes[0], 3u);
  EXPECT_NEAR(run.results.at(0), waveAt(0.6, 1, 0.8) + waveAt(1, 0.6, 0.8) + waveAt(0.6, 0.6, 0.8),
              1e-6);
}

TEST(GlslDefine, AFunctionCalledOnceIsInlined) {
  const Interpreter run(lowerToListing(wave + "float f(float x) { return wave(x, 1.0, 0.5); }", 1),
                        {0.2});
  EXPECT_EQ(run.defined + run.called, 0);
  EXPECT_NEAR(run.results.at(0), waveAt(0.2, 1, 0.5), 1e-12);
}

TEST(GlslDefine, AFunctionMayCallAnother) {
  const std::string twice =
      "float twice(float x, float y) { float a = wave(x, y, 0.5), b = wave(y, "
      "a, 0.5); return a * sin(b) + b * cos(a) + sin(a * b) * cos(x - y) + "
      "sin(x * y + a); }\n";
  const auto twiceAt = [](double x, double y) {
    const double a = waveAt(x, y, 0.5), b = waveAt(y, a, 0.5);
    return a * std::sin(b) + b * std::cos(a) + std::sin(a * b) * std::cos(x - y) +
           std::sin(x * y + a);
  };
  const Interpreter run(
      lowerToListing(wave + twice + "float f(float x) { return twice(x, 0.5) + twice(x * x, x); }",
                     2),
      {0.9});
  EXPECT_EQ(run.defined, 2);
  EXPECT_NEAR(run.results.at(0), twiceAt(0.9, 0.5) + twiceAt(0.81, 0.9), 1e-12);
}

// The body of a loop that is long enough not to be unrolled.
const std::string body =
    "s += a * sin(q * 1.5 + cos(s)) * cos(q - s); q = q * 0.75 + sin(s) * 0.5; a *= 0.5;";

double runLoop(double x, int steps, const std::function<bool(double, int)>& stops) {
  double s = 0, a = 1, q = x;
  for (int i = 0; i < steps && !stops(q, i); ++i) {
    s += a * std::sin(q * 1.5 + std::cos(s)) * std::cos(q - s);
    q = q * 0.75 + std::sin(s) * 0.5;
    a *= 0.5;
  }
  return s + q;
}

std::string sourceWithLoop(const std::string& head, const std::string& first = "") {
  return "float f(float x) { float s = 0.0, a = 1.0, q = x; " + head + " { " + first + body +
         " } return s + q; }";
}

const auto never = [](double, int) { return false; };

TEST(GlslFold, ALongLoopBecomesAFold) {
  const Listing listing = lowerToListing(sourceWithLoop("for (int i = 0; i < 12; i++)"), 0);
  const Interpreter run(listing, {0.7});
  EXPECT_EQ(run.folds, 1);
  EXPECT_EQ(run.steps, 12u);
  EXPECT_NEAR(run.results.at(0), runLoop(0.7, 12, never), 1e-12);
}

TEST(GlslFold, CountersAreComputedFromTheStep) {
  const Listing listing = lowerToListing(
      sourceWithLoop("for (int i = 9; i > -12; i -= 3)", "s += float(i) * q * 0.125;"), 0);
  const Interpreter run(listing, {0.7});
  EXPECT_EQ(run.steps, 7u);
  double s = 0, a = 1, q = 0.7;
  for (int i = 9; i > -12; i -= 3) {
    s += i * q * 0.125;
    s += a * std::sin(q * 1.5 + std::cos(s)) * std::cos(q - s);
    q = q * 0.75 + std::sin(s) * 0.5;
    a *= 0.5;
  }
  EXPECT_NEAR(run.results.at(0), s + q, 1e-12);
}

TEST(GlslFold, BreakBecomesAStateVariable) {
  const Listing listing =
      lowerToListing(sourceWithLoop("for (int i = 0; i < 20; i++)", "if (q < 0.625) break; "), 0);
  for (const double x : {0.1, 0.7, 1.9, 5.0}) {
    const Interpreter run(listing, {x});
    EXPECT_EQ(run.folds, 1);
    EXPECT_NEAR(run.results.at(0), runLoop(x, 20, [](double q, int) { return q < 0.625; }), 1e-12)
        << x;
  }
}

TEST(GlslFold, AWhileThatCountsAfterABreakHasTheLengthOfTheFor) {
  for (const char* end : {"if (q < 0.625) break; ", "if (q < 0.625) return s + q; "}) {
    const auto list = [&](const std::string& head, const std::string& last) {
      return lowerToListing("float f(float x) { float s = 0.0, a = 1.0, q = x; int i = 0; " + head +
                                " { " + end + body + last + " } return s + q; }",
                            0);
    };
    const Listing listing = list("while (i < 20)", "i++;");
    EXPECT_EQ(listing.words.size(), list("for (; i < 20; i++)", "").words.size());
    for (const double x : {0.1, 0.7, 1.9, 5.0}) {
      const Interpreter run(listing, {x});
      EXPECT_EQ(run.folds, 1);
      EXPECT_NEAR(run.results.at(0), runLoop(x, 20, [](double q, int) { return q < 0.625; }), 1e-12)
          << x;
    }
  }
}

TEST(GlslFold, ALoopWithADynamicConditionRunsToMaxIterations) {
  const Listing listing = lowerToListing(sourceWithLoop("while (q > 0.625)"), 0, 15);
  const Interpreter run(listing, {3.0});
  EXPECT_EQ(run.steps, 15u);
  EXPECT_NEAR(run.results.at(0), runLoop(3, 15, [](double q, int) { return q <= 0.625; }), 1e-12);
}

TEST(GlslFold, ALoopCanRunUntilItEnds) {
  for (const char* end : {"if (q < s) break; ", "if (q < s) return s + q; ", ""}) {
    const std::string text =
        "float f(float x) { float s = 0.0, q = x; for (; q > 0.0; q -= 0.25) { " +
        std::string(end) + "s += sin(q) * 0.125 + 0.0625; } return s + q; }";
    const Listing listing = lowerToListing(text, 0, untilEnd);
    const Interpreter run(listing, {700.0});
    EXPECT_EQ(run.folds, 1);
    EXPECT_EQ(run.steps, 0u);
    EXPECT_EQ(listing.cutOff, "");
    double s = 0, q = 700;
    for (; q > 0 && (*end == 0 || q >= s); q -= 0.25) s += std::sin(q) * 0.125 + 0.0625;
    EXPECT_NEAR(run.results.at(0), s + q, 1e-9) << end;
  }
}

TEST(GlslFold, NestedLoopsCanRunUntilTheyEnd) {
  const std::string text =
      "float f(float x, float n) { float s = 0.0; for (float i = 0.0; i < n; i++) for (float j = "
      "0.0; j < i; j++) { if (s > x) return s + i; s += sin(i * 0.5 + j) + 0.75; } return s; }";
  const Listing listing = lowerToListing(text, 0, untilEnd);
  EXPECT_LT(listing.words.size(), 400u);
  for (const double x : {50.0, 1e6}) {
    const Interpreter run(listing, {x, 60.0});
    const auto f = [&] {
      double s = 0;
      for (int i = 0; i < 60; ++i)
        for (int j = 0; j < i; ++j) {
          if (s > x) return s + i;
          s += std::sin(i * 0.5 + j) + 0.75;
        }
      return s;
    };
    EXPECT_NEAR(run.results.at(0), f(), 1e-9) << x;
  }
}

TEST(GlslFold, NestedLoopsMultiplyMaxIterations) {
  const auto problemOf = [](const std::string& loops, int maxIterations) {
    const std::string text =
        "float f(float x, float n) {\n  float s = 0.0;\n  " + loops + "\n  return s; }";
    Source source(parse(text));
    source.lower(0, maxIterations);
    return source.problem();
  };
  const auto message = [](const std::string& place, const std::string& numbers) {
    return place +
           ": nested loops whose ends only the shader knows multiply the option maxIterations: "
           "expected at most 10000 iterations in all, " +
           numbers;
  };
  const std::string outer = "for (float i = 0.0; i < n; i++)\n";
  for (const char* inner :
       {"for (float j = 0.0; j < n; j++) s += sin(x * i + j);",
        "for (float j = 0.0; j < i; j++) s += sin(x * i + j);",
        "for (;;) { s += sin(x); if (s > n) break; }", "do s += sin(x * i); while (s < n);"}) {
    EXPECT_EQ(problemOf(outer + inner, 100), "") << inner;
    EXPECT_EQ(problemOf(outer + inner, 512)
                  .find(message("line 4, column 1",
                                "got 512 * 512 = 262144; set it to at most 100, or less ")),
              0u)
        << problemOf(outer + inner, 512);
  }
  const std::string three = outer + outer + "for (float k = 0.0; k < n; k++) s += sin(x * k);";
  EXPECT_EQ(problemOf(three, 21), "");
  EXPECT_EQ(problemOf(three, 22).find(message(
                "line 5, column 1", "got 22 * 22 * 22 = 10648; set it to at most 21, or less ")),
            0u)
      << problemOf(three, 22);
  // These have more states than loops of a shader can have, so they are unrolled.
  EXPECT_EQ(problemOf("float a[40], i = 0.0, j = 0.0; while (i < n) { a[int(i) % 40] = i++;\n"
                      "while (j < n) { a[int(j) % 40] = j++; s += a[7]; } }",
                      200)
                .find(message("line 4, column 1", "got 200 * 200 = 40000; ")),
            0u);
  // Loops one after another, and loops with a known end, do not multiply it.
  EXPECT_EQ(problemOf(outer + "s += sin(x * i);\n" + outer + "s += cos(x * i);", 4096), "");
  EXPECT_EQ(problemOf("for (int i = 0; i < 5; i++)\nwhile (s < n) s += sin(x) + 2.0;", 4096), "");
  EXPECT_EQ(problemOf(outer + "for (int j = 0; j < 5; j++) s += sin(x);", 4096), "");
  // Only unrolling shows that the outer loop ends.
  EXPECT_EQ(problemOf("int i = 0; for (;;) { if (i >= 4) break; i++;\n"
                      "for (float j = 0.0; j < n; j++) s += sin(x * j); }",
                      512),
            "");
}

TEST(GlslFold, ALoopThatCannotStayALoopIsCutOffWithAMessage) {
  const std::string text =
      "float f(float x) {\n  float a[40], n = 0.0;\n  while (n < x) { a[int(n) % 40] = n; n++; "
      "}\n  return n; }";
  const Listing listing = lowerToListing(text, 0, untilEnd);
  EXPECT_EQ(listing.cutOff.find("line 3, column 3: only the shader knows where this loop ends"), 0u)
      << listing.cutOff;
  EXPECT_NE(listing.cutOff.find("changes more than about 30 numbers or is nested more than 8 deep, "
                                "so it is cut off after 256 iterations; "),
            std::string::npos);
  EXPECT_NE(listing.cutOff.find("set the option maxIterations (1 to 4096).\n"), std::string::npos);
  EXPECT_NE(listing.cutOff.find("while (n < x)"), std::string::npos);
  EXPECT_DOUBLE_EQ(Interpreter(listing, {900.0}).results.at(0), 256);
  EXPECT_DOUBLE_EQ(Interpreter(listing, {255.0}).results.at(0), 255);
  const Listing limited = lowerToListing(text, 0, 300);
  EXPECT_EQ(limited.cutOff, "");
  EXPECT_DOUBLE_EQ(Interpreter(limited, {900.0}).results.at(0), 300);
}

// 32-bit integers that do more than count, compared with the same code in C++.
TEST(GlslFold, IntegersOf32BitsCanBeStates) {
  const std::string text =
      "float f(float x) { uint h = 7u; int a = -70001; float s = 0.0; for (uint i = 0u; i < 90u; "
      "i++) { if (s > x) break; h = h * 1664525u + 1013904223u; a = a * 3 - int(h >> 3u); s += "
      "float(h / 65536u) / 65536.0 + float(a / 65536) / 65536.0; } return s; }";
  const Listing listing = lowerToListing(text, 0);
  for (const double x : {3.0, 1e6}) {
    const Interpreter run(listing, {x});
    EXPECT_EQ(run.folds, 1);
    std::uint32_t h = 7;
    std::int32_t a = -70001;
    double s = 0;
    for (int i = 0; i < 90 && s <= x; ++i) {
      h = h * 1664525u + 1013904223u;
      a = static_cast<std::int32_t>(static_cast<std::uint32_t>(a) * 3u - (h >> 3));
      s += h / 65536u / 65536.0 + a / 65536 / 65536.0;
    }
    EXPECT_NEAR(run.results.at(0), s, 1e-9) << x;
  }
}

TEST(GlslFold, TheNumberOfStepsFollowsFromIntegersThatWrapAround) {
  const Listing listing = lowerToListing(sourceWithLoop("for (int i = 5; i * 2 / 3 > -4; i--)"), 0);
  const Interpreter run(listing, {0.7});
  EXPECT_EQ(run.steps, 11u);
  EXPECT_NEAR(run.results.at(0), runLoop(0.7, 11, never), 1e-12);
}

TEST(GlslFold, LoopsCanBeNested) {
  const std::string text =
      "float f(float x) { float s = 0.0; for (int i = 0; i < 9; i++) { float t = s * 0.5; "
      "for (int j = 0; j < 20; j++) { t += sin(t * 1.5 + x * float(j)) * cos(t - float(i)) * 0.25; "
      "} s += sin(t) * cos(s * 2.0 + x); } return s; }";
  const Interpreter run(lowerToListing(text, 0), {0.35});
  double s = 0;
  for (int i = 0; i < 9; ++i) {
    double t = s * 0.5;
    for (int j = 0; j < 20; ++j) t += std::sin(t * 1.5 + 0.35 * j) * std::cos(t - i) * 0.25;
    s += std::sin(t) * std::cos(s * 2 + 0.35);
  }
  EXPECT_NEAR(run.results.at(0), s, 1e-10);
  EXPECT_EQ(run.folds, 1 + 9);
}

TEST(GlslFold, AShortLoopIsUnrolled) {
  EXPECT_EQ(
      Interpreter(lowerToListing(sourceWithLoop("for (int i = 0; i < 2; i++)"), 0), {0.7}).folds,
      0);
}

TEST(GlslListing, IntUniformsAreReadInHalves) {
  const Listing listing =
      lowerToListing("uniform int n; float f(float x) { return float(n % 1000) + x; }", 0);
  int halves = 0;
  for (std::size_t i = 0; i + 3 < listing.words.size(); ++i)
    halves += listing.words[i] == static_cast<std::uint32_t>(Code::Uniform) &&
              (listing.words[i + 3] & Recorder::highHalf) != 0;
  EXPECT_EQ(halves, 1);
  ASSERT_EQ(listing.names.size(), 1u);
  const auto& [name, type, isAttribute, isRead, shape] = listing.names[0];
  EXPECT_EQ(name, "n");
  EXPECT_EQ(type, "int");
  EXPECT_FALSE(isAttribute);
  EXPECT_TRUE(isRead);
  EXPECT_EQ(shape, (std::array<std::uint32_t, 2>{1, 1}));
}

}  // namespace
}  // namespace warpjet::source::glsl
