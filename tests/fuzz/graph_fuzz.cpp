// Fuzz target of the graph, the emitter and the evaluators: interprets bytes as calls on a builder,
// then queries everything. The first byte is not used, the second chooses the inputs' values; see
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

// Requires every number in shader code to be finite as a float.
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
            "no literal is NaN or infinite", text);
  }
  for (const auto& [open, close] : {std::pair{'(', ')'}, {'{', '}'}, {'[', ']'}}) {
    require(
        std::count(text.begin(), text.end(), open) == std::count(text.begin(), text.end(), close),
        "brackets are in pairs", text);
  }
  checkNumbers(text);
}

// Returns options that name the results by their indices: under their own names, results may hide
// each other.
ShaderTextOptions numberResults(const Module& module) {
  ShaderTextOptions options;
  for (std::uint32_t i = 0; i < module.outputs.size(); ++i)
    options.results.push_back({i, "warpjetResult" + std::to_string(i)});
  return options;
}

// Requires valid shader code or a message in every language, and the same again from the serialized
// module.
void checkTexts(const Module& module, bool hasForeignText) {
  const Module reloaded = load(save(module));
  for (const Dialect* dialect : dialects()) {
    for (const ShaderTextOptions& options : {ShaderTextOptions{}, numberResults(module)}) {
      const ShaderTextResult result = write(reloaded, *dialect, options);
      require(result.text.has_value() == result.problem.empty(), "there is a text or a problem",
              result.problem);
      if (!result.text) requireMessage(result.problem);
      if (result.text && !hasForeignText) checkText(result.text->emitted.code);
      const ShaderTextResult repeated = write(load(save(reloaded)), *dialect, options);
      require(result.problem == repeated.problem &&
                  (!result.text || result.text->emitted.code == repeated.text->emitted.code),
              "a module that is serialized twice gives the same code");
    }
  }
}

// The values of all inputs at each vertex, each within its range; uniforms have one value.
struct InputValues {
  std::vector<Range> ranges;
  std::vector<bool> isUniform;             // by input
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

InputValues makeInputs(const Graph& graph, unsigned style) {
  std::minstd_rand random(style + 1);
  const bool isOdd = style & 1;
  InputValues inputs;
  for (std::uint32_t i = 0; i < graph.inputCount(); ++i) {
    const auto size = static_cast<std::size_t>(graph.input(i).shape.size());
    const bool isUniform = (style >> (1 + i % 7) & 1) != 0;
    std::vector<float> values;
    for (std::size_t n = 0; n < (isUniform ? size : size * vertices); ++n) {
      const float number = static_cast<float>(static_cast<int>(random() % 4097) - 2048) / 1024;
      values.push_back(isOdd ? oddNumber(random) : number);
    }
    for (std::size_t k = 0; k < size; ++k) {
      inputs.isUniform.push_back(isUniform);
      const double value = values[k];
      inputs.ranges.push_back(isUniform || isOdd ? Range{value, value} : Range{-2, 2});
    }
    inputs.values.push_back(std::move(values));
    inputs.streams.push_back(
        {inputs.values.back().data(), static_cast<std::uint32_t>(size), isUniform});
  }
  return inputs;
}

// The indices of the last results whose components are together at most `maxResults`, and the
// number of these components.
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

// Returns whether an instruction is a leaf, or an operation whose result is a float.
bool isNumber(const Words& words, std::uint32_t instruction) {
  const Op op = words.op(instruction);
  return index(op) >= ops::count || ops::declaration(op).signature.result == ops::Type::Float;
}

std::string nameOf(const Words& words, std::uint32_t instruction) {
  const Op op = words.op(instruction);
  return index(op) < ops::count ? std::string(ops::declaration(op).name) : "a leaf";
}

// Returns the words of a program, extended by a result for each instruction.
std::vector<std::uint32_t> withAllResults(const Program& program) {
  std::vector<std::uint32_t> words(
      program.words.begin(), program.words.begin() + program.instructions * Words::perInstruction);
  for (std::uint32_t i = 0; i < program.instructions; ++i) words.push_back(i);
  return words;
}

// Returns whether a value is far from overflow and underflow of float32, which bounds don't track.
bool isOrdinaryFloat(double value) {
  return value == 0 || (std::abs(value) > 1e-30 && std::abs(value) < 1e30);
}

void requireWithin(const Range& range, double value, const std::string& name) {
  require(!std::isfinite(value) || (range.low <= value && value <= range.high),
          "bounds contain every value",
          name + " is " + printExactly(value) + ", not from " + printExactly(range.low) + " to " +
              printExactly(range.high));
}

void checkEvaluation(const Module& module, unsigned style) {
  const auto [latestResults, componentCount] = latestOf(module);
  const auto program = warpjet::program(module, latestResults).program;
  if (!program || program->instructions > maxInstructions) return;
  const Words words(program->words, program->instructions);
  std::vector<std::uint32_t> checked;
  for (std::uint32_t i = 0; i < componentCount; ++i) {
    if (isNumber(words, words.result(i))) checked.push_back(i);
  }
  if (checked.empty()) return;

  const InputValues inputs = makeInputs(module.graph, style);
  BlockEvaluator evaluator(
      allocateRegisters(program->words, program->instructions, checked, inputs.isUniform),
      inputs.streams);
  std::vector<float> blockResults(vertices * checked.size());
  const Sink sinks[] = {{blockResults.data(), static_cast<std::uint32_t>(checked.size())}};
  evaluator.run(vertices, inputs.streams, sinks);

  const std::vector<Range> ranges = bounds(program->words, program->instructions, inputs.ranges,
                                           checked, {.tolerance = 0.02, .budget = 5'000});
  require(ranges.size() == checked.size(), "each result has bounds");
  if (style & 1) return;
  std::vector<double> values(program->instructions);
  const std::vector<std::uint32_t> allResults = withAllResults(*program);
  for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
    evaluate(allResults, program->instructions, inputs.numbers(vertex), values);
    const bool isOrdinary = std::all_of(values.begin(), values.end(), isOrdinaryFloat);
    for (std::size_t i = 0; i < checked.size(); ++i) {
      const std::uint32_t instruction = words.result(checked[i]);
      const std::string name = nameOf(words, instruction);
      requireWithin(ranges[i], values[instruction], name);
      if (isOrdinary)
        requireWithin(ranges[i], double{blockResults[vertex * checked.size() + i]},
                      name + " in float32");
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
