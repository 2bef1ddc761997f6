// The border to JavaScript of meshes: plain C, since a call has numbers and addresses only.
// JavaScript fills the arrays of a job, calls, reads them, and closes it. No exception crosses: a
// function that may fail returns whether it went well, and leaves a sentence.
#include <emscripten.h>
#include <malloc.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "job.hpp"
#include "mesh/check.hpp"
#include "mesh/gltf/export.hpp"
#include "mesh/refine/shortfall.hpp"
#include "mesh/refine/subdivide.hpp"
#include "mesh/sentences.hpp"
#include "mesh/surface/normals.hpp"
#include "mesh/surface/variation.hpp"

using namespace warpjet;

namespace {

// Does something with an array of a job.
template <class Visitor>
auto withArray(Job& job, int array, const Visitor& visit) {
  decltype(visit(job.file)) result{};
  int number = 0;
  const auto consider = [&](const auto& each) {
    if (number++ == array) result = visit(each.of(job));
  };
  std::apply([&](const auto&... each) { (consider(each), ...); }, jobArrays);
  return result;
}

// Whether `work` went well; `work` says so, or throws.
template <class Work>
int attempt(Job& job, Work&& work) {
  job.texts.clear();
  try {
    return work() ? 1 : 0;
  } catch (const std::bad_alloc&) {
    job.texts = {"there is not enough memory for so large a mesh."};
  } catch (const FileProblem& problem) {
    job.texts = {problem.what()};
  } catch (const std::exception& problem) {
    job.texts = {std::string("the mesh cannot be handled (") + problem.what() + ")."};
  }
  return 0;
}

}  // namespace

extern "C" {

// In JavaScript: moves the vertices of the job's mesh; the normals may get lost. Whether it could.
int evaluateWarp(Job* vertices);
}

