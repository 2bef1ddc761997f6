// What of a glTF material a Mesh can carry: base colour and base-colour texture.
#pragma once

#include <array>
#include <optional>

#include "mesh/gltf/gltf.hpp"
#include "mesh/mesh.hpp"

namespace warpjet {

constexpr int noPlace = -1;

// The base colour is from 0 to 1, whatever the file says; `picture` is a place among the model's
// images, or noPlace.
struct Look {
  std::array<double, 4> baseColor{1, 1, 1, 1};
  int picture = noPlace;

  bool operator==(const Look&) const = default;
};

// Of a material's place, or of noPlace: white. Throws a FileProblem.
Look lookOf(const Gltf& gltf, int material);

// Warns where a material's colour or texture is not one that a Mesh can carry.
void warnOfLook(Gltf& gltf, int material);

// A picture as the file has it, still encoded. One that is not there is a warning.
std::optional<Image> pictureOf(Gltf& gltf, int picture, const Files& files);

// The uris of all materials' pictures of base colours; empty for those inside of a buffer.
std::vector<std::string> picturesOf(const Gltf& gltf);

}  // namespace warpjet
