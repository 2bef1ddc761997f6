// Lowering: replaces operations that a language lacks by others that it has.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "graph/graph.hpp"
#include "module/comments.hpp"

namespace warpjet {

// Returns true if the graph contains an operation that the language lacks.
bool usesMissing(const Graph& graph, ops::Language language);

// Returns an operation that the language lacks and that can't be lowered; nullopt if there is none.
std::optional<Op> findUnsupported(const Graph& graph, std::span<const NodeId> roots,
                                  ops::Language language);

// Returns nodes that have the same values as `roots` and that the language can express. A
// replacement inherits the comment of its node. Differentiate before lowering: the derivative of an
// operation is shorter than that of its replacement.
std::vector<NodeId> lower(Graph& graph, std::span<const NodeId> roots, ops::Language language,
                          Comments& comments);

}  // namespace warpjet
