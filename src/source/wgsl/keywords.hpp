// The keywords of WGSL and its reserved words, which can't be used as names.
#pragma once

#include <string>
#include <string_view>

namespace warpjet::source::wgsl {

bool isKeyword(std::string_view name);

// Returns the reason why this isn't a valid name; empty if it is valid.
std::string nameProblem(std::string_view name);

}  // namespace warpjet::source::wgsl
