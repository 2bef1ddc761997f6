#include "mesh/gltf/morph.hpp"

#include <algorithm>
#include <string>

#include "mesh/gltf/accessor.hpp"
#include "mesh/messages.hpp"

namespace warpjet {

namespace {

// An attribute that a target can move: its size in the target and in the mesh.
struct Movable {
  const char* name;
  std::vector<float> Mesh::*numbers;
  int minWidth, width;
  std::size_t stride;
};

constexpr Movable movables[] = {{"POSITION", &Mesh::positions, 3, 3, 3},
                                {"NORMAL", &Mesh::normals, 3, 3, 3},
                                {"TANGENT", &Mesh::tangents, 3, 3, 4},
                                {"TEXCOORD_0", &Mesh::uvs, 2, 2, 2},
                                {"COLOR_0", &Mesh::colors, 3, 4, 4}};

void addTarget(const Gltf& gltf, int accessor, const Movable& movable, double weight,
               std::size_t firstVertex, Mesh& mesh) {
  std::vector<float>& numbers = mesh.*movable.numbers;
  const std::size_t vertices = mesh.vertexCount() - firstVertex, count = countOf(gltf, accessor);
  if (count != vertices)
    throw FileProblem("a part has " + groupDigits(vertices) + " positions, but " +
                      groupDigits(count) + " of its morph target's " + movable.name +
                      "; export the model again.");
  std::vector<float> offsets;
  appendFloats(gltf, accessor, movable.minWidth, movable.width, offsets);
  // A color target without alpha leaves alpha unchanged; it isn't padded with ones.
  const bool lacksAlpha =
      gltf.model.accessors[static_cast<std::size_t>(accessor)].type < movable.width;
  const auto width = static_cast<std::size_t>(movable.width), used = width - (lacksAlpha ? 1 : 0);
  for (std::size_t i = 0; i < vertices; ++i)
    for (std::size_t k = 0; k < used; ++k) {
      float& number = numbers[(firstVertex + i) * movable.stride + k];
      number = static_cast<float>(number + weight * offsets[i * width + k]);
    }
}

}  // namespace

std::vector<MorphWeight> morphWeightsOf(Gltf& gltf, const tinygltf::Primitive& primitive,
                                        const Placed& placed) {
  const auto& nodeWeights = gltf.model.nodes[static_cast<std::size_t>(placed.node)].weights;
  const auto& meshWeights = gltf.model.meshes[static_cast<std::size_t>(placed.mesh)].weights;
  const std::vector<double>& all = nodeWeights.empty() ? meshWeights : nodeWeights;
  std::vector<MorphWeight> weights;
  for (std::size_t i = 0; i < std::min(all.size(), primitive.targets.size()); ++i)
    if (all[i] != 0) weights.push_back({i, all[i]});
  if (!weights.empty())
    gltf.warn(
        "The model has morph targets; it has the shape that their weights in the file give it.");
  else if (!primitive.targets.empty())
    gltf.warn("The model has morph targets; they are ignored, and it keeps its base shape.");
  return weights;
}

void morph(const Gltf& gltf, const tinygltf::Primitive& primitive,
           const std::vector<MorphWeight>& weights, std::size_t firstVertex, Mesh& mesh) {
  for (const auto& [target, weight] : weights)
    for (const Movable& movable : movables) {
      const auto accessor = primitive.targets[target].find(movable.name);
      const bool hasAttribute =
          primitive.attributes.contains(movable.name) && !(mesh.*movable.numbers).empty();
      if (hasAttribute && accessor != primitive.targets[target].end())
        addTarget(gltf, accessor->second, movable, weight, firstVertex, mesh);
    }
}

}  // namespace warpjet
