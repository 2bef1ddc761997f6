// The data of one call into the mesh wasm module. `npm run reference` generates mesh-tables.ts from
// the names in `jobArrays`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "mesh/load.hpp"
#include "mesh/mesh.hpp"
#include "mesh/refine/subdivide.hpp"

namespace warpjet {

struct Job {
  Mesh mesh;
  Origins origins;                 // of a refined mesh
  std::vector<std::uint8_t> file;  // the input or output file
  // The bytes that the next call takes or returns: an external file that `file` refers to (a
  // buffer, image or .mtl), a compressed part, or a decoded piece.
  std::vector<std::uint8_t> transfer;
  std::optional<ModelFile> model;  // parsed from the file when it is first needed
  Files files;
  std::vector<PackedPart> parts;  // the compressed parts of the model
  Pieces pieces;                  // of the part that is being unpacked
  // The images of the material's base-color texture and normal texture.
  std::vector<std::uint8_t> baseColorImage, baseColorMimeType, normalImage, normalMimeType;
};

template <class Get>
struct JobArray {
  std::string_view name;
  Get get;  // returns the array of a job
};
template <class Get>
JobArray(std::string_view, Get) -> JobArray<Get>;

inline constexpr std::tuple jobArrays{
    JobArray{"positions", [](auto& job) -> decltype(auto) { return (job.mesh.positions); }},
    JobArray{"normals", [](auto& job) -> decltype(auto) { return (job.mesh.normals); }},
    JobArray{"uvs", [](auto& job) -> decltype(auto) { return (job.mesh.uvs); }},
    JobArray{"colors", [](auto& job) -> decltype(auto) { return (job.mesh.colors); }},
    JobArray{"tangents", [](auto& job) -> decltype(auto) { return (job.mesh.tangents); }},
    JobArray{"normalXGradients",
             [](auto& job) -> decltype(auto) { return (job.mesh.gradients[0]); }},
    JobArray{"normalYGradients",
             [](auto& job) -> decltype(auto) { return (job.mesh.gradients[1]); }},
    JobArray{"normalZGradients",
             [](auto& job) -> decltype(auto) { return (job.mesh.gradients[2]); }},
    JobArray{"uGradients", [](auto& job) -> decltype(auto) { return (job.mesh.gradients[3]); }},
    JobArray{"vGradients", [](auto& job) -> decltype(auto) { return (job.mesh.gradients[4]); }},
    JobArray{"indices", [](auto& job) -> decltype(auto) { return (job.mesh.indices); }},
    JobArray{"originEnds", [](auto& job) -> decltype(auto) { return (job.origins.ends); }},
    JobArray{"originTriangles",
             [](auto& job) -> decltype(auto) { return (job.origins.triangles); }},
    JobArray{"baseColorImage", [](auto& job) -> decltype(auto) { return (job.baseColorImage); }},
    JobArray{"baseColorMimeType",
             [](auto& job) -> decltype(auto) { return (job.baseColorMimeType); }},
    JobArray{"normalImage", [](auto& job) -> decltype(auto) { return (job.normalImage); }},
    JobArray{"normalMimeType", [](auto& job) -> decltype(auto) { return (job.normalMimeType); }},
    JobArray{"file", [](auto& job) -> decltype(auto) { return (job.file); }},
    JobArray{"transfer", [](auto& job) -> decltype(auto) { return (job.transfer); }},
    JobArray{"painted", [](auto& job) -> decltype(auto) { return (job.mesh.painted); }},
};

}  // namespace warpjet
