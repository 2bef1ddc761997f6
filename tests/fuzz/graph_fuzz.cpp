// Fuzz target of the graph, the emitter and the evaluators: interprets bytes as calls on a builder,
// then queries everything. The first byte chooses the language, the second the inputs' values; see
// graph_calls.hpp for the others.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "eval/blocks.hpp"
#include "eval/bounds.hpp"
#include "eval/program.hpp"
#include "eval/words.hpp"
#include "fuzz/graph_calls.hpp"
#include "fuzz/require.hpp"
#include "module/syntax.hpp"

namespace warpjet {
namespace {

constexpr std::size_t vertices = 5, maxResults = 12;
constexpr std::uint32_t maxInstructions = 1500;

// Every number in shader code must be finite as a float.
void checkNumbers(const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    if (isWordPart(text[i]) && !isDigit(text[i])) {
      while (i < text.size() && isWordPart(text[i])) ++i;
    } else if (isDigit(text[i])) {
      char* end = nullptr;
      const float number = std::strtof(&text[i], &end);
      require(std::isfinite(number), "a literal is finite", text);
      i = static_cast<std::size_t>(end - text.data());
      while (i < text.size() && isWordPart(text[i])) ++i;
    } else {
      ++i;
    }
  }
}

void checkText(const std::string& text) {
  for (const std::string_view word : identifiers(text)) {
    require(word != "nan" && word != "inf" && word != "NaN" && word != "Infinity",
            "no literal is odd", text);
  }
  for (const auto& [open, close] : {std::pair{'(', ')'}, {'{', '}'}, {'[', ']'}}) {
    require(
        std::count(text.begin(), text.end(), open) == std::count(text.begin(), text.end(), close),
        "brackets are in pairs", text);
  }
  checkNumbers(text);
}

// Results under their own names may hide each other; numbered ones don't.
ShaderTextOptions numbered(const Module& module) {
  ShaderTextOptions options;
  for (std::uint32_t i = 0; i < module.outputs.size(); ++i)
    options.results.push_back({i, "warpjetResult" + std::to_string(i)});
  return options;
}

// A serialized module gives the same shader code as the module itself, in every language.
void checkTexts(const Module& module, bool hasForeignText) {
  const Module kept = load(save(module));
  for (const Dialect* dialect : dialects()) {
    for (const ShaderTextOptions& options : {ShaderTextOptions{}, numbered(module)}) {
      const ShaderTextResult made = write(kept, *dialect, options);
      require(made.text.has_value() == made.problem.empty(), "there is a text or a problem",
              made.problem);
      if (!made.text) requireSentence(made.problem);
      if (made.text && !hasForeignText) checkText(made.text->emitted.code);
      const ShaderTextResult again = write(load(save(kept)), *dialect, options);
      require(made.problem == again.problem &&
                  (!made.text || made.text->emitted.code == again.text->emitted.code),
              "what is kept twice is the same");
    }
  }
}

// The numbers of all inputs, vertex by vertex, within a range each; uniform ones are equal.
struct Given {
  std::vector<Range> ranges;
  std::vector<bool> isUniform;             // by number
  std::vector<std::vector<float>> values;  // by input
  std::vector<Stream> streams;

  std::vector<double> numbers(std::size_t vertex) const {
    std::vector<double> all;
    for (const auto& [first, size, uniform] : streams) {
      const float* from = first + (uniform ? 0 : vertex * size);
      all.insert(all.end(), from, from + size);
    }
    return all;
  }
};

float oddNumber(std::minstd_rand& random) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr float odd[] = {0, -0.0f, 1, -1, infinity, -infinity, NAN, 3e38f, -3e38f, 1e-40f, 1e10f};
  return odd[random() % std::size(odd)];
}

Given givenInputs(const Graph& graph, unsigned style) {
  std::minstd_rand random(style + 1);
  const bool isOdd = style & 1;
  Given given;
  for (std::uint32_t i = 0; i < graph.inputCount(); ++i) {
    const auto size = static_cast<std::size_t>(graph.input(i).shape.size());
    const bool isUniform = (style >> (1 + i % 7) & 1) != 0;
    std::vector<float> values;
    for (std::size_t n = 0; n < (isUniform ? size : size * vertices); ++n) {
      const float number = static_cast<float>(static_cast<int>(random() % 4097) - 2048) / 1024;
      values.push_back(isOdd ? oddNumber(random) : number);
    }
    for (std::size_t k = 0; k < size; ++k) {
      given.isUniform.push_back(isUniform);
      const double value = values[k];
      given.ranges.push_back(isUniform || isOdd ? Range{value, value} : Range{-2, 2});
    }
    given.values.push_back(std::move(values));
    given.streams.push_back(
        {given.values.back().data(), static_cast<std::uint32_t>(size), isUniform});
  }
  return given;
}

