// Messages about the goals that a subdivision didn't reach.
#pragma once

#include <string>
#include <vector>

#include "mesh/refine/subdivide.hpp"

namespace warpjet {

std::vector<std::string> shortfallOf(const Refined& refined, const Refinement& refinement);

}  // namespace warpjet
