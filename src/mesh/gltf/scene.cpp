#include "mesh/gltf/scene.hpp"

#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <string>

#include "mesh/sentences.hpp"

namespace warpjet {

namespace {

// glTF 2.0, section 3.5.3: matrix, or translation * rotation * scale.
glm::dmat4 transformOf(const tinygltf::Node& node) {
  if (!node.matrix.empty()) return glm::make_mat4(node.matrix.data());
  glm::dmat4 transform(1);
  if (!node.translation.empty())
    transform[3] = glm::dvec4(glm::make_vec3(node.translation.data()), 1);
  if (!node.rotation.empty()) {
    const auto& q = node.rotation;
    const glm::dquat rotation(q[3], q[0], q[1], q[2]);
    // Writers round to floats; a rotation must not scale.
    if (glm::length(rotation) > 0) transform *= glm::mat4_cast(glm::normalize(rotation));
  }
  for (int i = 0; i < 3 && !node.scale.empty(); ++i) transform[i] *= node.scale[i];
  return transform;
}

std::vector<int> orphansOf(const tinygltf::Model& model) {
  std::vector<bool> isChild(model.nodes.size());
  for (const tinygltf::Node& node : model.nodes)
    for (const int child : node.children)
      isChild[checkedIndex("node", child, model.nodes.size())] = true;
  std::vector<int> orphans;
  for (std::size_t i = 0; i < model.nodes.size(); ++i)
    if (!isChild[i]) orphans.push_back(static_cast<int>(i));
  return orphans;
}

std::vector<int> rootsOf(const tinygltf::Model& model) {
  if (model.scenes.empty()) return orphansOf(model);
  const int scene = model.defaultScene < 0 ? 0 : model.defaultScene;
  return model.scenes[checkedIndex("scene", scene, model.scenes.size())].nodes;
}

// Calls with the number and the place of each node below these, in the order of the file, parents
// before children.
template <typename Function>
void forNodesBelow(const tinygltf::Model& model, const std::vector<int>& roots, Function function) {
  struct Visit {
    int node;
    glm::dmat4 parent;
  };
  std::vector<Visit> open;
  const auto visitAll = [&](const std::vector<int>& nodes, const glm::dmat4& parent) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) open.push_back({*node, parent});
  };
  visitAll(roots, glm::dmat4(1));
  std::vector<bool> isVisited(model.nodes.size());
  while (!open.empty()) {
    const auto [number, parent] = open.back();
    open.pop_back();
    const std::size_t node = checkedIndex("node", number, model.nodes.size());
    if (isVisited[node])
      throw FileProblem("node " + std::to_string(number) +
                        " is its own ancestor or has two parents; export the model again.");
    isVisited[node] = true;
    const glm::dmat4 toWorld = parent * transformOf(model.nodes[node]);
    function(node, toWorld);
    visitAll(model.nodes[node].children, toWorld);
  }
}

}  // namespace

std::vector<Placed> placedMeshes(const Gltf& gltf) {
  std::vector<Placed> placed;
  forNodesBelow(gltf.model, rootsOf(gltf.model), [&](std::size_t place, const glm::dmat4& toWorld) {
    const tinygltf::Node& node = gltf.model.nodes[place];
    if (node.mesh >= 0) placed.push_back({node.mesh, node.skin, toWorld});
  });
  return placed;
}

std::vector<glm::dmat4> placesOfNodes(const Gltf& gltf) {
  std::vector<glm::dmat4> places(gltf.model.nodes.size(), glm::dmat4(1));
  forNodesBelow(gltf.model, orphansOf(gltf.model),
                [&](std::size_t node, const glm::dmat4& toWorld) { places[node] = toWorld; });
  return places;
}

}  // namespace warpjet
