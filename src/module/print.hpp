// Prints a module, one node per line, then its results, for debugging and for tests.
#pragma once

#include <string>

#include "module/module.hpp"

namespace warpjet {

std::string print(const Module& module);

}  // namespace warpjet
