// The host's variables and functions.
#include <algorithm>
#include <utility>

#include "builder/builder.hpp"
#include "builder/sentences.hpp"
#include "emit/names.hpp"
#include "emit/syntax.hpp"
#include "graph/reachable.hpp"

namespace warpjet {

namespace {

// Whether a text defines or calls a function of that name.
bool hasCall(std::string_view text, std::string_view name) {
  const auto words = identifiers(text);
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return word == name && isCalled(text, word); });
}

// Which components of the vector `whole` the text `part` reads, such as 0 and 2 for `p.xz`; nothing
// if it does something else.
std::vector<int> componentsOf(std::string_view whole, std::string_view part) {
  if (part.size() < whole.size() + 2 || !part.starts_with(whole)) return {};
  const std::string_view rest = part.substr(whole.size());
  if (rest[0] == '[' && rest.size() == 3 && rest[2] == ']' && isDigit(rest[1]))
    return {rest[1] - '0'};
  if (rest[0] != '.' || rest.size() > 5) return {};
  for (const std::string_view letters : {"xyzw", "rgba", "stpq"}) {
    std::vector<int> indices;
    for (const char letter : rest.substr(1)) {
      const std::size_t at = letters.find(letter);
      if (at != letters.npos) indices.push_back(static_cast<int>(at));
    }
    if (indices.size() == rest.size() - 1) return indices;
  }
  return {};
}

// Which vector the text reads a part of, if there is one; else nothing.
std::string_view wholeOf(std::string_view part) {
  const std::string_view whole = part.substr(0, part.find_last_of(".["));
  return componentsOf(whole, part).empty() ? std::string_view() : whole;
}

}  // namespace

int Builder::input(std::string_view method, std::string_view label, Shape shape) {
  const auto found = [&]() -> std::optional<Value> {
    if (const auto known = graph_.inputLabelled(label)) {
      const Shape before = graph_.input(*known).shape;
      if (before == shape) return wholeInput(*known);
      return refuse(method, {quotedShort(label), " was read as ", shapeName(before),
                             " before, and now as ", shapeName(shape), "."});
    }
    const std::string_view whole = wholeOf(label);
    if (const auto vector = graph_.inputLabelled(whole)) {
      if (const auto part = partOfInput(*vector, label, shape)) return part;
    }
    if (const auto part = parts_.find(label); shape.isVector() && part != parts_.end())
      return refuse(method, {quotedShort(part->second), " was read before ", quotedShort(label),
                             ", whose part it is; read the vector first."});
    if (const std::string why = inputProblem(dialect_, label); !why.empty())
      return refuse(method, {quotedShort(label), " cannot be read in a shader: ", why, "."});
    if (!whole.empty()) parts_.emplace(whole, label);
    return wholeInput(graph_.input(label, shape));
  }();
  return finish(found, graph_.size(), method);
}

// `position.x`, `position.xz` and `position[0]` are parts of `position`, so that derivatives know
// that they are the same.
std::optional<Value> Builder::partOfInput(std::uint32_t input, std::string_view label,
                                          Shape shape) {
  const Input& vector = graph_.input(input);
  if (!vector.shape.isVector()) return std::nullopt;
  const std::vector<int> indices = componentsOf(vector.label, label);
  if (indices.empty() || vectorOf(static_cast<int>(indices.size())) != shape) return std::nullopt;
  if (*std::max_element(indices.begin(), indices.end()) >= vector.shape.rows) return std::nullopt;
  return fill(graph_, shape, [&](int i) {
    return Expression{&graph_, graph_.component(input, indices[i])};
  });
}

Value Builder::wholeInput(std::uint32_t input) {
  return fill(graph_, graph_.input(input).shape, [&](int i) {
    return Expression{&graph_, graph_.component(input, i)};
  });
}

int Builder::addFunction(std::string_view name, std::string_view source, int arity) {
  const auto refuseName = [&](std::string_view why, std::string_view detail = ".") {
    refuse("fn", {quotedShort(name), why, detail});
    return failed;
  };
  if (const std::string why = functionProblem(dialect_, name); !why.empty())
    return refuseName(" cannot name a function: ", why + ".");
  if (const auto known = graph_.functionNamed(name)) {
    if (sources_[*known] == source && graph_.function(*known).arity == arity)
      return static_cast<int>(*known);
    return refuseName(" is the name of another function already; rename one");
  }
  if (arity < 1) return refuseName(" must have at least one argument");
  if (!hasCall(source, name))
    return refuseName(" is not in the source, which must define a function of that name");
  const std::uint32_t number = graph_.addFunction({std::string(name), arity});
  sources_.resize(number);
  sources_.emplace_back(source);
  return static_cast<int>(number);
}

// Whether all calls that a value needs have their partials; if not, those that lack them are
// pending.
bool Builder::hasAllPartials(const Value& value) {
  pendingCalls_.clear();
  if (sources_.empty()) return true;
  for (const NodeId id : reachable(graph_, value.nodes())) {
    if (graph_.isCall(id) && !graph_.isOurCall(id) && !graph_.hasPartials(id))
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

bool Builder::setPartials(NodeId call) {
  const std::vector<Value> given = std::exchange(operands_, {});
  const Function& function = graph_.function(call);
  if (static_cast<int>(given.size()) != function.arity) {
    refuse(function.name,
           {std::to_string(function.arity), " derivatives were expected, one for each argument."});
    return false;
  }
  std::vector<NodeId> partials;
  for (const Value& partial : given) {
    if (!partial.shape().isNumber()) {
      refuse(function.name, {"derivative ", std::to_string(partials.size() + 1),
                             " must be a single number, but is ", shapeName(partial.shape()), "."});
      return false;
    }
    partials.push_back(partial[0].id);
  }
  graph_.setPartials(call, partials);
  return true;
}

}  // namespace warpjet
