// Parses decimal numbers in text files.
#pragma once

#include <optional>
#include <string_view>

namespace warpjet {

// Parses a decimal number such as -1.5e3; returns nullopt for other texts. Accurate to one unit in
// the last place: up to 19 digits are read, and powers of ten are multiplied in double. Overflow
// gives infinity.
std::optional<float> parseFloat(std::string_view text);

// Returns true for spellings of NaN or infinity: "nan", "-nan(ind)", "1.#QNAN", "inf".
bool isPrintedNonNumber(std::string_view text);

}  // namespace warpjet
