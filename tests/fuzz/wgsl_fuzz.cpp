// Fuzz target of the front end of WGSL.
#include <cstdint>
#include <string>

#include "fuzz/source_check.hpp"
#include "source/wgsl/wgsl.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  using namespace warpjet::source;
  check(Source(wgsl::parse(text)));
  return 0;
}
