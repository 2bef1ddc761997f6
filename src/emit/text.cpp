#include "emit/text.hpp"

#include <algorithm>
#include <initializer_list>
#include <set>

#include "emit/borders.hpp"
#include "emit/fading.hpp"
#include "emit/functions.hpp"
#include "emit/lower.hpp"
#include "emit/names.hpp"
#include "module/label.hpp"
#include "module/messages.hpp"
#include "module/syntax.hpp"

namespace warpjet {

namespace {

// Returns true if the source defines or calls a function of that name.
bool hasCall(std::string_view text, std::string_view name) {
  const auto words = identifiers(text);
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return word == name && isCalled(text, word); });
}

class ShaderTextWriter {
 public:
  ShaderTextWriter(const Module& module, const Dialect& dialect, const ShaderTextOptions& options)
      : module_(module), graph_(module.graph), dialect_(dialect), options_(options) {
    nameInputs();
    nameOutputs();
  }

  ShaderTextResult run() {
    const bool isValid = checkInputs() && checkFunctions() && checkOutputs() && checkOperations();
    if (!isValid) return {{}, problem_};
    ShaderText text = compose();
    if (isFull_) reject("A result", {tooLarge});
    if (isFull_ || hidesNameInUse(text)) return {{}, problem_};
    return {std::move(text)};
  }

 private:
  using Parts = std::initializer_list<std::string_view>;

  bool reject(std::string_view method, Parts parts) {
    problem_ = method;
    if (!method.empty()) problem_ += ": ";
    for (const std::string_view part : parts) problem_ += part;
    return false;
  }

  void nameInputs() {
    for (std::uint32_t i = 0; i < graph_.inputCount(); ++i)
      inputs_.push_back(graph_.input(i).label);
    for (const auto& [number, text] : options_.inputs) inputs_[number] = text;
    for (std::uint32_t i = 0; i < graph_.inputCount(); ++i) {
      if (const auto image = graph_.input(i).image)
        inputs_[i] = expand(dialect_.imageSize, {inputs_[*image]});
    }
  }

  void nameOutputs() {
    if (options_.results.empty()) outputs_ = module_.outputs;
    for (const auto& [number, text] : options_.results) {
      outputs_.push_back(module_.outputs[number]);
      outputs_.back().name = text;
    }
  }

  bool checkInputs() {
    for (std::uint32_t i = 0; i < graph_.inputCount(); ++i) {
      if (graph_.input(i).image) continue;
      if (const std::string why = inputProblem(dialect_, inputs_[i]); !why.empty())
        return reject(module_.methods[i],
                      {quoteShort(inputs_[i]), " cannot be read in a shader: ", why, "."});
    }
    return std::all_of(options_.inputs.begin(), options_.inputs.end(),
                       [&](const Naming& naming) { return isNewName(naming.number); });
  }

  // Checks that the host's new name for an input is not the name of another input.
  bool isNewName(std::uint32_t input) {
    if (inputs_[input] == graph_.input(input).label) return true;
    const Label label = readLabel(inputs_[input]);
    for (std::uint32_t i = 0; i < graph_.inputCount(); ++i) {
      if (i == input || graph_.input(i).image || !mayOverlap(readLabel(inputs_[i]), label))
        continue;
      return reject(module_.methods[input],
                    {quoteShort(inputs_[input]), " is already the name of another input (",
                     quoteShort(inputs_[i]),
                     "), but was not when the function was compiled; "
                     "rename one, or compile it with these names."});
    }
    return true;
  }

  // Checks the functions of the host. Our own functions have no sources.
  bool checkFunctions() {
    for (std::uint32_t i = 0; i < graph_.functionCount(); ++i) {
      const Function& function = graph_.function(i);
      if (function.isFromLibrary()) continue;
      const std::string key(dialect_.sourceKey);
      if (!sourceOf(i))
        return reject("fn", {"the option \"source\" of ", function.name, " must be a source in ",
                             dialect_.family, " for the target ", dialect_.name,
                             ", or an object { ", key, ": … } with one."});
      if (const std::string why = functionProblem(dialect_, function.name); !why.empty())
        return reject("fn", {quoteShort(function.name), " cannot name a function: ", why, "."});
      if (!hasCall(sourceOf(i)->text, function.name))
        return reject("fn", {quoteShort(function.name),
                             " is not in the source, which must define "
                             "a function with that name."});
    }
    return true;
  }

  const HostText* sourceOf(std::uint32_t function) const {
    const auto& sources = module_.sources[function];
    const auto found = std::find_if(sources.begin(), sources.end(), [&](const HostText& source) {
      return source.family == dialect_.sourceKey;
    });
    return found != sources.end() ? &*found : nullptr;
  }

