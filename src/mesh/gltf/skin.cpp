#include "mesh/gltf/skin.hpp"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <string>

#include "mesh/gltf/accessor.hpp"
#include "mesh/gltf/scene.hpp"
#include "mesh/messages.hpp"

namespace warpjet {

namespace {

// The limit for all skins together: far more than any model has, and small enough for any memory.
constexpr std::size_t maxJoints = std::size_t{1} << 20;

Skin skinOf(const Gltf& gltf, const tinygltf::Skin& info, const std::vector<glm::dmat4>& places) {
  std::vector<float> numbers;
  if (info.inverseBindMatrices >= 0) {
    if (countOf(gltf, info.inverseBindMatrices) < info.joints.size())
      throw FileProblem("a skin has " + groupDigits(info.joints.size()) + " joints, but " +
                        groupDigits(countOf(gltf, info.inverseBindMatrices)) +
                        " inverse bind matrices; export the model again.");
    appendMatrices(gltf, info.inverseBindMatrices, numbers);
  }
  Skin skin;
  for (std::size_t i = 0; i < info.joints.size(); ++i) {
    const std::size_t node = checkIndex("node", info.joints[i], places.size());
    glm::dmat4 fromBound(1);
    if (!numbers.empty()) fromBound = glm::dmat4(glm::make_mat4(&numbers[i * 16]));
    skin.joints.push_back(places[node] * fromBound);
  }
  const auto mirrored = std::count_if(
      skin.joints.begin(), skin.joints.end(),
      [](const glm::dmat4& joint) { return glm::determinant(glm::dmat3(joint)) < 0; });
  skin.isMirrored = static_cast<std::size_t>(mirrored) * 2 > skin.joints.size();
  return skin;
}

}  // namespace

std::vector<Skin> skinsOf(const Gltf& gltf) {
  std::vector<Skin> skins;
  if (gltf.model.skins.empty()) return skins;
  std::size_t joints = 0;
  for (const tinygltf::Skin& info : gltf.model.skins) joints += info.joints.size();
  if (joints > maxJoints)
    throw FileProblem("the skins of the model have more than " + groupDigits(maxJoints) +
                      " joints; export it without its skins.");
  const std::vector<glm::dmat4> places = placesOfNodes(gltf);
  for (const tinygltf::Skin& info : gltf.model.skins) skins.push_back(skinOf(gltf, info, places));
  return skins;
}

glm::dmat4 blendOf(const Skin& skin, std::span<const float> joints,
                   std::span<const float> weights) {
  glm::dmat4 blend(0);
  double sum = 0;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (weights[i] == 0) continue;
    if (!(joints[i] >= 0 && joints[i] < static_cast<float>(skin.joints.size())))
      throw FileProblem("a vertex follows a joint that its skin, of " +
                        groupDigits(skin.joints.size()) +
                        ", does not have; export the model again.");
    const double weight = weights[i];
    blend += weight * skin.joints[static_cast<std::size_t>(joints[i])];
    sum += weight;
  }
  return sum > 0 ? blend / sum : glm::dmat4(1);
}

}  // namespace warpjet
