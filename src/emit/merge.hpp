// Merges the statements of each pack into one, and writes a scalar that only one vector operation
// reads inline. packs.cpp has chosen the packs; those that don't pay off are dissolved here.
#pragma once

#include <span>

#include "emit/lanes.hpp"
#include "emit/statements.hpp"

namespace warpjet {

// `first` is the number of the first statement of the body; `levels` has the level of each
// statement, which reads only statements of lower levels; `hasPacks` is true if the body has any.
void mergeStatements(const Graph& graph, Packs& packs, Statements& body, std::uint32_t first,
                     std::span<const std::uint32_t> levels, const Readers& readers, bool hasPacks,
                     const EmitOptions& options);

}  // namespace warpjet
