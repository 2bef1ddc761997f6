// Merges statements that apply the same operations to several components into one statement on
// vectors, as a person would write it.
//
// This is superword-level parallelism: Larsen and Amarasinghe, "Exploiting Superword Level
// Parallelism with Multimedia Instruction Sets", 2000. As in that paper, packs of isomorphic
// statements grow along their operands and their readers, and a pack must pay off. The differences:
// the paper starts from adjacent memory accesses, we start from the components of results, which is
// where offset functions have vectors. It counts cycles, we count characters, since GPUs compute
// component by component anyway, and the time to the first frame depends on the length of the code.
// It orders packs by dependence and drops packs with cyclic dependences; the lanes of our packs are
// all on one level, the length of the longest path from the inputs, so no pack can depend on
// itself.
//
//   float t0 = sin(p.x * a);      vec3 t0 = sin(p * a);
//   float t1 = sin(p.y * a);      y = t0 * t0;
//   float t2 = sin(p.z * a);
//   y = vec3(t0 * t0, …);
//
// Two lanes that are rotated by an angle become a matrix times a vector, and a scalar that only one
// vector operation reads is written inline.
//
// Every component has the same bits as its scalar code, except in dot products, these rotations and
// the matrix products of products.hpp, which a language may sum in any order.
#pragma once

#include <vector>

#include "emit/lanes.hpp"
#include "emit/statements.hpp"

namespace warpjet {

// Adds all statements to `packs`, and merges those of each body: of the code outside of loops, and
// of each loop. `nodes` are all nodes that the statements consist of, in ascending order.
void packStatements(const Graph& graph, std::span<const NodeId> nodes, Packs& packs,
                    std::vector<Statements>& bodies, const EmitOptions& options);

}  // namespace warpjet
