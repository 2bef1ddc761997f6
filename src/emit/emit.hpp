// Emission: roots of a graph enter, the statements that compute them leave.
//
// A node that is used once is written where it is used; a node that is used more often becomes a
// temporary, and so does one that would nest too deep or read too much. Nothing here recurses, so
// depth is no limit. Emission knows nothing of warps.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "emit/dialect.hpp"
#include "module/module.hpp"

namespace warpjet {

struct EmitOptions {
  // The number of nested operations at which an expression becomes a temporary.
  int maxDepth = 8;
  // The number of temporaries that an expression reads at most, as far as it can be cut, since what
  // waits to be read stays alive; see schedule.hpp for what was tried.
  std::uint32_t maxReads = 4;
  // As good as no limit, but a bound for what is remembered of an expression.
  static constexpr std::uint32_t mostReads = 64;
  // Whether equal operations on components are written as one on vectors; see packs.hpp.
  bool vectors = true;
};

// A function of ours, with its derivatives up to an order.
struct OurFunction {
  std::uint32_t number;
  int order;

  bool operator==(const OurFunction&) const = default;
};

struct Emitted {
  std::string code;
  std::vector<std::uint32_t> inputs;      // the inputs that the statements read, ascending
  std::vector<std::uint32_t> functions;   // the functions of the host that they call, ascending
  std::vector<OurFunction> ourFunctions;  // those of ours, each once
  std::vector<Op> helped;                 // the operations that call helpers, each once
  std::size_t nodes = 0;                  // graph nodes that the outputs need, leaves included
  std::size_t operations = 0;             // those of them that compute something
  std::size_t temporaries = 0;
  std::size_t vectors = 0;  // those of them that are
};

// What each input is in this language, if the host calls it by its label.
std::vector<std::string> inputTexts(const Graph& graph, const Dialect& dialect);

// Names must have passed `inputProblem` and `outputProblem`, and be distinct. The outputs must have
// been lowered to what the dialect has. `inputs` has the host's text of each input.
Emitted emit(const Graph& graph, const Dialect& dialect, std::span<const Output> outputs,
             const EmitOptions& options, const Comments& comments,
             std::span<const std::string> inputs);
inline Emitted emit(const Graph& graph, const Dialect& dialect, std::span<const Output> outputs,
                    const EmitOptions& options = {}, const Comments& comments = {}) {
  return emit(graph, dialect, outputs, options, comments, inputTexts(graph, dialect));
}

}  // namespace warpjet