  bool checkOutputs() {
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      const auto& [name, shape, components, method] = outputs_[i];
      if (const std::string why = outputProblem(dialect_, name); !why.empty())
        return reject(method, {quoteShort(name), " cannot name a result: ", why, "."});
      if (!outputNames_.insert(name).second)
        return reject(method, {"there are two results named ", quoteShort(name), "; rename one."});
      if (dialect_.typeName(ops::Type::Float, shape).empty())
        return reject(method, {"the result ", quoteShort(name), " is ", shapeName(shape), ", but ",
                               dialect_.missingTypes, "."});
    }
    return true;
  }

  // Checks that the language has all operations: languages differ in those on integers. Only
  // shader source has these, so the message spells the operation as GLSL does.
  bool checkOperations() {
    for (const Output& output : outputs_) {
      const auto missing = findUnsupported(graph_, output.components, dialect_.language);
      if (!missing) continue;
      const std::string_view spelling = ops::spelling(*missing, glsl300.language).text;
      return reject(output.method,
                    {dialect_.name, " has no ", quoteShort(expand(spelling, {"x", "y"})),
                     ", an operation on the bits of whole numbers; use ", glsl300.name, " or ",
                     wgsl.name, "."});
    }
    return true;
  }

  // Writes the module in operations of the language. If nodes must be replaced, works on a copy of
  // the graph.
  ShaderText compose() {
    Library library = module_.library.withEmptyCaches();
    ShaderText text;
    const bool hasReflections = options_.reflectsAtBorders && hasBorders(graph_);
    if (hasReflections || options_.fadesNoise || usesMissing(graph_, dialect_.language)) {
      Graph graph = graph_.copy();
      Comments comments = module_.comments;
      if (hasReflections) setOutputs(reflectAtBorders(graph, library, outputNodes(), comments));
      if (options_.fadesNoise) setOutputs(fadeNoise(graph, library, outputNodes(), comments));
      setOutputs(lower(graph, outputNodes(), dialect_.language, comments));
      text.emitted = emit(graph, dialect_, outputs_, options_.emit, comments, inputs_);
      declare(text, graph, library);
    } else {
      text.emitted = emit(graph_, dialect_, outputs_, options_.emit, module_.comments, inputs_);
      declare(text, graph_, library);
    }
    for (const std::uint32_t i : text.emitted.inputs) {
      // The size of an image is a variable of its own, or an expression of the image.
      const auto image = isPlainVariable(inputs_[i]) ? std::nullopt : graph_.input(i).image;
      const std::uint32_t number = image.value_or(i);
      const auto isSame = [&](const Naming& known) { return known.number == number; };
      if (std::none_of(text.inputs.begin(), text.inputs.end(), isSame))
        text.inputs.push_back({number, inputs_[number]});
    }
    return text;
  }

  std::vector<NodeId> outputNodes() const {
    std::vector<NodeId> nodes;
    for (const Output& output : outputs_)
      nodes.insert(nodes.end(), output.components.begin(), output.components.end());
    return nodes;
  }

  void setOutputs(const std::vector<NodeId>& nodes) {
    auto node = nodes.begin();
    for (Output& output : outputs_) {
      for (NodeId& component : output.components) component = *node++;
    }
  }

  void declare(ShaderText& text, const Graph& graph, Library& library) {
    for (const std::uint32_t i : text.emitted.functions)
      text.declarations += sourceOf(i)->text + '\n';
    Declarations declarations(dialect_, library);
    declarations.add(graph, text.emitted);
    text.declarations += declarations.text();
    isFull_ = (&graph != &graph_ && graph.isFull()) || library.isFull();
  }

  // Rejects a result that would shadow a variable or function that the code reads, and a variable
  // with the name of a function.
  bool hidesNameInUse(const ShaderText& text) {
    const auto hidesRead = [&](std::string_view name, std::string_view read) {
      if (!outputNames_.contains(name)) return false;
      reject({}, {"The result ", quoteShort(name),
                  " has the name of a variable or function that its code reads (", quoteShort(read),
                  "); rename the result."});
      return true;
    };
    std::set<std::string_view> variables;
    for (const std::uint32_t i : text.emitted.inputs) {
      for (const std::string_view word : identifiers(inputs_[i])) {
        if (hidesRead(word, inputs_[i])) return true;
        if (!isCalled(inputs_[i], word)) variables.insert(word);
      }
    }
    std::vector<std::string_view> functions;
    for (const std::uint32_t i : text.emitted.functions)
      functions.push_back(graph_.function(i).name);
    for (const std::string_view word : identifiers(text.declarations)) {
      if (word.starts_with(ourPrefix)) functions.push_back(word);
    }
    for (const std::string_view name : functions) {
      if (hidesRead(name, name)) return true;
      if (!variables.contains(name)) continue;
      reject({}, {quoteShort(name), " is both a variable and a function; rename one."});
      return true;
    }
    return false;
  }

  const Module& module_;
  const Graph& graph_;
  const Dialect& dialect_;
  const ShaderTextOptions& options_;
  std::vector<std::string> inputs_;  // by number, the host's expression
  std::vector<Output> outputs_;
  std::set<std::string, std::less<>> outputNames_;
  bool isFull_ = false;
  std::string problem_;
};

}  // namespace

ShaderTextResult write(const Module& module, const Dialect& dialect,
                       const ShaderTextOptions& options) {
  return ShaderTextWriter(module, dialect, options).run();
}

}  // namespace warpjet
