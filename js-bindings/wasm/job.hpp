// The data that enters and leaves one call of the module of meshes. Its arrays have names, which
// `npm run reference` writes for JavaScript.
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
  Origins origins;  // of a refined mesh
  // The input or output file, and the next one of the further files that it needs.
  std::vector<std::uint8_t> file, contents;
  std::optional<ModelFile> model;  // parsed from the file when it is first needed
  Files files;
  std::vector<PackedPart> parts;  // the compressed ones of the model
  Pieces pieces;                  // of the part that is being unpacked
  // The textures of the base color and of normals.
  std::vector<std::uint8_t> picture, mimeType, normalPicture, normalMimeType;
};

template <class Of>
struct JobArray {
  std::string_view name;
  Of of;  // a job
};
template <class Of>
JobArray(std::string_view, Of) -> JobArray<Of>;

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
    JobArray{"ends", [](auto& job) -> decltype(auto) { return (job.origins.ends); }},
    JobArray{"triangles", [](auto& job) -> decltype(auto) { return (job.origins.triangles); }},
    JobArray{"picture", [](auto& job) -> decltype(auto) { return (job.picture); }},
    JobArray{"mimeType", [](auto& job) -> decltype(auto) { return (job.mimeType); }},
    JobArray{"normalPicture", [](auto& job) -> decltype(auto) { return (job.normalPicture); }},
    JobArray{"normalMimeType", [](auto& job) -> decltype(auto) { return (job.normalMimeType); }},
    JobArray{"file", [](auto& job) -> decltype(auto) { return (job.file); }},
    JobArray{"contents", [](auto& job) -> decltype(auto) { return (job.contents); }},
    JobArray{"painted", [](auto& job) -> decltype(auto) { return (job.mesh.painted); }},
};

}  // namespace warpjet
