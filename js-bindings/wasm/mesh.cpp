// The bindings of meshes. JavaScript fills the arrays of a job, calls its functions, reads the
// arrays, and deletes it. No exception reaches JavaScript: functions that can fail return an
// outcome with a message.
#include <malloc.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "embind.hpp"
#include "job.hpp"
#include "mesh/check.hpp"
#include "mesh/gltf/export.hpp"
#include "mesh/gltf/unit.hpp"
#include "mesh/messages.hpp"
#include "mesh/refine/shortfall.hpp"
#include "mesh/refine/subdivide.hpp"
#include "mesh/surface/normals.hpp"
#include "mesh/surface/variation.hpp"

using namespace warpjet;
using emscripten::val;

namespace {

using Texts = std::vector<std::string>;

struct Outcome {
  std::string problem;  // empty if there is none
  Texts texts = {};
};

constexpr const char* noMemory = "there is not enough memory for so large a mesh.";

// Returns the outcome of `work`, which may throw.
template <class Work>
Outcome attempt(Work&& work) {
  try {
    return {{}, work()};
  } catch (const std::bad_alloc&) {
    return {noMemory};
  } catch (const std::length_error&) {
    return {noMemory};
  } catch (const FileProblem& problem) {
    return {problem.what()};
  } catch (const std::exception& problem) {
    return {std::string("the mesh cannot be handled (") + problem.what() + ")."};
  }
}

// Returns the array of a job with this name and type.
template <class Number>
std::vector<Number>& arrayOf(Job& job, std::string_view name) {
  std::vector<Number>* found = nullptr;
  const auto consider = [&](const auto& each) {
    if constexpr (std::is_same_v<std::decay_t<decltype(each.get(job))>, std::vector<Number>>)
      if (each.name == name) found = &each.get(job);
  };
  std::apply([&](const auto&... each) { (consider(each), ...); }, jobArrays);
  if (!found) throw std::out_of_range(std::string(name));
  return *found;
}

template <class Number>
View<Number> read(Job& job, std::string_view name) {
  return View(arrayOf<Number>(job, name));
}

// Resizes an array to the length of `numbers`.
template <class Number>
Outcome resize(Job& job, std::string_view name, const val& numbers) {
  return attempt([&]() -> Texts {
    arrayOf<Number>(job, name).resize(numbers["length"].as<std::size_t>());
    return {};
  });
}

// Copies numbers from JavaScript.
template <class Number>
Outcome fill(Job& job, std::string_view name, const val& numbers) {
  Outcome outcome = resize<Number>(job, name, numbers);
  if (!outcome.problem.empty()) return outcome;
  auto& array = arrayOf<Number>(job, name);
  val(emscripten::typed_memory_view(array.size(), array.data())).call<void>("set", numbers);
  return outcome;
}

// Returns the four numbers of the material; empty if there is none.
std::vector<float> baseColor(const Job& job) {
  if (!job.mesh.material) return {};
  const auto& color = job.mesh.material->baseColor;
  return {color.begin(), color.end()};
}

void setBaseColor(Job& job, const std::vector<float>& color) {
  if (!job.mesh.material) job.mesh.material.emplace();
  std::copy_n(color.begin(), 4, job.mesh.material->baseColor.begin());
}

std::uint32_t triangleCount(const Job& job) {
  return static_cast<std::uint32_t>(job.mesh.triangleCount());
}

// Adds `transfer` to the files that the model refers to.
Outcome keepFile(Job& job, const std::string& name) {
  return attempt([&]() -> Texts {
    job.files[name] = std::exchange(job.transfer, {});
    return {};
  });
}

// Returns the URIs of the other files that the file needs.
Outcome findFiles(Job& job) {
  return attempt([&] { return job.model.emplace(job.file).externalFiles(job.files); });
}

// Call it after findFiles. Returns the plans of the compressed parts (gltf/packed_part.hpp).
Outcome findPacked(Job& job) {
  return attempt([&] {
    job.parts = job.model->packedParts(job.files);
    Texts plans;
    for (const PackedPart& part : job.parts) plans.push_back(part.plan);
    return plans;
  });
}

// Copies the bytes of a compressed part into `transfer`.
Outcome openPacked(Job& job, std::uint32_t part) {
  return attempt([&]() -> Texts {
    const Bytes bytes = job.parts.at(part).bytes;
    job.transfer.assign(bytes.begin(), bytes.end());
    return {};
  });
}

// Appends `transfer` to the decoded pieces, which `unpack` takes.
Outcome keepPiece(Job& job) {
  return attempt([&]() -> Texts {
    job.pieces.push_back(std::exchange(job.transfer, {}));
    return {};
  });
}

// Replaces a compressed part by the decoded pieces.
Outcome unpack(Job& job, std::uint32_t part) {
  return attempt([&]() -> Texts {
    job.model->unpack(part, std::exchange(job.pieces, {}));
    return {};
  });
}

// Removes the method, since JavaScript puts the name of the called function before every message.
std::string withoutMethod(const std::string& message) {
  const std::string method = "loadMesh: ";
  return message.starts_with(method) ? message.substr(method.size()) : message;
}

// Loads a mesh from the file. The texts are warnings.
Outcome loadFile(Job& job) {
  return attempt([&]() -> Texts {
    if (!job.model) job.model.emplace(job.file);
    Loaded loaded = job.model->load(job.files);
    job.model.reset();
    if (!loaded.mesh) throw FileProblem(withoutMethod(loaded.problem));
    job.mesh = std::move(*loaded.mesh);
    if (job.mesh.material && job.mesh.material->baseColorTexture) {
      const auto& [bytes, mimeType] = *job.mesh.material->baseColorTexture;
      job.baseColorImage = bytes;
      job.baseColorMimeType.assign(mimeType.begin(), mimeType.end());
    }
    return std::move(loaded.warnings);
  });
}

// Checks that the arrays of the mesh fit together.
Outcome checkMesh(Job& job) {
  return attempt([&]() -> Texts {
    std::string problem = problemOf(job.mesh);
    if (!problem.empty()) throw FileProblem(problem);
    return {};
  });
}

// Computes the normals of a checked mesh that has none.
Outcome addNormals(Job& job) {
  return attempt([&]() -> Texts {
    if (job.mesh.normals.empty()) job.mesh.normals = computeNormals(job.mesh);
    return {};
  });
}

// Computes the surface variation of a checked mesh with normals.
Outcome addVariation(Job& job) {
  return attempt([&]() -> Texts {
    addSurfaceVariation(job.mesh);
    return {};
  });
}

// Replaces the normals of a checked mesh by unit normals, as they are written to files.
Outcome normalizeNormals(Job& job) {
  return attempt([&]() -> Texts {
    job.mesh.normals = unitNormals(job.mesh);
    return {};
  });
}

// Moves the bytes of a texture into the material.
void setTexture(std::optional<Image>& texture, std::vector<std::uint8_t>& bytes,
                const std::string& name) {
  if (bytes.empty()) return;
  if (!pictureType(bytes))
    throw FileProblem("material." + name +
                      " must be the bytes of a PNG or JPEG file, which these are not.");
  texture = Image{std::move(bytes), {}};
}

// Writes a checked mesh to a file.
Outcome writeFile(Job& job) {
  return attempt([&]() -> Texts {
    if (job.mesh.material) {
      setTexture(job.mesh.material->baseColorTexture, job.baseColorImage, "baseColorTexture");
      setTexture(job.mesh.material->normalTexture, job.normalImage, "normalTexture");
    }
    job.file = exportGlb(job.mesh);
    return {};
  });
}

// A job that JavaScript uses during one call, and does not delete.
struct Borrowed {
  Job* job;
};

// Subdivides a checked mesh where the warp needs it. `warp` receives a job and moves its vertices;
// it may drop its normals. It returns `false` if it fails, and must not throw. The texts say which
// goals were not reached.
Outcome refine(Job& job, float tolerance, float angle, std::uint32_t maxTriangles,
               const val& warp) {
  const auto moveVertices = [&](const Mesh& vertices) -> Moved {
    Job moved;
    moved.mesh = vertices;
    if (!warp(Borrowed{&moved}).as<bool>()) throw std::runtime_error("the warp failed");
    return {std::move(moved.mesh.positions), std::move(moved.mesh.normals)};
  };
  return attempt([&] {
    const Refinement refinement{tolerance, angle, maxTriangles};
    Refined refined = subdivide(job.mesh, refinement, moveVertices);
    Texts texts = shortfallOf(refined, refinement);
    job.mesh = std::move(refined.mesh);
    job.origins = std::move(refined.origins);
    return texts;
  });
}

// Subdivides each triangle of a checked mesh `levels` times.
Outcome refineUniformly(Job& job, int levels, std::uint32_t maxTriangles) {
  return attempt([&] {
    Divided divided = subdivideUniformly(job.mesh, levels, maxTriangles);
    Texts texts;
    if (divided.levels < levels)
      texts = {"Of " + std::to_string(levels) + " levels only " + std::to_string(divided.levels) +
               " were made, with " + groupDigits(divided.mesh.triangleCount()) +
               " triangles, for maxTriangles is " + groupDigits(maxTriangles) + '.'};
    job.mesh = std::move(divided.mesh);
    job.origins = std::move(divided.origins);
    return texts;
  });
}

std::uint32_t memoryInUse() { return static_cast<std::uint32_t>(mallinfo().uordblks); }

}  // namespace

