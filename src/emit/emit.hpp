// Emission: roots of a graph enter, the statements that compute them leave.
//
// A node that is used once is written where it is used; a node that is used more often becomes a
// temporary. Nothing here recurses, so depth is no limit. Emission knows nothing of warps.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

// A variable that the statements declare and assign: a float or bool, or a vector of up to four.
struct Output {
  // The variable as the sum of an input and an earlier output, where it happens to be one. It only
  // makes the text shorter: `position + offset` instead of three sums.
  struct Sum {
    std::uint32_t input;
    std::size_t output;
  };

  std::string name;
  std::vector<NodeId> components;
  std::optional<Sum> sum = {};
};

struct EmitOptions {
  // The number of nested operations at which an expression becomes a temporary.
  int maxDepth = 8;
  // Comments to put before the statement that computes a node, sorted by node.
  std::vector<std::pair<NodeId, std::string>> comments = {};
};

struct Emitted {
  std::string code;
  std::vector<std::uint32_t> inputs;  // the inputs that the statements read, ascending
  std::size_t nodes = 0;              // graph nodes that the outputs need, leaves included
  std::size_t operations = 0;         // those of them that compute something
  std::size_t temporaries = 0;
};

// Names must have passed `inputProblem` and `outputProblem`, and be distinct.
Emitted emit(const Graph& graph, std::span<const Output> outputs, const EmitOptions& options);

}  // namespace warpjet
