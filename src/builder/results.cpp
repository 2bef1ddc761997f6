// The results that the host is given: as text, or as a program for the CPU.
#include <algorithm>

#include "builder/builder.hpp"
#include "builder/declarations.hpp"
#include "builder/sentences.hpp"
#include "emit/lower.hpp"
#include "emit/names.hpp"
#include "graph/reachable.hpp"

namespace warpjet {

bool Builder::output(std::string_view method, std::string_view name, int handle) {
  if (const std::string why = outputProblem(dialect_, name); !why.empty()) {
    refuse(method, {quotedShort(name), " cannot name a result: ", why, "."});
    return false;
  }
  if (outputNames_.contains(name)) {
    refuse(method, {"there are two results named ", quotedShort(name), "; rename one."});
    return false;
  }
  const Value value = values_.get(graph_, handle);
  const Shape shape = value.shape();
  if (shape.isMatrix() && !shape.isSquare() && !dialect_.hasRectangularMatrices) {
    refuse(method, {"the result ", quotedShort(name), " is ", shapeName(shape),
                    ", but WebGL 1 has only matrices of as many rows as columns; take its columns "
                    "by .column(0)."});
    return false;
  }
  outputNames_.emplace(name);
  outputs_.push_back({std::string(name), shape, {value.nodes().begin(), value.nodes().end()}});
  return true;
}

bool Builder::outputSum(std::string_view method, std::string_view name, int handle, int input,
                        int term) {
  if (!output(method, name, handle)) return false;
  const NodeId first = values_.get(graph_, input)[0].id;
  outputs_.back().sum = {graph_.node(first).operands[0], static_cast<std::size_t>(term)};
  return true;
}

std::vector<NodeId> Builder::roots() const {
  std::vector<NodeId> nodes;
  for (const Output& output : outputs_)
    nodes.insert(nodes.end(), output.components.begin(), output.components.end());
  return nodes;
}

bool Builder::dependsOn(int handle, int input) {
  const Value value = values_.get(graph_, handle), from = values_.get(graph_, input);
  const auto inputs = from.nodes();
  const std::vector<NodeId> nodes = reachable(graph_, value.nodes());
  return std::find_first_of(nodes.begin(), nodes.end(), inputs.begin(), inputs.end()) !=
         nodes.end();
}

std::optional<Program> Builder::program() {
  std::vector<NodeId> nodes;
  for (const Value& value : operands_)
    nodes.insert(nodes.end(), value.nodes().begin(), value.nodes().end());
  operands_.clear();
  problem_.clear();
  for (const NodeId id : reachable(graph_, nodes)) {
    const bool isImage =
        graph_.isInput(id) && graph_.input(graph_.node(id).operands[0]).shape == oneImage;
    if (isImage) return std::nullopt;
  }
  const std::vector<NodeId> inlined = inlineCalls(graph_, library_, nodes);
  if (isFull()) return refuse("A result", {tooLarge});
  return warpjet::program(graph_, inlined);
}

std::optional<Built> Builder::build(std::optional<int> maxDepth) {
  constexpr std::string_view site = "A result";
  problem_.clear();
  // Every value was searched when it was made; but a sketch may catch a problem and go on.
  if (wasImpossible_) {
    for (const NodeId id : reachable(graph_, roots())) {
      if (const auto* why = impossible(id)) return refuse(site, {*why});
    }
  }
  Comments comments = comments_;
  const std::vector<Output> outputs = lowered(comments);
  if (isFull()) return refuse(site, {tooLarge});

  EmitOptions options;
  if (maxDepth) {
    options.maxDepth = *maxDepth;
    options.maxReads = EmitOptions::mostReads;
  }
  Built built{emit(graph_, dialect_, outputs, options, comments), {}};
  for (const std::uint32_t function : built.emitted.functions)
    built.declarations += sources_[function] + '\n';
  Declarations declarations(dialect_, library_);
  declarations.add(graph_, built.emitted);
  built.declarations += declarations.text();
  if (isFull()) return refuse(site, {tooLarge});
  if (hidesWhatIsRead(built.emitted, declarations.text())) return std::nullopt;
  return built;
}

// The outputs in operations that the language has.
std::vector<Output> Builder::lowered(Comments& comments) {
  const std::vector<NodeId> nodes = lower(graph_, roots(), dialect_.language, comments);
  std::vector<Output> outputs = outputs_;
  auto node = nodes.begin();
  for (Output& output : outputs) {
    for (NodeId& component : output.components) component = *node++;
  }
  return outputs;
}

// A result named like a variable or function that the text reads would hide it, and a variable
// cannot have the name of a function. `helpers` is the text of functions of ours.
bool Builder::hidesWhatIsRead(const Emitted& emitted, std::string_view helpers) {
  const auto refusesResult = [&](std::string_view name, std::string_view read) {
    if (!outputNames_.contains(name)) return false;
    refuse({}, {"The result ", quotedShort(name),
                " has the name of a variable or function that is read for it (", quotedShort(read),
                "); rename the result."});
    return true;
  };
  std::set<std::string_view> variables;
  for (const std::uint32_t i : emitted.inputs) {
    const std::string& label = graph_.input(i).label;
    for (const std::string_view word : identifiers(label)) {
      if (refusesResult(word, label)) return true;
      if (!isCalled(label, word)) variables.insert(word);
    }
  }
  std::vector<std::string_view> functions;
  for (const std::uint32_t i : emitted.functions) functions.push_back(graph_.function(i).name);
  for (const std::string_view word : identifiers(helpers)) {
    if (word.starts_with(ourPrefix)) functions.push_back(word);
  }
  for (const std::string_view name : functions) {
    if (refusesResult(name, name)) return true;
    if (!variables.contains(name)) continue;
    refuse({}, {quotedShort(name), " is both a variable and a function; rename one."});
    return true;
  }
  return false;
}

}  // namespace warpjet
