// Parses untrusted JSON within limits.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace warpjet {

// Throws a FileProblem for invalid JSON, and for JSON that is nested so deeply or has so many
// values that it would exhaust the stack or the memory of its readers.
nlohmann::json parseJson(std::string_view text);

}  // namespace warpjet
