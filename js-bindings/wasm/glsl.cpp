// The bindings of the front end for shader source. A source is parsed once; each function that is
// needed is lowered to a list of operations, as words, which JavaScript replays.
#include "source/glsl/glsl.hpp"

#include <malloc.h>

#include <array>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "embind.hpp"
#include "source/wgsl/wgsl.hpp"

using namespace warpjet::source;

namespace {

// Returns the name of the builder's operation for each code; empty for codes that are no operation.
std::vector<std::string> codes() { return {std::begin(codeNames), std::end(codeNames)}; }

Source* openSource(std::string_view text, bool isWgsl) {
  return new Source(isWgsl ? wgsl::parse(text) : glsl::parse(text));
}

std::uint32_t memoryInUse() { return mallinfo().uordblks; }

}  // namespace

EMSCRIPTEN_BINDINGS(glsl) {
  using namespace emscripten;
  using warpjet::registerArray;

  registerArray<std::uint32_t>();
  registerArray<double>();
  registerArray<std::string>();
  registerArray<HeadParameter>();
  registerArray<FunctionHead>();
  registerArray<HostName>();

  using ColumnsAndRows = std::array<std::uint32_t, 2>;
  value_array<ColumnsAndRows>("Shape")
      .element(emscripten::index<0>())
      .element(emscripten::index<1>());
  value_object<HeadParameter>("Parameter")
      .field("type", &HeadParameter::type)
      .field("name", &HeadParameter::name)
      .field("isOut", &HeadParameter::isOut);
  value_object<FunctionHead>("FunctionHead")
      .field("number", &FunctionHead::number)
      .field("type", &FunctionHead::type)
      .field("name", &FunctionHead::name)
      .field("parameters", &FunctionHead::parameters);
  value_object<HostName>("HostName")
      .field("name", &HostName::name)
      .field("type", &HostName::type)
      .field("isAttribute", &HostName::isAttribute)
      .field("isRead", &HostName::isRead)
      .field("shape", &HostName::shape);
  value_object<Listing>("Listing")
      .field("words", &Listing::words)
      .field("constants", &Listing::constants)
      .field("results", &Listing::results)
      .field("externals", &Listing::names)
      .field("routines", &Listing::routines)
      .field("cutOff", &Listing::cutOff);

  class_<Source>("Source")
      .constructor(&openSource, allow_raw_pointers())
      .function("problem", &Source::problem)
      .function("functions", &Source::functions)
      .function("lower", &Source::lower);

  function("codes", &codes);
  function("memoryInUse", &memoryInUse);
}