// The latest results, by number, and the count of their numbers.
struct Latest {
  std::vector<std::uint32_t> results;
  std::size_t size = 0;
};

Latest latestOf(const Module& module) {
  Latest latest;
  for (std::size_t i = module.outputs.size(); i-- > 0;) {
    const auto size = module.outputs[i].components.size();
    if (latest.size + size > maxResults) break;
    latest.results.push_back(static_cast<std::uint32_t>(i));
    latest.size += size;
  }
  return latest;
}

bool isNumber(const Words& words, std::uint32_t instruction) {
  const Op op = words.op(instruction);
  return index(op) >= ops::count || ops::declaration(op).signature.result == ops::Type::Float;
}

std::string nameOf(const Words& words, std::uint32_t instruction) {
  const Op op = words.op(instruction);
  return index(op) < ops::count ? std::string(ops::declaration(op).name) : "a leaf";
}

// The program, extended by a result for each instruction.
std::vector<std::uint32_t> withAllResults(const Program& program) {
  std::vector<std::uint32_t> words(
      program.words.begin(), program.words.begin() + program.instructions * Words::perInstruction);
  for (std::uint32_t i = 0; i < program.instructions; ++i) words.push_back(i);
  return words;
}

// Far from overflow and underflow of float32, which bounds don't track.
bool isOrdinaryFloat(double value) {
  return value == 0 || (std::abs(value) > 1e-30 && std::abs(value) < 1e30);
}

void requireWithin(const Range& range, double value, const std::string& of) {
  require(!std::isfinite(value) || (range.low <= value && value <= range.high),
          "bounds hold every value",
          of + " is " + exactly(value) + ", not from " + exactly(range.low) + " to " +
              exactly(range.high));
}

void checkEvaluation(const Module& module, unsigned style) {
  const auto [latest, results] = latestOf(module);
  const auto program = warpjet::program(module, latest).program;
  if (!program || program->instructions > maxInstructions) return;
  const Words words(program->words, program->instructions);
  std::vector<std::uint32_t> wanted;
  for (std::uint32_t i = 0; i < results; ++i) {
    if (isNumber(words, words.result(i))) wanted.push_back(i);
  }
  if (wanted.empty()) return;

  const Given given = givenInputs(module.graph, style);
  BlockEvaluator evaluator(
      allocateRegisters(program->words, program->instructions, wanted, given.isUniform),
      given.streams);
  std::vector<float> found(vertices * wanted.size());
  const Sink sinks[] = {{found.data(), static_cast<std::uint32_t>(wanted.size())}};
  evaluator.run(vertices, given.streams, sinks);

  const std::vector<Range> outer = bounds(program->words, program->instructions, given.ranges,
                                          wanted, {.tolerance = 0.02, .budget = 5'000});
  require(outer.size() == wanted.size(), "each result has bounds");
  if (style & 1) return;
  std::vector<double> values(program->instructions);
  const std::vector<std::uint32_t> everything = withAllResults(*program);
  for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
    evaluate(everything, program->instructions, given.numbers(vertex), values);
    const bool isOrdinary = std::all_of(values.begin(), values.end(), isOrdinaryFloat);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const std::uint32_t instruction = words.result(wanted[i]);
      const std::string name = nameOf(words, instruction);
      requireWithin(outer[i], values[instruction], name);
      if (isOrdinary)
        requireWithin(outer[i], double{found[vertex * wanted.size() + i]}, name + " in float32");
    }
  }
}

void check(std::span<const std::uint8_t> bytes) {
  Reader reader(bytes);
  Builder builder;
  reader.byte();  // unused: chose the language in older corpora; now every language is written
  const unsigned style = reader.byte();
  GraphCalls calls(builder, reader);
  calls.run();
  const std::vector<int>& values = calls.values();
  for (std::size_t i = values.size() - std::min<std::size_t>(values.size(), 4); i < values.size();
       ++i)
    builder.output("output", "last" + std::to_string(i), values[i]);
  if (!builder.finish()) return requireProblem(builder);
  checkTexts(builder.module(), calls.hasForeignText());
  checkEvaluation(load(save(builder.module())), style);
}

}  // namespace
}  // namespace warpjet

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  warpjet::check({data, size});
  return 0;
}