template <>
struct emscripten::internal::BindingType<Borrowed> {
  using WireType = Job*;
  static WireType toWireType(const Borrowed& borrowed) { return borrowed.job; }
};
template <>
struct emscripten::internal::TypeID<Borrowed> {
  static constexpr TYPEID get() { return LightTypeID<Job*>::get(); }
};

EMSCRIPTEN_BINDINGS(mesh) {
  using namespace emscripten;

  registerArray<float>();
  registerArray<std::string>();
  registerView<float>();
  registerView<std::uint8_t>();
  registerView<std::uint32_t>();

  value_object<Outcome>("Outcome")
      .field("problem", &Outcome::problem)
      .field("texts", &Outcome::texts);

  class_<Job>("Mesh")
      .constructor<>()
      .function("floats", &read<float>)
      .function("indices", &read<std::uint32_t>)
      .function("bytes", &read<std::uint8_t>)
      .function("resizeFloats", &resize<float>)
      .function("setFloats", &fill<float>)
      .function("setIndices", &fill<std::uint32_t>)
      .function("setBytes", &fill<std::uint8_t>)
      .function("baseColor", &baseColor)
      .function("setBaseColor", &setBaseColor)
      .function("triangleCount", &triangleCount)
      .function("keepFile", &keepFile)
      .function("findFiles", &findFiles)
      .function("findPacked", &findPacked)
      .function("openPacked", &openPacked)
      .function("keepPiece", &keepPiece)
      .function("unpack", &unpack)
      .function("loadFile", &loadFile)
      .function("checkMesh", &checkMesh)
      .function("addNormals", &addNormals)
      .function("addVariation", &addVariation)
      .function("normalizeNormals", &normalizeNormals)
      .function("writeFile", &writeFile)
      .function("refine", &refine)
      .function("refineUniformly", &refineUniformly);

  function("memoryInUse", &memoryInUse);
}
