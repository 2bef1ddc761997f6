// Decimal numbers in text files.
#pragma once

#include <optional>
#include <string_view>

namespace warpjet {

// A decimal number such as -1.5e3, or nothing. Right to the last bit or next to it: up to 19 digits
// are read, and powers of ten are multiplied in double. Too large a number is infinite.
std::optional<float> parsedFloat(std::string_view text);

// Whether it is what programs print for NaN or an infinity: "nan", "-nan(ind)", "1.#QNAN", "inf".
bool isPrintedNonNumber(std::string_view text);

}  // namespace warpjet
