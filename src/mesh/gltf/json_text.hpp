// JSON text from outside, parsed within limits.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace warpjet {

// Throws a FileProblem for what is no JSON, and for what is nested so deeply or has so many values
// that it would exhaust the stack or the memory of whoever walks it.
nlohmann::json parseJson(std::string_view text);

}  // namespace warpjet
