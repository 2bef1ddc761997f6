#include "mesh/gltf/scene.hpp"

#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <optional>
#include <string>

#include "mesh/gltf/accessor.hpp"
#include "mesh/messages.hpp"

namespace warpjet {

namespace {

// Combines translation, rotation and scale, which are arrays in glTF's order. Each may be null.
template <typename Number>
glm::dmat4 transformOf(const Number* translation, const Number* q, const Number* scale) {
  glm::dmat4 transform(1);
  if (translation) transform[3] = glm::dvec4(translation[0], translation[1], translation[2], 1);
  if (q) {
    const glm::dquat rotation(q[3], q[0], q[1], q[2]);
    // Writers round to floats; a rotation must not scale.
    if (glm::length(rotation) > 0) transform *= glm::mat4_cast(glm::normalize(rotation));
  }
  for (int i = 0; i < 3 && scale; ++i) transform[i] *= double{scale[i]};
  return transform;
}

// Returns the matrix of a node, or translation * rotation * scale: glTF 2.0, section 3.5.3.
glm::dmat4 transformOf(const tinygltf::Node& node) {
  if (!node.matrix.empty()) return glm::make_mat4(node.matrix.data());
  const auto numbers = [](const std::vector<double>& list) {
    return list.empty() ? nullptr : list.data();
  };
  return transformOf(numbers(node.translation), numbers(node.rotation), numbers(node.scale));
}

// Returns the transforms of a node's instances.
std::vector<glm::dmat4> instancesOf(const Gltf& gltf, const Instancing& instancing) {
  std::optional<std::size_t> count;
  const auto numbersOf = [&](int accessor, int width) {
    std::vector<float> numbers;
    if (accessor < 0) return numbers;
    const std::size_t elements = countOf(gltf, accessor);
    if (elements > maxDraws) failTooManyDraws();
    if (elements != count.value_or(elements))
      throw FileProblem("the instances of a node have " + groupDigits(*count) +
                        " elements of one attribute and " + groupDigits(elements) +
                        " of another; export the model again.");
    count = elements;
    appendFloats(gltf, accessor, width, width, numbers);
    return numbers;
  };
  const std::vector<float> translations = numbersOf(instancing.translation, 3),
                           rotations = numbersOf(instancing.rotation, 4),
                           scales = numbersOf(instancing.scale, 3);
  std::vector<glm::dmat4> instances;
  for (std::size_t i = 0; i < count.value_or(0); ++i) {
    const auto elementOf = [&](const std::vector<float>& numbers, std::size_t width) {
      return numbers.empty() ? nullptr : &numbers[i * width];
    };
    instances.push_back(
        transformOf(elementOf(translations, 3), elementOf(rotations, 4), elementOf(scales, 3)));
  }
  return instances;
}

std::vector<int> parentlessNodes(const tinygltf::Model& model) {
  std::vector<bool> isChild(model.nodes.size());
  for (const tinygltf::Node& node : model.nodes)
    for (const int child : node.children)
      isChild[checkIndex("node", child, model.nodes.size())] = true;
  std::vector<int> parentless;
  for (std::size_t i = 0; i < model.nodes.size(); ++i)
    if (!isChild[i]) parentless.push_back(static_cast<int>(i));
  return parentless;
}

std::vector<int> rootsOf(const tinygltf::Model& model) {
  if (model.scenes.empty()) return parentlessNodes(model);
  const int scene = model.defaultScene < 0 ? 0 : model.defaultScene;
  return model.scenes[checkIndex("scene", scene, model.scenes.size())].nodes;
}

// Calls `function` with the index and the transform of each node in the trees with these roots, in
// the order of the file, parents before children. Visits the children of a node only if the call
// returns true.
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
    const std::size_t node = checkIndex("node", number, model.nodes.size());
    if (isVisited[node])
      throw FileProblem("node " + std::to_string(number) +
                        " is its own ancestor or has two parents; export the model again.");
    isVisited[node] = true;
    const glm::dmat4 toWorld = parent * transformOf(model.nodes[node]);
    if (function(node, toWorld)) visitAll(model.nodes[node].children, toWorld);
  }
}

}  // namespace

void failTooManyDraws() {
  throw FileProblem("the model has more than " + groupDigits(maxDraws) +
                    " parts; join its parts and export it again.");
}

std::vector<Placed> placeMeshes(Gltf& gltf) {
  std::vector<Placed> placed;
  const auto place = [&](std::size_t nodeIndex, const glm::dmat4& toWorld) {
    const int i = static_cast<int>(nodeIndex);
    const tinygltf::Node& node = gltf.model.nodes[nodeIndex];
    if (gltf.extensions.hiddenNodes.contains(i)) return false;
    if (node.mesh < 0) return true;
    const auto instancing = gltf.extensions.instancing.find(i);
    const bool isInstanced = instancing != gltf.extensions.instancing.end() && node.skin < 0;
    if (instancing != gltf.extensions.instancing.end() && node.skin >= 0)
      gltf.warn("A mesh that follows bones is shown once, whatever its instances are.");
    std::vector<glm::dmat4> instances{glm::dmat4(1)};
    if (isInstanced && instancing->second.hasAttributes())
      instances = instancesOf(gltf, instancing->second);
    if (placed.size() + instances.size() > maxDraws) failTooManyDraws();
    for (const glm::dmat4& instance : instances)
      placed.push_back({node.mesh, node.skin, i, toWorld * instance});
    return true;
  };
  forNodesBelow(gltf.model, rootsOf(gltf.model), place);
  return placed;
}

std::vector<glm::dmat4> placesOfNodes(const Gltf& gltf) {
  std::vector<glm::dmat4> places(gltf.model.nodes.size(), glm::dmat4(1));
  forNodesBelow(gltf.model, parentlessNodes(gltf.model),
                [&](std::size_t node, const glm::dmat4& toWorld) {
                  places[node] = toWorld;
                  return true;
                });
  return places;
}

}  // namespace warpjet
