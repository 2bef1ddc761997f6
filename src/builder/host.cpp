// The host's variables and functions.
#include <algorithm>
#include <utility>

#include "builder/builder.hpp"
#include "graph/reachable.hpp"
#include "module/messages.hpp"
#include "module/syntax.hpp"

namespace warpjet {

// `position.x`, `position.xz` and `position[0]` are resolved to parts of `position`, so that
// derivatives treat them as the same variable.
int Builder::input(std::string_view method, std::string_view text, Shape shape) {
  const auto found = [&]() -> std::optional<Value> {
    std::string why = text.find_first_not_of(' ') == text.npos
                          ? "it is empty"
                          : syntaxProblem(text, optionalOperators);
    if (!why.empty())
      return reject(method, {quoteShort(text), " cannot be read in a shader: ", why, "."});
    const Label label = readLabel(text);
    if (auto known = findKnownInput(method, label, shape)) return *known;
    const std::uint32_t number = graph_.input(label.text, shape);
    nameInput(number, label, method);
    return allComponents(number);
  }();
  return addResult(found, graph_.size(), method);
}

void Builder::nameInput(std::uint32_t number, const Label& label, std::string_view method) {
  labels_.resize(number + 1);
  module_.methods.resize(number + 1);
  labels_[number] = label;
  module_.methods[number] = method;
  numbers_[label.root].push_back(number);
}

// Finds an input that was read before, or a part of one. Returns nullopt if the input is new, and
// an empty inner optional if it was rejected.
std::optional<std::optional<Value>> Builder::findKnownInput(std::string_view method,
                                                            const Label& label, Shape shape) {
  const std::vector<std::uint32_t>& sameRoot = numbers_[label.root];
  const auto rejected = [&](Parts parts) {
    reject(method, parts);
    return std::optional(std::optional<Value>());
  };
  const auto components = [&](std::uint32_t input, const std::vector<int>& indices) {
    return fill(graph_, shape, [&](int i) {
      return Expression{&graph_, graph_.component(input, indices[i])};
    });
  };
  for (const std::uint32_t i : sameRoot) {
    if (labels_[i].text != label.text) continue;
    const Shape knownShape = graph_.input(i).shape;
    if (knownShape == shape) return allComponents(i);
    return rejected({quoteShort(label.text), " was read as ", shapeName(knownShape),
                     " before, and now as ", shapeName(shape), "."});
  }
  for (const std::uint32_t i : sameRoot) {
    const Shape knownShape = graph_.input(i).shape;
    const auto part = partOf(labels_[i], knownShape, label);
    if (part && static_cast<int>(part->size()) == shape.size()) return components(i, *part);
    // If the label names a part that the known input does not have, such as .w of a vec3, treats it
    // as a new input: the host reports it when it compiles the shader.
    if (isWithin(label, labels_[i]) && !isWithin(labels_[i], label)) return std::nullopt;
  }
  for (const std::uint32_t i : sameRoot) {
    const Label& earlier = labels_[i];
    if (!mayOverlap(earlier, label)) continue;
    const std::string_view whole =
        isWithin(earlier, label) && shape.isMatrix() ? "matrix" : "vector";
    if (isWithin(earlier, label))
      return rejected({quoteShort(earlier.text), " was read before ", quoteShort(label.text),
                       ", of which it is a part; read the ", whole, " first."});
    return rejected({quoteShort(earlier.text), " was read before ", quoteShort(label.text),
                     ", which may have the same components; read the whole ", whole, " first."});
  }
  return std::nullopt;
}

Value Builder::allComponents(std::uint32_t input) {
  return fill(graph_, graph_.input(input).shape, [&](int i) {
    return Expression{&graph_, graph_.component(input, i)};
  });
}

std::uint32_t Builder::inputOf(int handle) {
  return graph_.node(values_.get(graph_, handle)[0].id).operands[0];
}

int Builder::addFunction(std::string_view name, const std::vector<HostText>& sources, int arity) {
  const auto rejectName = [&](std::string_view why) {
    reject("fn", {quoteShort(name), why, "."});
    return failed;
  };
  if (name.starts_with("warpjet"))
    return rejectName(" cannot name a function: such names are reserved for warpjet; rename it");
  if (const auto known = graph_.findFunction(name)) {
    const bool isSame = !graph_.function(*known).isFromLibrary() &&
                        module_.sources[*known] == sources &&
                        graph_.function(*known).arity == arity;
    if (isSame) return static_cast<int>(*known);
    return rejectName(" is already the name of another function; rename one");
  }
  if (arity < 1) return rejectName(" must have at least one argument");
  const std::uint32_t number = graph_.addFunction({std::string(name), arity});
  module_.sources.resize(number);
  module_.sources.push_back(sources);
  return static_cast<int>(number);
}

// Returns true if all calls that a value depends on have their partials; otherwise adds those that
// lack them to `pendingCalls_`.
bool Builder::hasAllPartials(const Value& value) {
  pendingCalls_.clear();
  if (module_.sources.empty()) return true;
  for (const NodeId id : reachable(graph_, value.nodes())) {
    if (graph_.isCall(id) && !graph_.isLibraryCall(id) && !graph_.hasPartials(id))
      pendingCalls_.push_back(id);
  }
  return pendingCalls_.empty();
}

int Builder::functionOfCall(NodeId call) const {
  return static_cast<int>(graph_.node(call).operands[1]);
}

int Builder::argumentOfCall(NodeId call, int i) {
  return values_.add(Expression{&graph_, graph_.arguments(call)[i]});
}

// Returns true if one of the nodes depends on a loop that contains the call: the derivative of that
// loop would depend on itself.
bool Builder::dependsOnLoopOf(NodeId call, std::span<const NodeId> nodes) const {
  if (!graph_.has(foldOp)) return false;
  std::vector<NodeId> folds = reachable(graph_, nodes);
  std::erase_if(folds, [&](NodeId id) { return !graph_.isFold(id); });
  const std::vector<NodeId> needed = reachable(graph_, folds);
  return std::binary_search(needed.begin(), needed.end(), call);
}

bool Builder::setPartials(NodeId call) {
  const std::vector<Value> partials = std::exchange(operands_, {});
  const Function& function = graph_.function(call);
  if (static_cast<int>(partials.size()) != function.arity) {
    reject(function.name,
           {"expected ", std::to_string(function.arity), " derivatives, one per argument, got ",
            std::to_string(partials.size()), "."});
    return false;
  }
  std::vector<NodeId> nodes;
  for (const Value& partial : partials) {
    if (!partial.shape().isNumber()) {
      reject(function.name,
             {"expected a single number as derivative ", std::to_string(nodes.size() + 1), ", got ",
              shapeName(partial.shape()), "."});
      return false;
    }
    nodes.push_back(partial[0].id);
  }
  if (dependsOnLoopOf(call, nodes)) {
    reject(function.name, {"expected derivatives that do not depend on the repeat() in which the "
                           "function is called."});
    return false;
  }
  graph_.setPartials(call, nodes);
  return true;
}

}  // namespace warpjet