namespace {

// JavaScript puts the name of what the user called before every sentence.
std::string withoutMethod(const std::string& sentence) {
  const std::string method = "loadMesh: ";
  return sentence.starts_with(method) ? sentence.substr(method.size()) : sentence;
}

Moved warped(const Mesh& vertices) {
  Job job;
  job.mesh = vertices;
  if (!evaluateWarp(&job)) throw std::runtime_error("the warp failed");
  return {std::move(job.mesh.positions), std::move(job.mesh.normals)};
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE Job* openJob() { return new (std::nothrow) Job; }

EMSCRIPTEN_KEEPALIVE void closeJob(Job* job) { delete job; }

// Makes room for so many elements. Their address, or 0 if there is no memory.
EMSCRIPTEN_KEEPALIVE void* resizeArray(Job* job, int array, std::uint32_t count) {
  try {
    return withArray(*job, array, [&](auto& elements) -> void* {
      elements.resize(count);
      return elements.data();
    });
  } catch (const std::exception&) {
    return nullptr;
  }
}

EMSCRIPTEN_KEEPALIVE const void* arrayAddress(Job* job, int array) {
  return withArray(*job, array,
                   [](const auto& elements) -> const void* { return elements.data(); });
}

EMSCRIPTEN_KEEPALIVE std::uint32_t arrayCount(Job* job, int array) {
  return withArray(*job, array, [](const auto& elements) {
    return static_cast<std::uint32_t>(elements.size());
  });
}

// The sentences or names that the last call left.
EMSCRIPTEN_KEEPALIVE int textCount(Job* job) { return static_cast<int>(job->texts.size()); }
EMSCRIPTEN_KEEPALIVE const char* textAddress(Job* job, int i) { return job->texts[i].data(); }
EMSCRIPTEN_KEEPALIVE std::uint32_t textSize(Job* job, int i) {
  return static_cast<std::uint32_t>(job->texts[i].size());
}

EMSCRIPTEN_KEEPALIVE int hasMaterial(Job* job) { return job->mesh.material.has_value(); }

// Its four numbers. There is a material from now on.
EMSCRIPTEN_KEEPALIVE float* baseColor(Job* job) {
  if (!job->mesh.material) job->mesh.material.emplace();
  return job->mesh.material->baseColor.data();
}

// Moves `contents` among the further files, as `name`.
EMSCRIPTEN_KEEPALIVE int keepFile(Job* job) {
  return attempt(*job, [&] {
    job->files[std::string(job->name.begin(), job->name.end())] = std::move(job->contents);
    job->contents.clear();
    return true;
  });
}

// The texts are the URIs of the further files that the file needs.
EMSCRIPTEN_KEEPALIVE int findFiles(Job* job) {
  return attempt(*job, [&] {
    job->texts = job->model.emplace(job->file).externalFiles(job->files);
    return true;
  });
}

// After findFiles. The texts are the plans of the compressed parts (gltf/packed_part.hpp).
EMSCRIPTEN_KEEPALIVE int findPacked(Job* job) {
  return attempt(*job, [&] {
    job->parts = job->model->packedParts(job->files);
    for (const PackedPart& part : job->parts) job->texts.push_back(part.plan);
    return true;
  });
}

// Copies the bytes of a compressed part into `contents`.
EMSCRIPTEN_KEEPALIVE int openPacked(Job* job, std::uint32_t part) {
  return attempt(*job, [&] {
    const Bytes bytes = job->parts.at(part).bytes;
    job->contents.assign(bytes.begin(), bytes.end());
    return true;
  });
}

// Moves `contents` behind the decoded pieces of the next part.
EMSCRIPTEN_KEEPALIVE int keepPiece(Job* job) {
  return attempt(*job, [&] {
    job->pieces.push_back(std::exchange(job->contents, {}));
    return true;
  });
}

// Puts the pieces in the place of a compressed part.
EMSCRIPTEN_KEEPALIVE int unpack(Job* job, std::uint32_t part) {
  return attempt(*job, [&] {
    job->model->unpack(part, std::exchange(job->pieces, {}));
    return true;
  });
}

// From file to mesh. The texts are warnings, or the sentence.
EMSCRIPTEN_KEEPALIVE int loadFile(Job* job) {
  return attempt(*job, [&] {
    if (!job->model) job->model.emplace(job->file);
    Loaded loaded = job->model->load(job->files);
    job->model.reset();
    if (!loaded.mesh) {
      job->texts = {withoutMethod(loaded.problem)};
      return false;
    }
    job->texts = std::move(loaded.warnings);
    job->mesh = std::move(*loaded.mesh);
    if (job->mesh.material && job->mesh.material->baseColorTexture) {
      const auto& [bytes, mimeType] = *job->mesh.material->baseColorTexture;
      job->picture = bytes;
      job->mimeType.assign(mimeType.begin(), mimeType.end());
    }
    return true;
  });
}

// Whether the arrays of the mesh fit together.
EMSCRIPTEN_KEEPALIVE int checkMesh(Job* job) {
  return attempt(*job, [&] {
    std::string problem = problemOf(job->mesh);
    if (problem.empty()) return true;
    job->texts = {std::move(problem)};
    return false;
  });
}

// Computes the normals of a checked mesh that has none.
EMSCRIPTEN_KEEPALIVE int addNormals(Job* job) {
  return attempt(*job, [&] {
    if (job->mesh.normals.empty()) job->mesh.normals = computeNormals(job->mesh);
    return true;
  });
}

// Finds how a checked mesh with normals varies.
EMSCRIPTEN_KEEPALIVE int addVariation(Job* job) {
  return attempt(*job, [&] {
    addSurfaceVariation(job->mesh);
    return true;
  });
}

// From a checked mesh to a file.
EMSCRIPTEN_KEEPALIVE int writeFile(Job* job) {
  return attempt(*job, [&] {
    if (!job->picture.empty()) {
      if (!pictureType(job->picture)) {
        job->texts = {
            "material.baseColorTexture must be the bytes of a PNG or JPEG file, which "
            "these are not."};
        return false;
      }
      job->mesh.material->baseColorTexture = Image{std::move(job->picture), {}};
    }
    job->file = exportGlb(job->mesh);
    return true;
  });
}

// From a checked mesh to one of more triangles. The texts say what was not reached.
EMSCRIPTEN_KEEPALIVE int refine(Job* job, float tolerance, float angle,
                                std::uint32_t maxTriangles) {
  return attempt(*job, [&] {
    const Refinement refinement{tolerance, angle, maxTriangles};
    Refined refined = subdivide(job->mesh, refinement, warped);
    job->texts = shortfallOf(refined, refinement);
    job->mesh = std::move(refined.mesh);
    job->origins = std::move(refined.origins);
    return true;
  });
}

// The same.
EMSCRIPTEN_KEEPALIVE int refineUniformly(Job* job, int levels, std::uint32_t maxTriangles) {
  return attempt(*job, [&] {
    Divided divided = subdivideUniformly(job->mesh, levels, maxTriangles);
    if (divided.levels < levels)
      job->texts = {"Of " + std::to_string(levels) + " levels only " +
                    std::to_string(divided.levels) + " were made, with " +
                    grouped(divided.mesh.triangleCount()) + " triangles, for maxTriangles is " +
                    grouped(maxTriangles) + '.'};
    job->mesh = std::move(divided.mesh);
    job->origins = std::move(divided.origins);
    return true;
  });
}

// Bytes that are allocated now.
EMSCRIPTEN_KEEPALIVE std::uint32_t memoryInUse() {
  return static_cast<std::uint32_t>(mallinfo().uordblks);
}

}  // extern "C"
