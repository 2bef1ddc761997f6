#include "mesh/surface/variation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "mesh/surface/pairs.hpp"
#include "mesh/surface/weld.hpp"

namespace warpjet {

namespace {

using Ids = std::vector<std::uint32_t>;

// Differences below these shares of the mesh's size, of a unit normal, and of a unit of uv are
// ignored. This merges only values that differ by rounding errors, such as the two ends of a
// circle, sin(0) and sin(2 pi).
constexpr double positionGrain = 0x1p-20, normalGrain = 0x1p-10, uvGrain = 0x1p-20;

glm::dvec3 vectorAt(const std::vector<float>& numbers, std::uint32_t vertex) {
  const float* const p = &numbers[std::size_t{vertex} * 3];
  return {p[0], p[1], p[2]};
}

double maxMagnitude(const std::vector<float>& numbers) {
  double largest = 0;
  for (const float x : numbers) largest = std::max(largest, std::abs(double{x}));
  return largest;
}

// Numbers the values of vertices. Values in the same cell of a grid of size `grain` get the same
// number.
Ids numberValues(const std::vector<float>& numbers, std::size_t size, double grain) {
  Welder welder;
  Ids found;
  for (std::size_t i = 0; i < numbers.size(); i += size) {
    Position snapped{};
    for (std::size_t k = 0; k < size; ++k)
      snapped[k] = grain > 0 ? static_cast<float>(std::round(numbers[i + k] / grain)) : 0;
    found.push_back(welder.weld(snapped));
  }
  return found;
}

Ids pairIds(const Ids& first, const Ids& second) {
  Pairs pairs;
  Ids found;
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    found.push_back(pairs.findOrAdd(first[i], second[i], count));
    if (found.back() == count) ++count;
  }
  return found;
}

// The shortest rotation from one unit vector to another that isn't opposite (Rodrigues' formula,
// with sine and cosine from cross and dot product).
struct Turn {
  glm::dvec3 axis;
  double cosine;

  Turn(const glm::dvec3& from, const glm::dvec3& to)
      : axis(glm::cross(from, to)), cosine(glm::dot(from, to)) {}

  glm::dvec3 operator()(const glm::dvec3& x) const {
    return cosine * x + glm::cross(axis, x) + axis * (glm::dot(axis, x) / (1 + cosine));
  }
};

// The weighted mean of gradients.
template <std::size_t size>
struct Mean {
  std::array<glm::dvec3, size> sums{};
  double weight = 0;

  void writeTo(std::vector<float>* arrays, std::size_t vertex) const {
    constexpr double max = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < size; ++i) {
      const glm::dvec3 mean = weight > 0 ? sums[i] / weight : glm::dvec3(0);
      for (int k = 0; k < 3; ++k)
        arrays[i][3 * vertex + k] = static_cast<float>(std::clamp(mean[k], -max, max));
    }
  }
};

class Estimate {
 public:
  explicit Estimate(Mesh& mesh) : mesh_(mesh) {
    positionIds_ = numberValues(mesh.positions, 3, maxMagnitude(mesh.positions) * positionGrain);
    smooth_ = pairIds(positionIds_, numberValues(mesh.normals, 3, normalGrain));
    normalMeans_.resize(mesh.vertexCount());
    if (mesh.uvs.empty()) return;
    seamless_ = pairIds(smooth_, numberValues(mesh.uvs, 2, uvGrain));
    uvMeans_.resize(mesh.vertexCount());
  }

  void run() {
    for (std::size_t i = 0; i < mesh_.triangleCount(); ++i) addTriangle(mesh_.corners(i));
    write(normalMeans_, smooth_, &mesh_.gradients[0]);
    write(uvMeans_, seamless_, &mesh_.gradients[3]);
  }

 private:
  using Corners = std::array<std::uint32_t, 3>;
  using Three = std::array<glm::dvec3, 3>;

  void addTriangle(const Corners& corners) {
    // Degenerate triangles, which spheres have at their poles.
    const auto isSide = [&](int i, int j) {
      return positionIds_[corners[i]] != positionIds_[corners[j]];
    };
    if (!(isSide(0, 1) && isSide(1, 2) && isSide(2, 0))) return;
    Three p, normals, sides;
    for (int i = 0; i < 3; ++i) {
      p[i] = vectorAt(mesh_.positions, corners[i]);
      normals[i] = vectorAt(mesh_.normals, corners[i]);
      if (normals[i] == glm::dvec3(0)) return;
    }
    for (int i = 0; i < 3; ++i) sides[i] = p[(i + 2) % 3] - p[(i + 1) % 3];
    const glm::dvec3 across = glm::cross(sides[0], sides[1]);
    const double area = glm::length(across);  // twice the area
    if (!(area > 0)) return;
    const glm::dvec3 facing = across / area;
    // The gradient of the function that is 1 at one corner and 0 at the other two.
    Three rises;
    for (int i = 0; i < 3; ++i) rises[i] = glm::cross(facing, sides[i]) / area;
    for (int i = 0; i < 3; ++i) {
      // The sine of the angle: flat corners of triangles with very small height get little weight.
      const double weight =
          area / (glm::length(sides[(i + 1) % 3]) * glm::length(sides[(i + 2) % 3]));
      const glm::dvec3 normal = glm::normalize(normals[i]);
      const Turn turn(glm::dot(facing, normal) < 0 ? -facing : facing, normal);
      addNormals(normalMeans_[smooth_[corners[i]]], facing, normals, rises, turn, weight);
      if (!mesh_.uvs.empty()) addUvs(uvMeans_[seamless_[corners[i]]], corners, rises, turn, weight);
    }
  }

  static void addNormals(Mean<3>& mean, const glm::dvec3& facing, const Three& normals,
                         const Three& rises, const Turn& turn, double weight) {
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 normal = turn(normals[i] - facing * glm::dot(facing, normals[i]));
      const glm::dvec3 rise = turn(rises[i]);
      for (int k = 0; k < 3; ++k)
        mean.sums[k] += weight / 2 * (normal[k] * rise + rise[k] * normal);
    }
    mean.weight += weight;
  }

  void addUvs(Mean<2>& mean, const Corners& corners, const Three& rises, const Turn& turn,
              double weight) const {
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 rise = weight * turn(rises[i]);
      for (std::size_t k = 0; k < 2; ++k)
        mean.sums[k] += rise * double{mesh_.uvs[2 * std::size_t{corners[i]} + k]};
    }
    mean.weight += weight;
  }

  template <std::size_t size>
  static void write(const std::vector<Mean<size>>& means, const Ids& groups,
                    std::vector<float>* arrays) {
    for (std::size_t i = 0; i < size; ++i) arrays[i].resize(3 * means.size());
    for (std::size_t i = 0; i < means.size(); ++i) means[groups[i]].writeTo(arrays, i);
  }

  Mesh& mesh_;
  Ids positionIds_, smooth_, seamless_;  // by vertex: groups of vertices that share values
  std::vector<Mean<3>> normalMeans_;
  std::vector<Mean<2>> uvMeans_;
};

}  // namespace

void addSurfaceVariation(Mesh& mesh) { Estimate(mesh).run(); }

}  // namespace warpjet
