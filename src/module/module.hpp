// The compiled offset function: a graph, its results, and everything needed to write them in any
// language or to run them. It is independent of languages; readers never modify it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "functions/library.hpp"
#include "graph/graph.hpp"
#include "module/comments.hpp"

namespace warpjet {

// A result. `method` is the method that requested it, which messages about its name refer to.
struct Output {
  std::string name;
  Shape shape;
  std::vector<NodeId> components;
  std::string method = {};
};

// The source of a host function in a family of languages.
struct HostText {
  std::string family, text;

  bool operator==(const HostText&) const = default;
};

struct Module {
  Graph graph;
  std::vector<std::string> methods;            // by input: the method that requested it
  std::vector<std::vector<HostText>> sources;  // by function; empty for our own
  Library library;                             // definitions of our own functions
  std::vector<Output> outputs;
  Comments comments;

  std::vector<NodeId> roots() const;
  // Returns the components of these results, given by number.
  std::vector<NodeId> roots(std::span<const std::uint32_t> results) const;
};

// Returns the numbers of the inputs that these results depend on, in ascending order.
std::vector<std::uint32_t> inputsRead(const Module& module, std::span<const std::uint32_t> results);

// Serializes the module to plain words, without anything that no output needs. The words are
// independent of the module and its memory.
std::vector<std::uint32_t> save(const Module& module);

// Returns the function of a serialized module, whose `variables` are its first arguments, and adds
// the functions that it calls to the library.
[[gnu::noinline]] Definition readRecordedFunction(std::string_view name, std::uint32_t variables,
                                                  std::vector<std::uint32_t> words,
                                                  Library& library);

// Deserializes words of `save`. The graph can't grow; its copies can.
Module load(std::span<const std::uint32_t> words);

}  // namespace warpjet
