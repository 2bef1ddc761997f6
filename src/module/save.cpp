#include <algorithm>
#include <array>

#include "graph/reachable.hpp"
#include "module/module.hpp"
#include "module/word_stream.hpp"
#include "noise/noise.hpp"
#include "texture/texture.hpp"

namespace warpjet {

namespace {

// The functions that recreate our own functions from their settings. Words refer to them by index.
// A module that defines functions must be added here.
constexpr std::array<Definition::Maker, 2> makers{noiseFrom, samplingFrom};

std::size_t numberOf(Definition::Maker maker) {
  return static_cast<std::size_t>(std::find(makers.begin(), makers.end(), maker) - makers.begin());
}

constexpr std::size_t wordsOfNode = 1 + ops::maxArity;

class Saver {
 public:
  explicit Saver(const Module& module)
      : module_(module), graph_(module.graph), retained_(reachable(graph_, module.roots())) {
    places_.resize(graph_.size() + 1);
    for (const NodeId id : retained_) places_[index(id) + 1] = 1;
    for (std::size_t i = 1; i < places_.size(); ++i) places_[i] += places_[i - 1];
  }

  std::vector<std::uint32_t> run() {
    writeNodes();
    writeInputs();
    writeFunctions();
    writeLoops();
    writeOutputs();
    writeComments();
    return words_.take();
  }

 private:
  void writeNodes() {
    words_.number(retained_.size());
    std::uint32_t* word = words_.extend(retained_.size() * wordsOfNode);
    for (const NodeId id : retained_) {
      const auto& [operands, op] = graph_.node(id);
      *word++ = static_cast<std::uint32_t>(index(op));
      const int arity = graph_.arity(id);
      for (int i = 0; i < ops::maxArity; ++i)
        *word++ = i < arity ? places_[operands[i]] : operands[i];
    }
  }

  void writeShape(Shape shape) {
    words_.number(shape.columns);
    words_.number(shape.rows);
  }

  void writeInputs() {
    words_.number(graph_.inputCount());
    for (std::uint32_t i = 0; i < graph_.inputCount(); ++i) {
      const Input& input = graph_.input(i);
      words_.text(input.label);
      writeShape(input.shape);
      words_.number(input.image ? *input.image + 1 : 0);
      words_.text(module_.methods[i]);
    }
  }

  void writeFunctions() {
    words_.number(graph_.functionCount());
    for (std::uint32_t i = 0; i < graph_.functionCount(); ++i) {
      const Function& function = graph_.function(i);
      words_.number(function.isFromLibrary());
      if (function.isFromLibrary()) {
        const Definition& definition = module_.library.definition(function.name);
        words_.number(definition.words.size());
        if (definition.reader) {
          for (const std::uint32_t word : definition.words) words_.number(word);
          words_.text(function.name);
          words_.number(static_cast<std::size_t>(function.variables));
          continue;
        }
        words_.number(numberOf(definition.maker));
        words_.number(definition.settings);
        continue;
      }
      words_.text(function.name);
      words_.number(static_cast<std::size_t>(function.arity));
      words_.number(module_.sources[i].size());
      for (const auto& [family, text] : module_.sources[i]) {
        words_.text(family);
        words_.text(text);
      }
    }
  }

  void writeLoops() {
    words_.number(graph_.loopCount());
    for (std::uint32_t i = 0; i < graph_.loopCount(); ++i) {
      words_.number(graph_.loop(i).steps);
      words_.number(graph_.loop(i).locals);
    }
  }

  void writeOutputs() {
    words_.number(module_.outputs.size());
    for (const Output& output : module_.outputs) {
      words_.text(output.name);
      words_.text(output.method);
      writeShape(output.shape);
      for (const NodeId id : output.components) words_.number(places_[index(id)]);
    }
  }

  void writeComments() {
    words_.number(module_.comments.texts.size());
    for (const std::string& text : module_.comments.texts) words_.text(text);
    words_.number(module_.comments.ranges.size());
    for (const auto& [first, end, text] : module_.comments.ranges) {
      words_.number(places_[index(first)]);
      words_.number(places_[index(end)]);
      words_.number(text);
    }
  }

  const Module& module_;
  const Graph& graph_;
  std::vector<NodeId> retained_;
  std::vector<std::uint32_t> places_;  // by node: the number of retained nodes before it
  WordWriter words_;
};

class Loader {
 public:
  explicit Loader(std::span<const std::uint32_t> words) : words_(words) {}

