#include "mesh/gltf/merge.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "mesh/gltf/accessor.hpp"
#include "mesh/gltf/draws.hpp"
#include "mesh/gltf/morph.hpp"
#include "mesh/gltf/place.hpp"
#include "mesh/gltf/range.hpp"
#include "mesh/messages.hpp"
#include "mesh/surface/normals.hpp"

namespace warpjet {

namespace {

// Appends an attribute of a draw, or its default if the draw has none.
void append(const Gltf& gltf, const Draw& draw, const char* attribute, int minWidth, int width,
            float filler, std::vector<float>& numbers) {
  const std::size_t end = numbers.size() + draw.vertices * static_cast<std::size_t>(width);
  const int accessor = draw.accessor(attribute);
  if (accessor == noPlace) return numbers.resize(end, filler);
  if (countOf(gltf, accessor) != draw.vertices)
    throw FileProblem("a part has " + groupDigits(draw.vertices) + " positions, but " +
                      groupDigits(countOf(gltf, accessor)) + " of " + attribute +
                      "; export the model again.");
  appendFloats(gltf, accessor, minWidth, width, numbers);
}

void appendIndices(const Gltf& gltf, const Draw& draw, std::size_t firstVertex,
                   std::vector<std::uint32_t>& indices) {
  std::vector<std::uint32_t> corners(draw.isIndexed() ? 0 : draw.corners);
  std::iota(corners.begin(), corners.end(), 0u);
  if (draw.isIndexed()) corners = indicesOf(gltf, draw.primitive->indices);
  for (std::uint32_t& corner : corners) {
    if (corner >= draw.vertices)
      throw FileProblem("a triangle uses vertex " + groupDigits(corner) +
                        ", but its part has only " + groupDigits(draw.vertices) +
                        ", counted from 0; export the model again.");
    corner += static_cast<std::uint32_t>(firstVertex);
  }
  corners = separateTriangles(draw.kind(), std::move(corners));
  indices.insert(indices.end(), corners.begin(), corners.end());
}

// Multiplies the base color of a part into its vertices.
void tint(std::vector<float>& colors, std::size_t firstVertex, const Look& look) {
  for (std::size_t i = firstVertex * 4; i < colors.size(); ++i)
    colors[i] = static_cast<float>(colors[i] * look.baseColor[i % 4]);
}

// Transforms the vertices by their node or their bones.
void transform(const Gltf& gltf, const Draw& draw, const std::vector<Skin>& skins,
               std::size_t firstVertex, std::size_t firstIndex, Mesh& mesh) {
  if (!draw.isSkinned()) return place(mesh, firstVertex, firstIndex, draw.placed->toWorld);
  const Skin& skin = skins[checkIndex("skin", draw.placed->skin, skins.size())];
  std::vector<float> joints, weights;
  append(gltf, draw, "JOINTS_0", 4, 4, 0, joints);
  append(gltf, draw, "WEIGHTS_0", 4, 4, 0, weights);
  pose(mesh, firstVertex, firstIndex, skin, joints, weights);
}

void appendDraw(Gltf& gltf, const Draw& draw, const Layout& layout, const std::vector<Skin>& skins,
                Mesh& mesh) {
  const std::size_t firstVertex = mesh.vertexCount();
  const std::size_t firstIndex = mesh.indices.size();
  append(gltf, draw, "POSITION", 3, 3, 0, mesh.positions);
  append(gltf, draw, "NORMAL", 3, 3, 0, mesh.normals);
  if (layout.hasUvs) append(gltf, draw, "TEXCOORD_0", 2, 2, 0, mesh.uvs);
  if (layout.hasColors) append(gltf, draw, "COLOR_0", 3, 4, 1, mesh.colors);
  if (layout.hasTangents) append(gltf, draw, "TANGENT", 4, 4, 0, mesh.tangents);
  makeUnit(gltf, mesh.normals, firstVertex * 3, 3, "Normals");
  makeUnit(gltf, mesh.tangents, firstVertex * 4, 4, "Tangents");
  if (!draw.weights.empty()) {
    morph(gltf, *draw.primitive, draw.weights, firstVertex, mesh);
    makeUnit(mesh.normals, firstVertex * 3, 3);
    makeUnit(mesh.tangents, firstVertex * 4, 4);
  }
  clampColors(gltf, mesh.colors, firstVertex * 4);
  if (layout.isIndexed) appendIndices(gltf, draw, firstVertex, mesh.indices);
  if (!layout.hasEqualColors)
    tint(mesh.colors, firstVertex, lookOf(gltf, draw.primitive->material));
  transform(gltf, draw, skins, firstVertex, firstIndex, mesh);
}

void reserve(const std::vector<Draw>& draws, const Layout& layout, Mesh& mesh) {
  std::size_t vertices = 0, triangles = 0;
  for (const Draw& draw : draws) {
    vertices += draw.vertices;
    triangles += trianglesOf(draw.kind(), draw.corners);
  }
  mesh.positions.reserve(vertices * 3);
  mesh.normals.reserve(vertices * 3);
  if (layout.hasUvs) mesh.uvs.reserve(vertices * 2);
  if (layout.hasColors) mesh.colors.reserve(vertices * 4);
  if (layout.hasTangents) mesh.tangents.reserve(vertices * 4);
  if (layout.isIndexed) mesh.indices.reserve(triangles * 3);
}

std::optional<Material> materialOf(Gltf& gltf, const std::vector<Draw>& draws, const Layout& layout,
                                   const Files& files) {
  const auto hasMaterial = [](const Draw& draw) { return draw.primitive->material != noPlace; };
  if (std::none_of(draws.begin(), draws.end(), hasMaterial)) return std::nullopt;

  int image = noPlace;
  for (const Draw& draw : draws) {
    warnOfLook(gltf, draw.primitive->material);
    if (image == noPlace) image = lookOf(gltf, draw.primitive->material).image;
  }
  for (const Draw& draw : draws) {
    if (lookOf(gltf, draw.primitive->material).image != image)
      gltf.warn("The parts have different base-colour textures; only the first one is used.");
  }
  Material material;
  material.baseColorTexture = readImage(gltf, image, files);
  if (layout.hasEqualColors) {
    const Look look = lookOf(gltf, draws[0].primitive->material);
    std::transform(look.baseColor.begin(), look.baseColor.end(), material.baseColor.begin(),
                   [](double channel) { return static_cast<float>(channel); });
  }
  return material;
}

}  // namespace

Mesh mergeDraws(Gltf& gltf, const Files& files) {
  const std::vector<Placed> placed = placeMeshes(gltf);
  const std::vector<Draw> draws = drawsOf(gltf, placed);
  if (draws.empty())
    throw FileProblem(
        "there is nothing to draw: the scene shows no mesh of triangles; export the model with its "
        "meshes.");
  const std::vector<Skin> skins = skinsOf(gltf);
  const Layout layout = layoutOf(gltf, draws, skins);
  Mesh mesh;
  reserve(draws, layout, mesh);
  for (const Draw& draw : draws) appendDraw(gltf, draw, layout, skins, mesh);
  // Missing normals are computed from all triangles together, so that adjacent parts are smooth.
  std::vector<bool> hasNormal;
  for (const Draw& draw : draws)
    hasNormal.resize(hasNormal.size() + draw.vertices, draw.accessor("NORMAL") != noPlace);
  addMissingNormals(mesh, hasNormal);
  mesh.material = materialOf(gltf, draws, layout, files);
  return mesh;
}

}  // namespace warpjet
