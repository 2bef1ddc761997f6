// Our own functions that a graph calls, and their bodies.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "diff/differentiator.hpp"
#include "functions/definition.hpp"

namespace warpjet {

// A function's own graph. Its inputs are the function's arguments.
struct Body {
  explicit Body(Definition source) : definition(std::move(source)) {}
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  Definition definition;
  Graph graph;
  Differentiator differentiator{graph};
  Numbers arguments;
  // The results requested to date, numbered as Function describes; and the same results with all
  // calls inlined.
  std::vector<NodeId> results, withoutCalls;
};

class Library {
 public:
  // Returns a library of the same functions with empty caches. Results that are added to it don't
  // change this library.
  Library withEmptyCaches() const;

  void add(const Definition& definition);
  void addAll(const Library& others) {
    for (const auto& body : others.bodies_) add(body->definition);
  }
  const Definition& definition(std::string_view name) const;

  // Calls a function in the graph of the arguments; returns its values.
  Numbers call(const Definition& definition, const Numbers& arguments);

  // Returns the body with all `results` up to that order of derivatives; without results if the
  // function has no body.
  Body& withResults(std::string_view name, int order);
  // Like `withResults`, but also fills `withoutCalls` up to that order. Requires a function with a
  // body.
  Body& withoutCalls(std::string_view name, int order);

  // Returns true if the graph of a body has reached its limit, which makes its nodes meaningless.
  bool isFull() const;

 private:
  Body* find(std::string_view name) const;

  std::vector<std::unique_ptr<Body>> bodies_;
};

// Replaces calls of our functions by their bodies, and unrolls folds, in the same graph.
std::vector<NodeId> inlineCalls(Graph& graph, Library& library, std::span<const NodeId> roots);

// The max number of nodes of a graph whose folds are unrolled so that more is known about each
// step.
inline constexpr std::size_t maxUnrolledNodes = 20'000;

// Tests whether there are folds, which all have a fixed number of steps and together at most
// `maxUnrolledNodes` nodes.
bool canUnroll(const Graph& graph);

// Unrolls folds, but keeps calls.
std::vector<NodeId> unrollFolds(Graph& graph, std::span<const NodeId> roots);

}  // namespace warpjet
