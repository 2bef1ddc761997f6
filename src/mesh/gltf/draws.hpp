// The parts of a glTF to draw, determined before any vertex is read.
#pragma once

#include <vector>

#include "mesh/gltf/gltf.hpp"
#include "mesh/gltf/look.hpp"
#include "mesh/gltf/morph.hpp"
#include "mesh/gltf/scene.hpp"
#include "mesh/gltf/skin.hpp"
#include "mesh/gltf/triangles.hpp"

namespace warpjet {

// One primitive of a mesh, placed by one node; `corners` is the number of corners in its strip, fan
// or triangles.
struct Draw {
  const tinygltf::Primitive* primitive;
  const Placed* placed;
  std::size_t vertices, corners;
  std::vector<MorphWeight> weights;

  Primitives kind() const { return Primitives{primitive->mode}; }
  bool isIndexed() const { return primitive->indices != noPlace; }
  // Returns true if bones place the draw, and not its node.
  bool isSkinned() const {
    return placed->skin >= 0 && accessor("JOINTS_0") != noPlace && accessor("WEIGHTS_0") != noPlace;
  }

  // Returns the accessor of an attribute, or noPlace.
  int accessor(const char* attribute) const;
};

// Returns all draws of triangles. Points, lines and primitives without positions are skipped with a
// warning. Throws a FileProblem.
std::vector<Draw> drawsOf(Gltf& gltf, const std::vector<Placed>& placed);

// The arrays of the merged mesh. It has tangents only if all draws have them, since missing ones
// can't be guessed, and only if all draws have normals, as glTF requires.
struct Layout {
  bool hasUvs, hasColors, hasTangents;
  bool isIndexed;       // true if triangles need indices
  bool hasEqualColors;  // true if the base color is the same everywhere
};

// Determines the arrays. Throws a FileProblem if a draw's skin doesn't exist, or if the mesh would
// be larger than maxMeshBytes.
Layout layoutOf(Gltf& gltf, const std::vector<Draw>& draws, const std::vector<Skin>& skins);

}  // namespace warpjet
