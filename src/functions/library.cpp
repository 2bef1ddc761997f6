#include "functions/library.hpp"

#include "graph/multi_index.hpp"

namespace warpjet {

namespace {

std::uint32_t findOrAddFunction(Graph& graph, const Function& function) {
  const auto known = graph.findFunction(function.name);
  return known ? *known : graph.addFunction(function);
}

}  // namespace

Body* Library::find(std::string_view name) const {
  for (const auto& body : bodies_) {
    if (body->definition.function.name == name) return body.get();
  }
  return nullptr;
}

Library Library::withEmptyCaches() const {
  Library library;
  library.addAll(*this);
  return library;
}

void Library::add(const Definition& definition) {
  if (!find(definition.function.name)) bodies_.push_back(std::make_unique<Body>(definition));
}

const Definition& Library::definition(std::string_view name) const {
  return find(name)->definition;
}

bool Library::isFull() const {
  for (const auto& body : bodies_) {
    if (body->graph.isFull()) return true;
  }
  return false;
}

Numbers Library::call(const Definition& definition, const Numbers& arguments) {
  const Function& function = definition.function;
  add(definition);
  Graph& graph = *arguments[0].graph;
  std::vector<NodeId> nodes;
  for (const Expression& argument : arguments) nodes.push_back(argument.id);
  const NodeId call = graph.call(findOrAddFunction(graph, function), nodes);
  Numbers values;
  for (int i = 0; i < function.values; ++i) values.push_back({&graph, graph.result(call, i)});
  return values;
}

Body& Library::withResults(std::string_view name, int order) {
  Body& body = *find(name);
  const Definition& definition = body.definition;
  const Function& function = definition.function;
  if (!definition.hasBody()) return body;
  if (body.results.empty()) {
    if (definition.reader) body.graph = definition.reader(definition.words, body.results);
    for (int i = 0; i < function.arity; ++i) {
      const std::uint32_t input =
          body.graph.input(definition.argumentName(i), definition.argumentShape(i));
      body.arguments.push_back({&body.graph, body.graph.component(input, 0)});
    }
    if (definition.body) {
      for (const Expression value : definition.body(*this, definition.settings, body.arguments))
        body.results.push_back(value.id);
    }
  }
  const MultiIndices indices(function.variables, order);
  const int known = static_cast<int>(body.results.size()) / function.values;
  for (int i = known; i < indices.count(); ++i) {
    const NodeId variable = body.arguments[indices.lastVariable(i)].id;
    for (int k = 0; k < function.values; ++k) {
      const NodeId origin = body.results[indices.origin(i) * function.values + k];
      body.results.push_back(body.differentiator.derivative(origin, variable));
    }
  }
  return body;
}

Body& Library::withoutCalls(std::string_view name, int order) {
  Body& body = withResults(name, order);
  if (body.withoutCalls.size() < body.results.size())
    body.withoutCalls = inlineCalls(body.graph, *this, body.results);
  return body;
}

}  // namespace warpjet
