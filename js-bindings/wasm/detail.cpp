// The bindings of detail: a mesh that is divided as finely as its warped surface needs it on the
// screen. JavaScript fills the arrays of a mesh, evaluates the warp at its samples, and reads the
// arrays of the divided mesh. The bound objects live as long as the mesh.
#include "detail/detail.hpp"

#include <emscripten.h>
#include <malloc.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "detail/criterion.hpp"
#include "detail/tessellation_table.hpp"
#include "detail/topology.hpp"
#include "embind.hpp"

using namespace warpjet;

namespace {

using Words = std::vector<std::uint32_t>;

// Makes a mesh with arrays to fill. `sizes` has the number of components of each attribute, and
// `areUnit` a nonzero number for unit vectors. The first attribute has the positions.
Detail* makeDetail(const Words& sizes, const Words& areUnit, std::uint32_t vertices,
                   std::uint32_t triangles, const Words& groups, bool isCurved) {
  std::vector<Attribute> attributes;
  for (std::size_t i = 0; i < sizes.size(); ++i)
    attributes.push_back(
        {sizes[i], areUnit[i] != 0, std::vector<float>(std::size_t{sizes[i]} * vertices)});
  return new Detail(std::move(attributes), triangles, groups, isCurved);
}

View<float> given(Detail& detail, std::uint32_t attribute) { return View(detail.given(attribute)); }
View<std::uint32_t> givenIndices(Detail& detail) { return View(detail.givenIndices()); }
View<float> sample(const Detail& detail, std::uint32_t attribute) {
  return View(detail.samples()[attribute].values);
}
View<float> attribute(const Detail& detail, std::uint32_t attribute) {
  return View(detail.division().attributes[attribute].values);
}
View<std::uint32_t> indices(const Detail& detail) { return View(detail.indices()); }
View<std::uint32_t> groups(const Detail& detail) { return View(detail.groups()); }

// Returns the address of a mesh, for the functions that do without embind.
std::uint32_t address(const Detail& detail) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(&detail));
}

// The following functions return what compute passes read: the base mesh, the numbers of pieces of
// its edges, and the numbers of the criterion.
Words topology(const Detail& detail) { return topologyOf(detail.base()); }
Words pieces(const Detail& detail) { return {detail.pieces().begin(), detail.pieces().end()}; }
std::uint32_t vertexCount(const Detail& detail) {
  return static_cast<std::uint32_t>(detail.base().vertexCount());
}
std::vector<float> criterionNumbers() {
  const Criterion& c = criterion;
  return {c.margin, c.nearest, c.aside,      c.away,      c.beyondFlat,
          c.error,  c.aim,     c.hysteresis, c.minLength, c.minGain};
}
Words pieceNumbers() { return {pieceCounts.begin(), pieceCounts.end()}; }

// `fronts` has three numbers for each front: its profile, `first` and `second`.
void setPhases(Detail& detail, const Words& sizes, const std::vector<float>& steps,
               const std::vector<float>& fronts) {
  std::vector<Front> all;
  for (std::size_t i = 0; i < fronts.size(); i += 3) {
    const auto profile = static_cast<Profile>(static_cast<std::uint32_t>(fronts[i]));
    all.push_back({profile, fronts[i + 1], fronts[i + 2]});
  }
  detail.setPhases(sizes, steps, std::move(all));
}

View<std::uint32_t> words(const TessellationTable& table) { return View(table.words()); }

std::uint32_t memoryInUse() { return mallinfo().uordblks; }

}  // namespace

// Functions that are called in each frame. Embind would allocate JavaScript objects in each call.
extern "C" {
EMSCRIPTEN_KEEPALIVE float* detail_phases(Detail* detail) { return detail->phases().data(); }
EMSCRIPTEN_KEEPALIVE bool detail_cut(Detail* detail, float maxLength) {
  return detail->cut(maxLength);
}
EMSCRIPTEN_KEEPALIVE bool detail_is_coarse(const Detail* detail, float maxLength) {
  return detail->isCoarse(maxLength);
}

EMSCRIPTEN_KEEPALIVE void detail_forget_samples(Detail* detail) { detail->forgetSamples(); }
EMSCRIPTEN_KEEPALIVE float* detail_warped(Detail* detail) { return detail->warped().data(); }

// Each view has 19 numbers: a matrix by columns, half of the size of the viewport in pixels, and
// `ScreenView::facing`.
EMSCRIPTEN_KEEPALIVE float* detail_views(Detail* detail, std::uint32_t numbers) {
  detail->viewNumbers().resize(numbers);
  return detail->viewNumbers().data();
}
// Returns the number of samples to warp.
EMSCRIPTEN_KEEPALIVE std::uint32_t detail_show(Detail* detail, bool listsSamples) {
  return static_cast<std::uint32_t>(detail->show(listsSamples).size());
}
EMSCRIPTEN_KEEPALIVE const std::uint32_t* detail_missing_samples(const Detail* detail) {
  return detail->missingSamples().data();
}

EMSCRIPTEN_KEEPALIVE bool detail_update(Detail* detail, float tolerance) {
  return detail->update(tolerance);
}
EMSCRIPTEN_KEEPALIVE bool detail_stays_exact(const Detail* detail) { return detail->staysExact(); }
}  // extern "C"

EMSCRIPTEN_BINDINGS(detail) {
  using namespace emscripten;

  registerArray<std::uint32_t>();
  registerArray<float>();
  registerView<float>();
  registerView<std::uint32_t>();

  class_<Detail>("Detail")
      .constructor(&makeDetail, allow_raw_pointers())
      .function("given", &given)
      .function("givenIndices", &givenIndices)
      .function("begin", &Detail::begin)
      .function("pose", &Detail::pose)
      .function("setPhases", &setPhases)
      .function("sampleCount", &Detail::sampleCount)
      .function("cutSampleCount", &Detail::cutSampleCount)
      .function("sample", &sample)
      .function("address", &address)
      .function("attribute", &attribute)
      .function("indices", &indices)
      .function("groups", &groups)
      .function("origins", &Detail::origins)
      .function("lines", &Detail::lines)
      .function("topology", &topology)
      .function("pieces", &pieces)
      .function("isCurved", &Detail::isCurved)
      .function("divideBase", &Detail::divideBase)
      .function("vertexCount", &vertexCount);

  class_<TessellationTable>("TessellationTable")
      .constructor<>()
      .function("makeNext", &TessellationTable::makeNext)
      .function("words", &words);

  function("criterionNumbers", &criterionNumbers);
  function("pieceNumbers", &pieceNumbers);

  function("memoryInUse", &memoryInUse);
}
