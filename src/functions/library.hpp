// The functions of ours that a graph calls, and what is in them.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "diff/differentiator.hpp"
#include "functions/definition.hpp"

namespace warpjet {

// A function's own graph, whose inputs are its arguments.
struct Body {
  explicit Body(Definition given) : definition(std::move(given)) {}
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  Definition definition;
  Graph graph;
  Differentiator differentiator{graph};
  Numbers arguments;
  // As many as were asked for, numbered as Function says; and the same without calls.
  std::vector<NodeId> results, withoutCalls;
};

class Library {
 public:
  // Another one that knows the same functions; what is derived there stays there.
  Library fresh() const;

  void add(const Definition& definition);
  void addAll(const Library& others) {
    for (const auto& body : others.bodies_) add(body->definition);
  }
  const Definition& definition(std::string_view name) const;

  // The values of a call, in the graph of the arguments.
  Numbers call(const Definition& definition, const Numbers& arguments);

  // With all `results` up to that order of derivatives; with none if the function has no body.
  Body& withResults(std::string_view name, int order);
  // The same, and as many in `withoutCalls`. Not of a function without a body.
  Body& withoutCalls(std::string_view name, int order);

  // Whether the nodes of one of them are too many, and so without meaning.
  bool isFull() const;

 private:
  Body* find(std::string_view name) const;

  std::vector<std::unique_ptr<Body>> bodies_;
};

// The same nodes with the bodies of our functions in the place of calls, and those of folds as
// often as they are run, in the same graph.
std::vector<NodeId> inlineCalls(Graph& graph, Library& library, std::span<const NodeId> roots);

// The same without loops alone.
std::vector<NodeId> unrolled(Graph& graph, std::span<const NodeId> roots);

}  // namespace warpjet
