// What of a glTF is to be drawn, before any vertex is read.
#pragma once

#include <vector>

#include "mesh/gltf/gltf.hpp"
#include "mesh/gltf/look.hpp"
#include "mesh/gltf/morph.hpp"
#include "mesh/gltf/scene.hpp"
#include "mesh/gltf/skin.hpp"
#include "mesh/gltf/triangles.hpp"

namespace warpjet {

// One primitive of a mesh where one node puts it; `corners` are those of its strip, fan or
// triangles.
struct Draw {
  const tinygltf::Primitive* primitive;
  const Placed* placed;
  std::size_t vertices, corners;
  std::vector<MorphWeight> weights;

  Primitives kind() const { return Primitives{primitive->mode}; }
  bool isIndexed() const { return primitive->indices != noPlace; }
  // Whether it stands where bones take it, and not where its node is.
  bool isSkinned() const {
    return placed->skin >= 0 && accessor("JOINTS_0") != noPlace && accessor("WEIGHTS_0") != noPlace;
  }

  // The accessor of an attribute, or noPlace.
  int accessor(const char* attribute) const;
};

// All that make triangles. Points, lines and what has no positions are left out with a warning.
// Throws a FileProblem.
std::vector<Draw> drawsOf(Gltf& gltf, const std::vector<Placed>& placed);

// Which arrays the merged mesh has. Tangents come only where all have them, since nobody can guess
// them, and only with normals, as glTF demands.
struct Layout {
  bool hasUvs, hasColors, hasTangents;
  bool isIndexed;       // whether triangles need indices
  bool hasEqualColors;  // whether the base colour is the same everywhere
};

// Throws a FileProblem if a draw has no such skin, or if the mesh would be larger than
// mostMeshBytes.
Layout layoutOf(Gltf& gltf, const std::vector<Draw>& draws, const std::vector<Skin>& skins);

}  // namespace warpjet
