// Emission: takes roots of a graph, returns the statements that compute them.
//
// A node that is used once is written inline; a node that is used more often becomes a temporary,
// and so does one that would nest too deeply or read too many temporaries. Nothing here recurses,
// so depth is unlimited. Emission knows nothing of warps.
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
  // The depth of nested operations at which an expression becomes a temporary.
  int maxDepth = 8;
  // The max number of temporaries that an expression reads, as far as it can be split: temporaries
  // stay alive until they are read. schedule.hpp lists the alternatives tried.
  std::uint32_t maxReads = 4;
  // Practically no limit, but it bounds the sets that are stored per expression.
  static constexpr std::uint32_t maxTrackedReads = 64;
  // Writes equal operations on components as one operation on vectors; see packs.hpp.
  bool vectors = true;
};

// One of our own functions, with its derivatives up to an order.
struct OurFunction {
  std::uint32_t number;
  int order;

  bool operator==(const OurFunction&) const = default;
};

struct EmittedCode {
  std::string code;
  std::vector<std::uint32_t> inputs;      // the inputs that the statements read, ascending
  std::vector<std::uint32_t> functions;   // host functions that they call, ascending
  std::vector<OurFunction> ourFunctions;  // our own functions that they call, without duplicates
  std::vector<Op> opsWithHelpers;  // operations that need helper functions, without duplicates
  std::size_t nodes = 0;           // graph nodes that the outputs need, including leaves
  std::size_t operations = 0;      // the nodes that compute something
  std::size_t temporaries = 0;
  std::size_t vectors = 0;  // temporaries that are vectors
};

// Returns the expression of each input in this language, if the host uses its label as its name.
std::vector<std::string> inputExpressions(const Graph& graph, const Dialect& dialect);

// Names must have passed `inputProblem` and `outputProblem`, and be distinct. The outputs must have
// been lowered to operations of the dialect. `inputs` holds the host's expression for each input.
EmittedCode emit(const Graph& graph, const Dialect& dialect, std::span<const Output> outputs,
                 const EmitOptions& options, const Comments& comments,
                 std::span<const std::string> inputs);
inline EmittedCode emit(const Graph& graph, const Dialect& dialect, std::span<const Output> outputs,
                        const EmitOptions& options = {}, const Comments& comments = {}) {
  return emit(graph, dialect, outputs, options, comments, inputExpressions(graph, dialect));
}

}  // namespace warpjet
