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

void requireSentence(const std::string& text) {
  require(!text.empty() && text.ends_with('.') && text.find('\n') == text.npos,
          "a problem or warning is one sentence", text);
}

void requireRight(const Mesh& mesh, std::string_view whose) {
  const std::string problem = problemOf(mesh);
  require(problem.empty(), whose, problem);
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

// A mesh without triangles can't be exported.
void checkExport(const Mesh& mesh) {
  if (mesh.triangleCount() == 0) return;
  const std::vector<std::uint8_t> bytes = exportGlb(mesh);
  const Loaded again = loadMesh(bytes);
  require(again.mesh.has_value(), "what was written is read", again.problem);
  require(again.mesh->triangleCount() == mesh.triangleCount(), "no triangle gets lost");
  require(again.mesh->positions == mesh.positions, "positions are written as they are");
  require(again.mesh->indices == mesh.indices, "triangles are written as they are");
  require(exportGlb(*again.mesh) == bytes, "what was read is written the same");
}

// Four warps: smooth, identity, one with holes, one that overflows floats.
Moved warped(const Mesh& vertices, unsigned which) {
  Moved moved{vertices.positions, which & 1 ? vertices.normals : std::vector<float>{}};
  for (float& x : moved.positions) {
    if (which == 0) x += 0.3f * std::sin(5 * x);
    if (which == 2) x = std::sqrt(x);
    if (which == 3) x *= 1e30f;
  }
  return moved;
}

void checkSubdivision(const Mesh& mesh, unsigned which) {
  const auto warp = [which](const Mesh& vertices) { return warped(vertices, which); };
  const std::size_t most = std::max(mesh.triangleCount(), maxRefined);
  const Refined refined = subdivide(mesh, {1e-3f, 0.2f, maxRefined}, warp);
  requireRight(refined.mesh, "a refined mesh is right");
  require(refined.mesh.triangleCount() <= most, "there are not more triangles than asked for");
  require(!std::isnan(refined.worst), "the distance that is left is a number");
  const Mesh uniform = subdivideUniformly(mesh, 3, maxRefined).mesh;
  requireRight(uniform, "a subdivided mesh is right");
  require(uniform.triangleCount() <= most, "there are not more triangles than asked for");
}

// Fills `size` bytes by repeating the packed ones: a decoder may return anything.
std::vector<std::uint8_t> guess(Bytes packed, std::size_t size) {
  std::vector<std::uint8_t> bytes(size);
  for (std::size_t i = 0; i < size && !packed.empty(); ++i) bytes[i] = packed[i % packed.size()];
  return bytes;
}

Pieces guessPieces(const PackedPart& part) {
  const nlohmann::json plan = nlohmann::json::parse(part.plan);
  const std::size_t some = part.bytes.empty() ? 0 : part.bytes[0];
  if (plan["codec"] == "meshopt")
    return {guess(part.bytes,
                  plan["count"].get<std::size_t>() * plan["byteStride"].get<std::size_t>())};
  // Sometimes the corners of three vertices; at most `some` vertices of four floats.
  Pieces pieces{some % 2 ? std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0}
                         : guess(part.bytes, some)};
  for (std::size_t i = 0; i < plan["attributes"].size(); ++i)
    pieces.push_back(guess(part.bytes, some * 16));
  return pieces;
}

// Loads with arbitrary contents of the compressed parts.
Loaded loadUnpacked(const SplitFiles& file) {
  ModelFile model(file.bytes);
  try {
    const std::vector<PackedPart> parts = model.packedParts(file.externals);
    for (std::size_t i = 0; i < parts.size(); ++i) model.unpack(i, guessPieces(parts[i]));
  } catch (const FileProblem& problem) {
    requireSentence(problem.what());
  }
  return model.load(file.externals);
}

void check(const SplitFiles& file) {
  const Loaded loaded = loadUnpacked(file);
  require(loaded.mesh.has_value() == loaded.problem.empty(), "there is a mesh or a problem");
  for (const std::string& warning : loaded.warnings) requireSentence(warning);
  if (!loaded.mesh) {
    requireSentence(loaded.problem);
    require(loaded.problem.starts_with("loadMesh: "), "a problem has its place", loaded.problem);
    return;
  }
  requireRight(*loaded.mesh, "a mesh that loads is right");
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

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  const auto mutate = [](std::vector<std::uint8_t>& bytes, std::size_t room) {
    const std::size_t old = bytes.size();
    bytes.resize(std::max(old, room));
    bytes.resize(LLVMFuzzerMutate(bytes.data(), old, bytes.size()));
  };
  const std::vector<std::uint8_t> mutated =
      warpjet::mutatedFile({data, data + size}, most, seed, mutate);
  std::copy(mutated.begin(), mutated.end(), data);
  return mutated.size();
}
