// What a sketch's function becomes, once: a graph, its results, and all that is needed to write
// them in any language or to run them. It knows no language; whoever reads it changes nothing.
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

// A result. `method` asked for it and is to blame for its name.
struct Output {
  std::string name;
  Shape shape;
  std::vector<NodeId> components;
  std::string method = {};
};

// A function of the host is a text of each family of languages that the sketch gave it in.
struct HostText {
  std::string family, text;

  bool operator==(const HostText&) const = default;
};

struct Module {
  Graph graph;
  std::vector<std::string> methods;            // by input, what asked for it
  std::vector<std::vector<HostText>> sources;  // by function; of ours none
  Library library;                             // what ours are
  std::vector<Output> outputs;
  Comments comments;

  std::vector<NodeId> roots() const;
};

// The numbers of the inputs that these results depend on, in ascending order.
std::vector<std::uint32_t> inputsRead(const Module& module, std::span<const std::uint32_t> results);

// Plain words that say the same, without what no output needs; they need neither the module nor
// its memory.
std::vector<std::uint32_t> save(const Module& module);

// The function whose module these words are, by its first `variables` arguments; what it calls is
// added to the library.
[[gnu::noinline]] Definition recordedFrom(std::string_view name, std::uint32_t variables,
                                          std::vector<std::uint32_t> words, Library& library);

// From words of `save`. Nothing can be added to its graph but in a copy.
Module load(std::span<const std::uint32_t> words);

}  // namespace warpjet
