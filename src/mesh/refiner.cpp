#include "mesh/refiner.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <utility>

#include "mesh/blend.hpp"
#include "mesh/points.hpp"

namespace warpjet {

namespace {

// Each pass halves edges, so floats run out of places between two positions long before.
constexpr int maxPasses = 64;

// Vertices that go to the warp at once.
constexpr std::size_t batchSize = 1 << 14;

// What is coarse is sampled more densely, so that waves and bumps between its corners are seen: so
// many samples for all edges that came, and for all triangles, but no more than so many for one.
constexpr double edgeSamples = 2048, triangleSamples = 8192;
constexpr double fewestOfEdge = 3, mostOfEdge = 64, fewestOfTriangle = 1, mostOfTriangle = 512;

// Normals jump at a crease, however short the edges across it are. Edges shorter than so many
// tolerances are split for their distance only.
constexpr float shortestForAngle = 8;

// An edge that is stretched so much more than the edges that came are on average is torn: where the
// warp jumps, no number of triangles would be enough.
constexpr double mostStretch = 256;

void addIfFinite(double& sum, float term) {
  if (std::isfinite(term)) sum += term;
}

std::uint32_t sampleCount(double share, double all, double fewest, double most) {
  // The order of the comparison also catches NaN.
  const double wanted = share * all;
  return static_cast<std::uint32_t>(wanted > fewest ? std::min(std::ceil(wanted), most) : fewest);
}

}  // namespace

Refiner::Refiner(const Mesh& mesh, const Refinement& refinement, const WarpFunction& warp)
    : refinement_(refinement), warp_(warp), surface_(mesh) {
  refinement_.maxTriangles = std::min(refinement_.maxTriangles, mostTriangles);
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
  bool reached = true;
  float worst = 0;
  for (std::size_t i = 0; i < needs_.size(); ++i) {
    if (surface_.edges()[i].uses == 0) continue;
    reached = reached && needs_[i].score <= 1;
    worst = std::max(worst, needs_[i].distance);
  }
  for (const Triangle& triangle : surface_.triangles()) worst = std::max(worst, triangle.distance);
  return {std::move(surface_).takeMesh(), reached, worst};
}

void Refiner::warpNewVertices() {
  const Mesh& mesh = surface_.mesh();
  while (warped_.positions.size() < mesh.positions.size()) {
    const std::size_t first = warped_.positions.size() / 3;
    const std::size_t end = std::min(first + batchSize, mesh.vertexCount());
    const Moved moved = evaluate(slice(mesh, first, end), warp_);
    warped_.positions.insert(warped_.positions.end(), moved.positions.begin(),
                             moved.positions.end());
    if (std::isinf(refinement_.angle)) continue;
    warped_.normals.insert(warped_.normals.end(), moved.normals.begin(), moved.normals.end());
  }
}

void Refiner::findScale() {
  const Mesh& mesh = surface_.mesh();
  double warpedLength = 0;
  for (const Side& side : surface_.sides()) {
    addIfFinite(totalLength_, distance(mesh.positions, side.ends[0], side.ends[1]));
    addIfFinite(warpedLength, distance(warped_.positions, side.ends[0], side.ends[1]));
  }
  for (const Triangle& triangle : surface_.triangles())
    addIfFinite(totalArea_, surface_.areaOf(triangle.corners));
  tear_ = mostStretch * std::max(1.0, warpedLength / totalLength_);
}

void Refiner::measureSides() {
  const auto& sides = surface_.sides();
  const auto& positions = surface_.mesh().positions;
  std::vector<Piece> pieces;
  pieces.reserve(sides.size() - measuredSides_);
  for (std::size_t i = measuredSides_; i < sides.size(); ++i) {
    const auto& [a, b] = sides[i].ends;
    const double share = distance(positions, a, b) / totalLength_;
    pieces.push_back({{a, b, a}, sampleCount(share, edgeSamples, fewestOfEdge, mostOfEdge)});
  }
  const auto deviations = measure(surface_.mesh(), warped_, pieces, warp_);
  needs_.resize(surface_.edges().size());
  for (std::size_t i = measuredSides_; i < sides.size(); ++i) {
    const auto& [a, b] = sides[i].ends;
    const Deviation& deviation = deviations[i - measuredSides_];
    const float warpedLength = distance(warped_.positions, a, b);
    Need& need = needs_[sides[i].edge];
    need.score = std::max(need.score, score(deviation, warpedLength));
    need.distance = std::max(need.distance, deviation.distance);
    const bool isTorn = warpedLength > tear_ * distance(positions, a, b);
    if (isTorn || !hasRoom(surface_.edges()[sides[i].edge])) need.canSplit = false;
  }
  measuredSides_ = sides.size();
}

// What is off inside, although the sides are not, is split through the longest side.
void Refiner::measureInsides() {
  std::vector<std::size_t> triangles;
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < surface_.triangles().size(); ++i) {
    const Triangle& triangle = surface_.triangles()[i];
    if (triangle.distance >= 0 || hasWantedSide(triangle)) continue;
    const double share = surface_.areaOf(triangle.corners) / totalArea_;
    triangles.push_back(i);
    pieces.push_back(
        {triangle.corners, sampleCount(share, triangleSamples, fewestOfTriangle, mostOfTriangle)});
  }
  const auto deviations = measure(surface_.mesh(), warped_, pieces, warp_);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& triangle = surface_.triangles()[triangles[i]];
    const std::uint32_t side = triangle.sides[triangle.longest];
    const auto& [a, b] = surface_.sides()[side].ends;
    Need& need = needs_[surface_.sides()[side].edge];
    need.score = std::max(need.score, score(deviations[i], distance(warped_.positions, a, b)));
    surface_.setDistance(triangles[i], deviations[i].distance);
  }
}

bool Refiner::hasWantedSide(const Triangle& triangle) const {
  return std::any_of(triangle.sides.begin(), triangle.sides.end(), [&](std::uint32_t side) {
    return needs_[surface_.sides()[side].edge].isWanted();
  });
}

float Refiner::score(const Deviation& deviation, float warpedLength) const {
  const float byDistance = deviation.distance / refinement_.tolerance;
  const bool isLong = warpedLength > shortestForAngle * refinement_.tolerance;
  return std::max(byDistance, isLong ? deviation.angle / refinement_.angle : 0);
}

bool Refiner::hasRoom(const Edge& edge) const {
  const Position middle = surface_.middleOf(edge);
  return middle != surface_.endOf(edge, 0) && middle != surface_.endOf(edge, 1);
}

}  // namespace warpjet
