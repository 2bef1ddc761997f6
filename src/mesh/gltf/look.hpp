// The part of a glTF material that a Mesh supports: base color and base-color texture.
#pragma once

#include <array>
#include <optional>

#include "mesh/gltf/gltf.hpp"
#include "mesh/mesh.hpp"

namespace warpjet {

constexpr int noPlace = -1;

// The base color is clamped to 0 to 1; `image` is the index of an image of the model, or noPlace.
struct Look {
  std::array<double, 4> baseColor{1, 1, 1, 1};
  int image = noPlace;

  bool operator==(const Look&) const = default;
};

// Takes a material's index; white for noPlace. Throws a FileProblem.
Look lookOf(const Gltf& gltf, int material);

// Warns if a Mesh doesn't support a material's color or texture.
void warnOfLook(Gltf& gltf, int material);

// Returns an image as stored in the file, still encoded. A missing image is a warning.
std::optional<Image> readImage(Gltf& gltf, int image, const Files& files);

// Returns the URIs of the base-color images of all materials; empty strings for images inside of a
// buffer.
std::vector<std::string> imageUris(const Gltf& gltf);

}  // namespace warpjet
