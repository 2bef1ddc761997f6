// `isSanitized` is true under AddressSanitizer, where tests take ten times as long: fewer samples
// are enough to find memory errors, and the build without sanitizers tests all of them.
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
