#include "mesh/scene.hpp"

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

std::vector<int> rootsOf(const tinygltf::Model& model) {
  if (!model.scenes.empty()) {
    const int scene = model.defaultScene < 0 ? 0 : model.defaultScene;
    return model.scenes[checkedIndex("scene", scene, model.scenes.size())].nodes;
  }
  std::vector<bool> isChild(model.nodes.size());
  for (const tinygltf::Node& node : model.nodes)
    for (const int child : node.children)
      isChild[checkedIndex("node", child, model.nodes.size())] = true;
  std::vector<int> roots;
  for (std::size_t i = 0; i < model.nodes.size(); ++i)
    if (!isChild[i]) roots.push_back(static_cast<int>(i));
  return roots;
}

}  // namespace

std::vector<Placed> placedMeshes(const Gltf& gltf) {
  const tinygltf::Model& model = gltf.model;
  struct Visit {
    int node;
    glm::dmat4 parent;
  };
  // In reverse, so that nodes come in the order of the file, parents before children.
  std::vector<Visit> open;
  const auto visitAll = [&](const std::vector<int>& nodes, const glm::dmat4& parent) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) open.push_back({*node, parent});
  };
  visitAll(rootsOf(model), glm::dmat4(1));

  std::vector<Placed> placed;
  std::vector<bool> isVisited(model.nodes.size());
  while (!open.empty()) {
    const auto [place, parent] = open.back();
    open.pop_back();
    const std::size_t index = checkedIndex("node", place, model.nodes.size());
    if (isVisited[index])
      throw FileProblem("node " + std::to_string(place) +
                        " is its own ancestor or has two parents; export the model again.");
    isVisited[index] = true;
    const tinygltf::Node& node = model.nodes[index];
    const glm::dmat4 toWorld = parent * transformOf(node);
    if (node.mesh >= 0) placed.push_back({node.mesh, toWorld});
    visitAll(node.children, toWorld);
  }
  return placed;
}

}  // namespace warpjet
