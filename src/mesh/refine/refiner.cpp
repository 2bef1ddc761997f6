#include "mesh/refine/refiner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/surface/blend.hpp"
#include "mesh/surface/points.hpp"

namespace warpjet {

namespace {

// Each pass halves edges, so that there are no more floats between their ends long before this
// limit.
constexpr int maxPasses = 64;

// The number of samples of the first measurement. Coarse meshes are sampled more densely: this
// number of samples for all original edges, and for all triangles, with a max per piece. With these
// min values, noise and its creases stay within the tolerance; with fewer, the error at a crease
// was a tenth larger.
constexpr double edgeSamples = 2048, triangleSamples = 8192;
constexpr double minPerEdge = 5, maxPerEdge = 64, minPerTriangle = 4, maxPerTriangle = 512;

// Pieces that seem close enough are measured again with more samples. Triangles are sampled so
// densely that a bump with a width of a 200th of the mesh is hit, unless that exceeds the max
// number of samples. If the samples don't fit a parabola, so that a larger deviation may be hidden
// between them, at least the `doubtSamples` are taken.
constexpr double bumpSamplesAcross = 320, maxBumpSamples = 1 << 20;
constexpr std::uint32_t doubtSamplesOfEdge = 31, doubtSamplesOfTriangle = 100;

// Normals jump at a crease, however short the edges across it are. So an edge at a crease is short
// enough if its warped length is at most `creaseTolerances` times the tolerance and `creasePart` of
// the size of the warped mesh. Edges shorter than `shortestPart` of that size, which is invisible,
// are never split for their normals, since the normals of a collapsed surface are rounding errors.
constexpr float creaseTolerances = 8, creasePart = 1 / 64.0f, shortestPart = 1 / 4096.0f;

// An edge that is stretched by this factor more than the original edges on average is torn: where
// the warp is discontinuous, no number of triangles is enough.
constexpr double maxStretch = 256;

void addIfFinite(double& sum, double term) {
  if (std::isfinite(term)) sum += term;
}

std::uint32_t sampleCount(double wanted, double min, double max) {
  // The comparison is false for NaN.
  return static_cast<std::uint32_t>(wanted > min ? std::min(std::ceil(wanted), max) : min);
}

// Returns the longest side of the bounding box.
float sizeOf(const std::vector<float>& positions) {
  std::array<float, 3> low, high;
  low.fill(std::numeric_limits<float>::infinity());
  high.fill(-std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (!std::isfinite(positions[i])) continue;
    low[i % 3] = std::min(low[i % 3], positions[i]);
    high[i % 3] = std::max(high[i % 3], positions[i]);
  }
  return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2], 0.0f});
}

}  // namespace

Refiner::Refiner(const Mesh& mesh, const Refinement& refinement, const WarpFunction& warp)
    : refinement_(refinement), warp_(warp), surface_(mesh) {
  refinement_.maxTriangles = std::min(refinement_.maxTriangles, triangleLimit);
}

Refined Refiner::run() && {
  warpNewVertices();
  findScale();
  for (int pass = 0;; ++pass) {
    measureSides();
    measureInsides();
    const auto edges = pass < maxPasses ? chooseEdges() : std::vector<std::uint32_t>{};
    if (edges.empty()) break;
    surface_.addMiddles(edges);
    warpNewVertices();
    surface_.divide(warped_.positions);
  }
  SurfaceError worst;
  for (std::size_t i = 0; i < needs_.size(); ++i) {
    if (surface_.edges()[i].uses > 0) worst.raise(needs_[i].error);
  }
  for (const Triangle& triangle : surface_.triangles())
    worst.raise({triangle.distance, triangle.angle});
  worst.distance = std::max(worst.distance, unresolved_);
  Origins origins = surface_.origins();
  return {std::move(surface_).takeMesh(),
          std::move(origins),
          worst.distance <= refinement_.tolerance,
          worst.angle <= refinement_.angle,
          worst.distance,
          worst.angle,
          isFull_,
          isDefined_};
}

void Refiner::warpNewVertices() {
  const Mesh& mesh = surface_.mesh();
  while (warped_.positions.size() < mesh.positions.size()) {
    const std::size_t first = warped_.positions.size() / 3;
    const std::size_t end = std::min(first + batchSize, mesh.vertexCount());
    // The first call of the warp determines whether it returns normals.
    const bool mayHaveNormals = first == 0 && !std::isinf(refinement_.angle);
    Moved moved = warp_(slice(mesh, first, end));
    if (mayHaveNormals) hasNormals_ = !moved.normals.empty();
    fit(moved, end - first, hasNormals_);
    warped_.positions.insert(warped_.positions.end(), moved.positions.begin(),
                             moved.positions.end());
    warped_.normals.insert(warped_.normals.end(), moved.normals.begin(), moved.normals.end());
  }
}