  Module run() {
    Module module;
    std::vector<Node> graphNodes = readNodes();
    std::vector<Input> graphInputs = readInputs(module);
    std::vector<Function> graphFunctions = readFunctions(module);
    module.graph = Graph(std::move(graphNodes), std::move(graphInputs), std::move(graphFunctions),
                         readLoops());
    readOutputs(module);
    readComments(module);
    return module;
  }

 private:
  NodeId readNode() { return NodeId{words_.number()}; }

  std::vector<Node> readNodes() {
    std::vector<Node> all(words_.number());
    const std::uint32_t* word = words_.block(all.size() * wordsOfNode);
    for (Node& node : all) {
      node.op = Op{static_cast<std::uint8_t>(*word++)};
      for (std::uint32_t& operand : node.operands) operand = *word++;
    }
    return all;
  }

  Shape readShape() {
    const auto columns = static_cast<std::uint8_t>(words_.number());
    return {columns, static_cast<std::uint8_t>(words_.number())};
  }

  std::vector<Input> readInputs(Module& module) {
    std::vector<Input> all(words_.number());
    for (Input& input : all) {
      input.label = words_.text();
      input.shape = readShape();
      if (const std::uint32_t image = words_.number()) input.image = image - 1;
      module.methods.push_back(words_.text());
    }
    return all;
  }

  std::vector<Function> readFunctions(Module& module) {
    std::vector<Function> all(words_.number());
    module.sources.resize(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (words_.number()) {
        const Definition definition = definitionFor(module.library);
        module.library.add(definition);
        all[i] = definition.function;
        continue;
      }
      all[i].name = words_.text();
      all[i].arity = static_cast<int>(words_.number());
      module.sources[i].resize(words_.number());
      for (auto& [family, text] : module.sources[i]) {
        family = words_.text();
        text = words_.text();
      }
    }
    return all;
  }

  Definition definitionFor(Library& library) {
    std::vector<std::uint32_t> words(words_.number());
    if (words.empty()) {
      const Definition::Maker maker = makers[words_.number()];
      return maker(words_.number());
    }
    for (std::uint32_t& word : words) word = words_.number();
    const std::string name{words_.text()};
    return readRecordedFunction(name, words_.number(), std::move(words), library);
  }

  std::vector<Loop> readLoops() {
    std::vector<Loop> all(words_.number());
    for (Loop& loop : all) {
      loop.steps = words_.number();
      loop.locals = words_.number();
    }
    return all;
  }

  void readOutputs(Module& module) {
    module.outputs.resize(words_.number());
    for (Output& output : module.outputs) {
      output.name = words_.text();
      output.method = words_.text();
      output.shape = readShape();
      for (int i = 0; i < output.shape.size(); ++i) output.components.push_back(readNode());
    }
  }

  void readComments(Module& module) {
    module.comments.texts.resize(words_.number());
    for (std::string& text : module.comments.texts) text = words_.text();
    module.comments.ranges.resize(words_.number());
    for (auto& [first, end, text] : module.comments.ranges) {
      first = readNode();
      end = readNode();
      text = words_.number();
    }
  }

  WordReader words_;
};

Graph read(const std::vector<std::uint32_t>& words, std::vector<NodeId>& results) {
  const Module module = load(words);
  results = module.roots();
  return module.graph.copy();
}

}  // namespace

std::vector<NodeId> Module::roots() const {
  std::vector<NodeId> nodes;
  for (const Output& output : outputs)
    nodes.insert(nodes.end(), output.components.begin(), output.components.end());
  return nodes;
}

std::vector<NodeId> Module::roots(std::span<const std::uint32_t> results) const {
  std::vector<NodeId> roots;
  for (const std::uint32_t result : results) {
    const std::vector<NodeId>& components = outputs[result].components;
    roots.insert(roots.end(), components.begin(), components.end());
  }
  return roots;
}

Definition readRecordedFunction(std::string_view name, std::uint32_t variables,
                                std::vector<std::uint32_t> words, Library& library) {
  const Module module = load(words);
  library.addAll(module.library);
  return {.function = {std::string(name), static_cast<int>(module.graph.inputCount()),
                       static_cast<int>(module.roots().size()), static_cast<int>(variables)},
          .words = std::move(words),
          .reader = read};
}

std::vector<std::uint32_t> save(const Module& module) { return Saver(module).run(); }

Module load(std::span<const std::uint32_t> words) { return Loader(words).run(); }

}  // namespace warpjet
