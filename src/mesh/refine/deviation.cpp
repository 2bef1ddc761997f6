#include "mesh/refine/deviation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/surface/blend.hpp"
#include "mesh/surface/points.hpp"

namespace warpjet {

namespace {

float fraction(double x) { return static_cast<float>(x - std::floor(x)); }

// Returns the weights of a sample. The middle comes first. The other samples are spread evenly but
// not regularly, since a symmetric or periodic warp can be 0 at all regular samples: by the golden
// ratio along an edge, and by Roberts' sequence ("The Unreasonable Effectiveness of Quasirandom
// Sequences", 2018) folded into a triangle.
Weights weights(const Piece& piece, std::uint32_t sample) {
  if (piece.isEdge()) {
    if (sample == 0) return {0.5f, 0.5f, 0};
    const auto otherSamples = static_cast<float>(piece.samples - 1);
    const auto i = static_cast<float>(sample);
    const float t = (i - 0.58f + 0.2f * fraction(0.618034f * (i - 1))) / otherSamples;
    return {1 - t, t, 0};
  }
  if (sample == 0) return {1 / 3.0f, 1 / 3.0f, 1 / 3.0f};
  float u = fraction(0.5 + 0.7548776662466927 * sample),
        v = fraction(0.5 + 0.5698402909980532 * sample);
  if (u + v > 1) u = 1 - u, v = 1 - v;
  return {1 - u - v, u, v};
}

float distanceToSegment(glm::vec3 p, glm::vec3 a, glm::vec3 b) {
  const glm::vec3 ab = b - a;
  const float squared = glm::dot(ab, ab);
  const float t = squared > 0 ? glm::clamp(glm::dot(p - a, ab) / squared, 0.0f, 1.0f) : 0;
  return glm::distance(p, a + t * ab);
}

// Returns the distance of p from a triangle: from its plane if the nearest point is inside,
// otherwise from the nearest side.
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

// Returns the rounding error of the coordinates of p after the few operations that compute them.
float rounding(glm::vec3 p) {
  const float size = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return 4 * std::numeric_limits<float>::epsilon() * size;
}

void raiseIfFinite(float& largest, float candidate) {
  if (std::isfinite(candidate)) largest = std::max(largest, candidate);
}

// Two pieces: a flat one between three vectors, and a parabolic one that also contains the vectors
// at the midpoints of the sides.
struct Patch {
  std::array<glm::vec3, 3> corners, middles;

  glm::vec3 flat(const Weights& w) const {
    return w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2];
  }
  glm::vec3 curved(const Weights& w) const {
    glm::vec3 point = flat(w);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      point += 4 * w[i] * w[j] * (middles[i] - 0.5f * (corners[i] + corners[j]));
    }
    return point;
  }
};

Patch patchOf(const Piece& piece, const std::vector<float>& corners,
              const std::vector<float>& middles) {
  Patch patch;
  for (int i = 0; i < 3; ++i) {
    patch.corners[i] = at(corners, piece.corners[i]);
    patch.middles[i] = at(middles, piece.sides[i]);
  }
  return patch;
}

void put(std::vector<float>& numbers, std::size_t vertex, glm::vec3 value) {
  for (int i = 0; i < 3; ++i) numbers[3 * vertex + i] = value[i];
}

void clear(Mesh& vertices) {
  for (auto* numbers : {&vertices.positions, &vertices.normals, &vertices.uvs, &vertices.colors,
                        &vertices.tangents})
    numbers->clear();
  for (auto& numbers : vertices.gradients) numbers.clear();
}

class Measurement {
 public:
  Measurement(const Mesh& mesh, const Moved& warped, Moved& middles, const WarpFunction& warp)
      : mesh_(mesh), warped_(warped), middles_(middles), warp_(warp) {}

  std::vector<Deviation> run(std::span<const Piece> pieces) {
    std::vector<Deviation> deviations(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (std::uint32_t sample = pieces[i].firstSample; sample < pieces[i].samples; ++sample) {
        const Weights where = weights(pieces[i], sample);
        appendBlend(vertices_, mesh_, {pieces[i].corners, where});
        samples_.push_back({i, sample == 0, where});
        if (samples_.size() == batchSize) compareBatch(pieces, deviations);
      }
    }
    compareBatch(pieces, deviations);
    return deviations;
  }

 private:
  struct Sample {
    std::size_t piece;
    bool isFirst;
    Weights weights;
  };

  bool hasNormals() const { return !warped_.normals.empty(); }

  void compareBatch(std::span<const Piece> pieces, std::vector<Deviation>& deviations) {
    if (samples_.empty()) return;
    const Moved moved = applyWarp(vertices_, warp_, hasNormals());
    for (std::size_t i = 0; i < samples_.size(); ++i)
      compare(samples_[i], pieces[samples_[i].piece], moved, i, deviations[samples_[i].piece]);
    samples_.clear();
    clear(vertices_);
  }

  void compare(const Sample& sample, const Piece& piece, const Moved& moved, std::size_t i,
               Deviation& deviation) {
    const bool isMiddle = piece.isEdge() && sample.isFirst;
    if (isMiddle) put(middles_.positions, piece.sides[0], at(moved.positions, i));
    if (isMiddle && hasNormals()) put(middles_.normals, piece.sides[0], at(moved.normals, i));

    const Patch patch = patchOf(piece, warped_.positions, middles_.positions);
    const glm::vec3 p = at(moved.positions, i);
    const auto& [a, b, c] = patch.corners;
    const float distance =
        piece.isEdge() ? distanceToSegment(p, a, b) : distanceToTriangle(p, a, b, c);
    if (!std::isfinite(p.x + p.y + p.z)) deviation.isDefined = false;
    if (distance <= rounding(p)) {
      raiseIfFinite(deviation.unresolved, distance);
    } else {
      raiseIfFinite(deviation.max.distance, distance);
      raiseIfFinite(deviation.residual.distance, glm::distance(p, patch.curved(sample.weights)));
    }
    if (!hasNormals()) return;
    const Patch normals = patchOf(piece, warped_.normals, middles_.normals);
    const glm::vec3 normal = at(moved.normals, i);
    const float angle = angleBetween(normal, normals.flat(sample.weights));
    if (angle > deviation.max.angle) deviation.maxAngleSample = sample.weights;
    raiseIfFinite(deviation.max.angle, angle);
    raiseIfFinite(deviation.residual.angle, angleBetween(normal, normals.curved(sample.weights)));
  }

  const Mesh& mesh_;
  const Moved& warped_;
  Moved& middles_;
  const WarpFunction& warp_;
  Mesh vertices_;  // the vertices of the batch
  std::vector<Sample> samples_;
};

}  // namespace

std::vector<Deviation> measure(const Mesh& mesh, const Moved& warped, Moved& middles,
                               std::span<const Piece> pieces, const WarpFunction& warp) {
  return Measurement(mesh, warped, middles, warp).run(pieces);
}

void SurfaceError::raise(const SurfaceError& other) {
  distance = std::max(distance, other.distance);
  angle = std::max(angle, other.angle);
}

Moved applyWarp(const Mesh& vertices, const WarpFunction& warp, bool hasNormals) {
  Moved moved = warp(vertices);
  fit(moved, vertices.vertexCount(), hasNormals);
  return moved;
}

void fit(Moved& moved, std::size_t vertices, bool hasNormals) {
  moved.positions.resize(3 * vertices, std::numeric_limits<float>::quiet_NaN());
  moved.normals.resize(hasNormals ? 3 * vertices : 0, 0);
}

}  // namespace warpjet
