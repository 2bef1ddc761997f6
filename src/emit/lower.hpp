// Lowering: operations that a language lacks become others that it has.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "graph/graph.hpp"
#include "module/comments.hpp"

namespace warpjet {

// Whether an operation of the graph is one that the language lacks.
bool lacksAny(const Graph& graph, ops::Language language);

// The name of an operation that the language lacks and that nothing else can say, or nothing.
std::string_view refused(const Graph& graph, std::span<const NodeId> roots, ops::Language language);

// Nodes of the same values as `roots`, which the language can write; what was made for a node gets
// its comment. Derivatives must have been taken before: a row's own are shorter than those of what
// it is lowered to.
std::vector<NodeId> lower(Graph& graph, std::span<const NodeId> roots, ops::Language language,
                          Comments& comments);

}  // namespace warpjet
