// THE table of features that only one of the two languages has, GLSL ES 1.00 or 3.00. A source with
// #version is in one of them; a source without it may use both.
#pragma once

#include <string>
#include <string_view>

namespace warpjet::source::glsl {

// Returns why a source of that version can't use this feature, and an alternative; empty if it can.
// `what` is a keyword, a symbol, or the name of a feature in the table.
std::string versionProblem(int version, std::string_view what);

}  // namespace warpjet::source::glsl
