// THE table of what only one of the two languages has, GLSL ES 1.00 or 3.00, of which a text with
// #version is one. A text without it may hold both.
#pragma once

#include <string>
#include <string_view>

namespace warpjet::glsl {

// Why a text of that version cannot hold this, and what to write; empty where it can. `what` is a
// word or symbol, or what the table calls a way of writing.
std::string versionProblem(int version, std::string_view what);

}  // namespace warpjet::glsl
