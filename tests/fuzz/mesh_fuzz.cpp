// Fuzz target of src/mesh: loads any bytes as a file, and passes meshes to everything else that
// processes meshes. A first byte below 8 is a number of external files; see split_files.hpp.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "fuzz/gltf_mutator.hpp"
#include "fuzz/require.hpp"
#include "fuzz/split_files.hpp"
#include "mesh/check.hpp"
#include "mesh/gltf/export.hpp"
#include "mesh/load.hpp"
#include "mesh/messages.hpp"
#include "mesh/refine/subdivide.hpp"
#include "mesh/surface/normals.hpp"

namespace warpjet {
namespace {

// Keeps a run far below libFuzzer's limits.
constexpr std::size_t maxTrianglesHere = 2000, maxRefined = 200;

void requireMessage(const std::string& text) {
  require(!text.empty() && text.ends_with('.') && text.find('\n') == text.npos,
          "a problem or warning is one line that ends with a full stop", text);
}

void requireValid(const Mesh& mesh, std::string_view what) {
  const std::string problem = problemOf(mesh);
  require(problem.empty(), what, problem);
}

bool isUnitOrZero(const float* v) {
  const double length = std::hypot(v[0], v[1], v[2]);
  return length == 0 || std::abs(length - 1) < 1e-3;
}

void checkNormals(const Mesh& mesh) {
  const std::vector<float> normals = computeNormals(mesh);
  require(normals.size() == mesh.positions.size(), "each vertex has a normal");
  for (std::size_t i = 0; i < normals.size(); i += 3)
    require(isUnitOrZero(&normals[i]), "computed normals have length 1 or 0",
            std::to_string(normals[i]) + " " + std::to_string(normals[i + 1]) + " " +
                std::to_string(normals[i + 2]));
}

// Requires an exported mesh to be the same when it is loaded. A mesh without triangles can't be
// exported.
void checkExport(const Mesh& mesh) {
  if (mesh.triangleCount() == 0) return;
  const std::vector<std::uint8_t> bytes = exportGlb(mesh);
  const Loaded loaded = loadMesh(bytes);
  require(loaded.mesh.has_value(), "an exported mesh can be loaded", loaded.problem);
  require(loaded.mesh->triangleCount() == mesh.triangleCount(), "no triangle gets lost");
  require(loaded.mesh->positions == mesh.positions, "positions are written as they are");
  require(loaded.mesh->indices == mesh.indices, "triangles are written as they are");
  require(exportGlb(*loaded.mesh) == bytes, "a loaded mesh is exported as the same bytes");
}

// Moves vertices by one of four warps: a smooth one, the identity, a root, which is NaN at negative
// coordinates, and one that overflows floats.
Moved moveVertices(const Mesh& vertices, unsigned which) {
  Moved moved{vertices.positions, which & 1 ? vertices.normals : std::vector<float>{}};
  for (float& x : moved.positions) {
    if (which == 0) x += 0.3f * std::sin(5 * x);
    if (which == 2) x = std::sqrt(x);
    if (which == 3) x *= 1e30f;
  }
  return moved;
}

void checkSubdivision(const Mesh& mesh, unsigned which) {
  const auto warp = [which](const Mesh& vertices) { return moveVertices(vertices, which); };
  const std::size_t maxTriangles = std::max(mesh.triangleCount(), maxRefined);
  const Refined refined = subdivide(mesh, {1e-3f, 0.2f, maxRefined}, warp);
  requireValid(refined.mesh, "a refined mesh is valid");
  require(refined.mesh.triangleCount() <= maxTriangles,
          "there are not more triangles than allowed");
  require(!std::isnan(refined.worst), "the remaining distance is a number");
  const Mesh uniform = subdivideUniformly(mesh, 3, maxRefined).mesh;
  requireValid(uniform, "a subdivided mesh is valid");
  require(uniform.triangleCount() <= maxTriangles, "there are not more triangles than allowed");
}

// Replaces a decoder, which may return anything: fills `size` bytes by repeating the packed
// ones.
std::vector<std::uint8_t> guess(Bytes packed, std::size_t size) {
  std::vector<std::uint8_t> bytes(size);
  for (std::size_t i = 0; i < size && !packed.empty(); ++i) bytes[i] = packed[i % packed.size()];
  return bytes;
}

Pieces guessPieces(const PackedPart& part) {
  const nlohmann::json plan = nlohmann::json::parse(part.plan);
  const std::size_t count = part.bytes.empty() ? 0 : part.bytes[0];
  if (plan["codec"] == "meshopt")
    return {guess(part.bytes,
                  plan["count"].get<std::size_t>() * plan["byteStride"].get<std::size_t>())};
  // The indices are those of three vertices if `count` is odd, otherwise any bytes. `count`
  // vertices of four floats follow for each attribute.
  Pieces pieces{count % 2 ? std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0}
                          : guess(part.bytes, count)};
  for (std::size_t i = 0; i < plan["attributes"].size(); ++i)
    pieces.push_back(guess(part.bytes, count * 16));
  return pieces;
}

// Loads a file with arbitrary contents of its compressed parts.
Loaded loadUnpacked(const SplitFiles& file) {
  ModelFile model(file.bytes);
  try {
    const std::vector<PackedPart> parts = model.packedParts(file.externals);
    for (std::size_t i = 0; i < parts.size(); ++i) model.unpack(i, guessPieces(parts[i]));
  } catch (const FileProblem& problem) {
    requireMessage(problem.what());
  }
  return model.load(file.externals);
}

void check(const SplitFiles& file) {
  const Loaded loaded = loadUnpacked(file);
  require(loaded.mesh.has_value() == loaded.problem.empty(), "there is a mesh or a problem");
  for (const std::string& warning : loaded.warnings) requireMessage(warning);
  if (!loaded.mesh) {
    requireMessage(loaded.problem);
    require(loaded.problem.starts_with("loadMesh: "), "a problem names the function",
            loaded.problem);
    return;
  }
  requireValid(*loaded.mesh, "a loaded mesh is valid");
  if (loaded.mesh->triangleCount() > maxTrianglesHere) return;
  checkNormals(*loaded.mesh);
  checkExport(*loaded.mesh);
  checkSubdivision(*loaded.mesh, static_cast<unsigned>(file.bytes.size() % 4));
}

}  // namespace
}  // namespace warpjet

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  warpjet::check(warpjet::splitFiles({data, size}));
  return 0;
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t maxSize, unsigned seed) {
  const auto mutate = [](std::vector<std::uint8_t>& bytes, std::size_t room) {
    const std::size_t old = bytes.size();
    bytes.resize(std::max(old, room));
    bytes.resize(LLVMFuzzerMutate(bytes.data(), old, bytes.size()));
  };
  const std::vector<std::uint8_t> mutated =
      warpjet::mutateFile({data, data + size}, maxSize, seed, mutate);
  std::copy(mutated.begin(), mutated.end(), data);
  return mutated.size();
}
