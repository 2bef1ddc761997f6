#include "mesh/deviation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/blend.hpp"
#include "mesh/points.hpp"

namespace warpjet {

namespace {

// So many vertices go to the warp at once: enough that the call costs nothing, few enough for
// caches.
constexpr std::size_t batchSize = 1 << 14;

float fraction(float x) { return x - std::floor(x); }

// The middle comes first. The others are spread evenly but not regularly, since a symmetric or
// periodic warp can be 0 at all regular places: the golden ratio along an edge, Roberts' sequence
// ("The Unreasonable Effectiveness of Quasirandom Sequences", 2018) folded into a triangle.
std::array<float, 3> weights(const Piece& piece, std::uint32_t sample) {
  const auto i = static_cast<float>(sample);
  if (piece.isEdge()) {
    if (sample == 0) return {0.5f, 0.5f, 0};
    const auto others = static_cast<float>(piece.samples - 1);
    const float t = (i - 0.58f + 0.2f * fraction(0.618034f * (i - 1))) / others;
    return {1 - t, t, 0};
  }
  if (sample == 0) return {1 / 3.0f, 1 / 3.0f, 1 / 3.0f};
  float u = fraction(0.5f + 0.7548777f * i), v = fraction(0.5f + 0.5698403f * i);
  if (u + v > 1) u = 1 - u, v = 1 - v;
  return {1 - u - v, u, v};
}

float distanceToSegment(glm::vec3 p, glm::vec3 a, glm::vec3 b) {
  const glm::vec3 ab = b - a;
  const float squared = glm::dot(ab, ab);
  const float t = squared > 0 ? glm::clamp(glm::dot(p - a, ab) / squared, 0.0f, 1.0f) : 0;
  return glm::distance(p, a + t * ab);
}

// Over the inside it is the distance from the plane, elsewhere that from the nearest side.
float distanceToTriangle(glm::vec3 p, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
  const glm::vec3 normal = areaVector(a, b, c);
  const auto isInside = [&](glm::vec3 from, glm::vec3 to) {
    return glm::dot(glm::cross(to - from, p - from), normal) >= 0;
  };
  const float area = glm::length(normal);
  if (area > 0 && isInside(a, b) && isInside(b, c) && isInside(c, a))
    return std::abs(glm::dot(p - a, normal / area));
  return std::min(
      {distanceToSegment(p, a, b), distanceToSegment(p, b, c), distanceToSegment(p, c, a)});
}

// Of a number of that size, and of the few operations that made it.
float rounding(glm::vec3 p) {
  const float size = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return 4 * std::numeric_limits<float>::epsilon() * size;
}

float angleBetween(glm::vec3 a, glm::vec3 b) {
  // As Kahan writes it, right for small angles too.
  const glm::vec3 u = a * glm::length(b), v = b * glm::length(a);
  return 2 * std::atan2(glm::length(u - v), glm::length(u + v));
}

void raise(float& largest, float candidate) {
  if (std::isfinite(candidate)) largest = std::max(largest, candidate);
}

class Measurement {
 public:
  Measurement(const Mesh& mesh, const Moved& warped, const WarpFunction& warp)
      : mesh_(mesh), warped_(warped), warp_(warp) {}

  std::vector<Deviation> run(std::span<const Piece> pieces) {
    std::vector<Deviation> deviations;
    deviations.reserve(pieces.size());
    Mesh samples;
    for (std::size_t first = 0; first < pieces.size();) {
      for (auto* numbers :
           {&samples.positions, &samples.normals, &samples.uvs, &samples.colors, &samples.tangents})
        numbers->clear();
      for (auto& numbers : samples.gradients) numbers.clear();
      std::size_t end = first;
      for (; end < pieces.size() && samples.vertexCount() < batchSize; ++end) {
        for (std::uint32_t i = 0; i < pieces[end].samples; ++i)
          appendBlend(samples, mesh_, {pieces[end].corners, weights(pieces[end], i)});
      }
      const Moved moved = evaluate(samples, warp_);
      std::size_t sample = 0;
      for (; first < end; ++first) {
        deviations.push_back(compare(pieces[first], moved, sample));
        sample += pieces[first].samples;
      }
    }
    return deviations;
  }

 private:
  Deviation compare(const Piece& piece, const Moved& moved, std::size_t firstSample) const {
    std::array<glm::vec3, 3> corners, normals;
    for (int i = 0; i < 3; ++i) {
      corners[i] = at(warped_.positions, piece.corners[i]);
      if (!warped_.normals.empty()) normals[i] = at(warped_.normals, piece.corners[i]);
    }
    const auto& [a, b, c] = corners;
    Deviation deviation;
    for (std::uint32_t i = 0; i < piece.samples; ++i) {
      const glm::vec3 p = at(moved.positions, firstSample + i);
      const float distance =
          piece.isEdge() ? distanceToSegment(p, a, b) : distanceToTriangle(p, a, b, c);
      if (distance > rounding(p)) raise(deviation.distance, distance);
      if (moved.normals.empty() || warped_.normals.empty()) continue;
      const auto w = weights(piece, i);
      const glm::vec3 between = w[0] * normals[0] + w[1] * normals[1] + w[2] * normals[2];
      raise(deviation.angle, angleBetween(at(moved.normals, firstSample + i), between));
    }
    return deviation;
  }

  const Mesh& mesh_;
  const Moved& warped_;
  const WarpFunction& warp_;
};

}  // namespace

std::vector<Deviation> measure(const Mesh& mesh, const Moved& warped, std::span<const Piece> pieces,
                               const WarpFunction& warp) {
  return Measurement(mesh, warped, warp).run(pieces);
}

Moved evaluate(const Mesh& vertices, const WarpFunction& warp) {
  Moved moved = warp(vertices);
  moved.positions.resize(vertices.positions.size(), std::numeric_limits<float>::quiet_NaN());
  if (!moved.normals.empty()) moved.normals.resize(vertices.positions.size(), 0);
  return moved;
}

}  // namespace warpjet