void Refiner::findScale() {
  const Mesh& mesh = surface_.mesh();
  double length = 0, warpedLength = 0, area = 0;
  for (const Side& side : surface_.sides()) {
    addIfFinite(length, distance(mesh.positions, side.ends[0], side.ends[1]));
    addIfFinite(warpedLength, distance(warped_.positions, side.ends[0], side.ends[1]));
  }
  for (const Triangle& triangle : surface_.triangles())
    addIfFinite(area, surface_.areaOf(triangle.corners));
  const double across = bumpSamplesAcross / sizeOf(mesh.positions);
  samplesPerLength_ = edgeSamples / length;
  samplesPerArea_ = triangleSamples / area;
  bumpSamplesPerArea_ = std::min(across * across, maxBumpSamples / area);
  minTornStretch_ = maxStretch * std::max(1.0, warpedLength / length);
  const float warpedSize = sizeOf(warped_.positions);
  maxCreaseLength_ = std::min(creaseTolerances * refinement_.tolerance, creasePart * warpedSize);
  minNormalsLength_ = shortestPart * warpedSize;
}

void Refiner::measureSides() {
  const auto& sides = surface_.sides();
  const auto& positions = surface_.mesh().positions;
  std::vector<Piece> pieces;
  std::vector<Scrutiny> scrutinies;
  needs_.resize(surface_.edges().size());
  middles_.positions.resize(3 * sides.size());
  middles_.normals.resize(hasNormals_ ? 3 * sides.size() : 0);
  for (std::uint32_t i = measuredSides_; i < sides.size(); ++i) {
    const auto& [a, b] = sides[i].ends;
    const float length = distance(positions, a, b);
    if (length == 0) continue;  // as at the poles of many spheres
    const float warpedLength = distance(warped_.positions, a, b);
    pieces.push_back(
        {{a, b, a}, {i, i, i}, sampleCount(length * samplesPerLength_, minPerEdge, maxPerEdge)});
    scrutinies.push_back({doubtSamplesOfEdge, 0, warpedLength});
    const bool isTorn = warpedLength > minTornStretch_ * length;
    const std::uint32_t edge = sides[i].edge;
    if (isTorn || !hasRoom(surface_.edges()[edge])) needs_[edge].canSplit = false;
  }
  measuredSides_ = static_cast<std::uint32_t>(sides.size());
  const auto findings = measureInTwoPasses(pieces, scrutinies);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Need& need = needs_[sides[pieces[i].sides[0]].edge];
    need.score = std::max(need.score, findings[i].score);
    need.error.raise(findings[i].error);
  }
}

// Measures triangles whose sides don't deviate. If the inside does, the longest side is split.
void Refiner::measureInsides() {
  std::vector<std::size_t> triangles;
  std::vector<Piece> pieces;
  std::vector<Scrutiny> scrutinies;
  for (std::size_t i = 0; i < surface_.triangles().size(); ++i) {
    const Triangle& triangle = surface_.triangles()[i];
    if (triangle.isMeasured || hasWantedSide(triangle) || isTorn(triangle)) continue;
    const double area = surface_.areaOf(triangle.corners);
    if (area == 0) continue;
    const auto& [a, b] = surface_.sides()[triangle.sides[triangle.longest]].ends;
    triangles.push_back(i);
    pieces.push_back({triangle.corners, triangle.sides,
                      sampleCount(area * samplesPerArea_, minPerTriangle, maxPerTriangle)});
    scrutinies.push_back({doubtSamplesOfTriangle,
                          sampleCount(area * bumpSamplesPerArea_, 0, maxBumpSamples),
                          distance(warped_.positions, a, b)});
  }
  const auto findings = measureInTwoPasses(pieces, scrutinies);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& triangle = surface_.triangles()[triangles[i]];
    Need& need = needs_[surface_.edgeNumber(triangle, triangle.longest)];
    need.score = std::max(need.score, findings[i].score);
    surface_.setMeasured(triangles[i], findings[i].error.distance, findings[i].error.angle);
  }
}

bool Refiner::hasWantedSide(const Triangle& triangle) const {
  return std::any_of(triangle.sides.begin(), triangle.sides.end(), [&](std::uint32_t side) {
    return needs_[surface_.sides()[side].edge].isWanted();
  });
}

// Returns true if a side can't be split; then splitting the other sides doesn't improve the inside.
bool Refiner::isTorn(const Triangle& triangle) const {
  return std::any_of(triangle.sides.begin(), triangle.sides.end(), [&](std::uint32_t side) {
    return !needs_[surface_.sides()[side].edge].canSplit;
  });
}

bool Refiner::hasRoom(const Edge& edge) const {
  const Position middle = surface_.middleOf(edge);
  return middle != surface_.endOf(edge, 0) && middle != surface_.endOf(edge, 1);
}

}  // namespace warpjet
