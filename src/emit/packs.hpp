// Statements that do the same to the components of something become one statement on vectors, as a
// person writes it.
//
// The idea is superword-level parallelism: Larsen and Amarasinghe, "Exploiting Superword Level
// Parallelism with Multimedia Instruction Sets", 2000. From them we have packs of statements alike,
// which grow along what they read and along what reads them, and that a pack must pay for itself.
// They start from neighbours in memory; we start from the components of results, which is where
// sketches have their vectors. They count cycles; we count characters, since GPUs compute component
// by component anyway, and what a first frame waits for is the length of the text. They order packs
// by dependence, and give up those that wait for each other; here lanes are of one level, the
// longest way from the inputs, so that no pack can wait for itself.
//
//   float t0 = sin(p.x * a);      vec3 t0 = sin(p * a);
//   float t1 = sin(p.y * a);      y = t0 * t0;
//   float t2 = sin(p.z * a);
//   y = vec3(t0 * t0, …);
//
// A pair that is turned by an angle is a matrix times a vector, and a number that only one vector
// reads stands beside it without a name.
//
// Every component keeps the bits of its own scalar text, but for dot products, those matrices and
// those of products.hpp, which a language may add up in any order.
#pragma once

#include <vector>

#include "emit/lanes.hpp"
#include "emit/statements.hpp"

namespace warpjet {

// Tells `packs` of all statements, and merges those of each body: of the text, and of its loops.
// `nodes` are all that they are made of, ascending.
void packStatements(const Graph& graph, std::span<const NodeId> nodes, Packs& packs,
                    std::vector<Statements>& bodies, const EmitOptions& options);

}  // namespace warpjet
