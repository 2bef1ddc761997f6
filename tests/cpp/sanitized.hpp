// Whether AddressSanitizer is at work, where all takes ten times as long: what it looks for is
// found with fewer numbers, and the native tests have all of them.
#pragma once

namespace warpjet {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool isSanitized = true;
#elif defined(__has_feature)
inline constexpr bool isSanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool isSanitized = false;
#endif

}  // namespace warpjet
