// The words of a language, which nobody can take for a name.
#pragma once

#include <string>
#include <string_view>

namespace warpjet::glsl {

// In a text of that version; one without, 0, has those of both.
bool isKeyword(std::string_view name, int version);

// Whether the language keeps it for later.
bool isReserved(std::string_view name, int version);

// Why nothing can be called so; empty where something can.
std::string nameProblem(std::string_view name, int version);

}  // namespace warpjet::glsl
