#include "mesh/gltf/draws.hpp"

#include <algorithm>
#include <string>

#include "mesh/gltf/accessor.hpp"
#include "mesh/gltf/morph.hpp"
#include "mesh/messages.hpp"

namespace warpjet {

namespace {

// Returns true if the primitive has triangles and positions; otherwise warns.
bool isDrawn(Gltf& gltf, const tinygltf::Primitive& primitive) {
  if (primitive.mode < 0 || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN)
    throw FileProblem("a primitive has the unknown mode " + std::to_string(primitive.mode) +
                      "; export the model again.");
  if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
    gltf.warn("Points and lines are ignored; only triangles are read.");
    return false;
  }
  if (primitive.attributes.count("POSITION") == 0) {
    gltf.warn("Parts without positions are ignored.");
    return false;
  }
  if (primitive.attributes.count("JOINTS_1") != 0)
    gltf.warn("Vertices that follow more than four bones follow only the first four.");
  return true;
}

bool any(const std::vector<Draw>& draws, const char* attribute) {
  return std::any_of(draws.begin(), draws.end(),
                     [&](const Draw& draw) { return draw.accessor(attribute) != noPlace; });
}

bool all(const std::vector<Draw>& draws, const char* attribute) {
  return std::all_of(draws.begin(), draws.end(),
                     [&](const Draw& draw) { return draw.accessor(attribute) != noPlace; });
}

bool hasEqualColors(const Gltf& gltf, const std::vector<Draw>& draws) {
  const auto first = lookOf(gltf, draws[0].primitive->material).baseColor;
  return std::all_of(draws.begin(), draws.end(), [&](const Draw& draw) {
    return lookOf(gltf, draw.primitive->material).baseColor == first;
  });
}

// Returns true unless every three vertices are a triangle that isn't mirrored, and no vertices are
// left over, which would shift the triangles of the next draw.
bool needsIndices(const Draw& draw, const std::vector<Skin>& skins) {
  const bool isMirrored =
      draw.isSkinned() ? skins[checkIndex("skin", draw.placed->skin, skins.size())].isMirrored
                       : glm::determinant(draw.placed->toWorld) < 0;
  return draw.isIndexed() || draw.kind() != Primitives::Triangles || draw.vertices % 3 != 0 ||
         isMirrored;
}

void checkSize(const std::vector<Draw>& draws, const Layout& layout) {
  const std::uint64_t floats =
      6 + (layout.hasUvs ? 2 : 0) + (layout.hasColors ? 4 : 0) + (layout.hasTangents ? 4 : 0);
  // At most 2^20 draws of 2^32 vertices: no overflow.
  std::uint64_t bytes = 0, targetBytes = 0;
  for (const Draw& draw : draws) {
    targetBytes += std::uint64_t{12} * draw.vertices * draw.weights.size();
    bytes += floats * draw.vertices * sizeof(float);
    if (layout.isIndexed)
      bytes += std::uint64_t{3} * trianglesOf(draw.kind(), draw.corners) * sizeof(std::uint32_t);
  }
  if (bytes > maxMeshBytes)
    throw FileProblem("the model would take " + groupDigits(bytes) + " bytes, but at most " +
                      groupDigits(maxMeshBytes) +
                      " are read; export it with fewer triangles or in several files.");
  // Morph targets are added to the mesh, so that many of them take time, but not memory.
  if (targetBytes > maxMeshBytes)
    throw FileProblem("the model has more active morph targets than are supported, " +
                      groupDigits(targetBytes) + " bytes; export it in its final shape.");
}

}  // namespace

int Draw::accessor(const char* attribute) const {
  const auto found = primitive->attributes.find(attribute);
  return found == primitive->attributes.end() ? noPlace : found->second;
}

std::vector<Draw> drawsOf(Gltf& gltf, const std::vector<Placed>& placed) {
  const auto& meshes = gltf.model.meshes;
  std::vector<Draw> draws;
  std::size_t count = 0;
  for (const Placed& place : placed) {
    const auto& mesh = meshes[checkIndex("mesh", place.mesh, meshes.size())];
    count += mesh.primitives.size();
    if (count > maxDraws) failTooManyDraws();
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
      if (!isDrawn(gltf, primitive)) continue;
      Draw draw{&primitive, &place, 0, 0, {}};
      draw.vertices = countOf(gltf, draw.accessor("POSITION"));
      draw.corners = draw.isIndexed() ? countOf(gltf, primitive.indices) : draw.vertices;
      if (draw.kind() == Primitives::Triangles && draw.corners % 3 != 0)
        gltf.warn("A part ends in the middle of a triangle, which is ignored.");
      draw.weights = morphWeightsOf(gltf, primitive, place);
      if (trianglesOf(draw.kind(), draw.corners) > 0) draws.push_back(draw);
    }
  }
  return draws;
}

Layout layoutOf(Gltf& gltf, const std::vector<Draw>& draws, const std::vector<Skin>& skins) {
  Layout layout{};
  layout.hasEqualColors = hasEqualColors(gltf, draws);
  layout.hasUvs = any(draws, "TEXCOORD_0");
  layout.hasColors = any(draws, "COLOR_0") || !layout.hasEqualColors;
  layout.hasTangents = all(draws, "TANGENT") && all(draws, "NORMAL");
  for (const Draw& draw : draws) layout.isIndexed |= needsIndices(draw, skins);
  if (any(draws, "TANGENT") && !layout.hasTangents)
    gltf.warn("Only some parts have tangents and normals; the tangents are ignored.");
  checkSize(draws, layout);
  return layout;
}

}  // namespace warpjet
