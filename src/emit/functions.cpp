#include "emit/functions.hpp"

#include <algorithm>

#include "emit/bundle.hpp"
#include "emit/lower.hpp"

namespace warpjet {

namespace {

// Returns the results as one variable, or one variable per member of a struct.
std::vector<Output> outputsOf(Graph& graph, const Bundle& bundle,
                              const std::vector<NodeId>& results) {
  if (!bundle.isStruct()) return {{"result", vectorOf(bundle.count), results}};
  std::vector<Output> parts;
  for (int i = 0; i < bundle.count; ++i) {
    if (i % Bundle::perPart == 0)
      parts.push_back({Bundle::partName(i / Bundle::perPart), vectorOf(Bundle::perPart), {}});
    parts.back().components.push_back(results[i]);
  }
  parts.back().components.resize(Bundle::perPart, graph.constant(0));
  return parts;
}

}  // namespace

void Declarations::add(const Graph& graph, const EmittedCode& emitted) {
  for (const Op op : emitted.opsWithHelpers)
    define(ops::declaration(op).name, ops::helpers(op, dialect_.language));
  for (const auto& [number, order] : emitted.ourFunctions) define(graph.function(number), order);
}

bool Declarations::isDefined(std::string_view name) const {
  return std::find(defined_.begin(), defined_.end(), name) != defined_.end();
}

void Declarations::define(std::string_view name, std::string_view text) {
  if (isDefined(name)) return;
  defined_.emplace_back(name);
  text_ += text;
}

void Declarations::define(const Function& function, int order) {
  const Bundle bundle(function, order);
  if (isDefined(bundle.function)) return;
  Body& body = library_.withResults(function.name, order);
  if (!body.definition.hasBody()) return define(bundle.function, dialect_.sourceOf(function.name));
  Comments noComments;
  std::vector<NodeId> results(body.results.begin(), body.results.begin() + bundle.count);
  results = lower(body.graph, results, dialect_.language, noComments);
  const std::vector<Output> outputs = outputsOf(body.graph, bundle, results);
  const EmittedCode emitted = emit(body.graph, dialect_, outputs);
  add(body.graph, emitted);

  const std::string type = bundle.type(dialect_);
  std::string result = outputs[0].name;
  if (bundle.isStruct()) {
    for (std::size_t i = 1; i < outputs.size(); ++i) result += ", " + outputs[i].name;
    result = expand(dialect_.construction, {type, result});
  }
  define(bundle.function, bundle.definition(dialect_) + header(type, bundle.function, body) +
                              emitted.code + "return " + result + ";\n}\n");
}

std::string Declarations::header(const std::string& type, const std::string& name,
                                 const Body& body) const {
  const Definition& definition = body.definition;
  std::string parameters;
  for (int i = 0; i < definition.function.arity; ++i) {
    if (i > 0) parameters += ", ";
    const auto kind = dialect_.typeName(ops::Type::Float, definition.argumentShape(i));
    appendExpanded(parameters, dialect_.parameter, {kind, definition.argumentName(i)});
  }
  return expand(dialect_.function, {type, name, parameters});
}

}  // namespace warpjet
