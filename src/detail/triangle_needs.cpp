#include "detail/triangle_needs.hpp"

#include <cmath>
#include <cstddef>
#include <optional>

#include "detail/bend.hpp"
#include "detail/criterion.hpp"
#include "detail/kinked.hpp"
#include "detail/samples.hpp"

namespace warpjet {

namespace {

// The bends of four triangles, for an error of one pixel.
struct Bends {
  std::array<Lanes, 3> squaredSides{0.0f, 0.0f, 0.0f};
  // The error of the given triangles that they are parts of, if these had the same bend everywhere.
  Lanes error = 0.0f;
};

Bends bendsOf(const PlanarTriangles& planar, const Directions& directions,
              const TrianglesOnScreen& screen) {
  Bends bends;
  for (const Cell& cell : cells) {
    std::array<Vec2, 3> alongSides = screen.secondDifferences(cell);
    for (Vec2& along : alongSides) along *= Lanes(float{sampleIntervals * sampleIntervals});
    const Quadratics bend = bendOf(planar, alongSides);
    const auto squareAlong = [&, isBent = bend.areFinite()](const Vec2& side) {
      return ifElse(isBent, bend.along(side), 0.0f);
    };
    for (std::size_t i = 0; i < bends.squaredSides.size(); ++i)
      bends.squaredSides[i] =
          max(bends.squaredSides[i], criterion.error * squareAlong(directions.sides[i]));
    const auto& [first, second, third] = directions.givenSides;
    const Lanes error = errorOf(squareAlong(first), squareAlong(second), squareAlong(third));
    bends.error = max(bends.error, ifElse(bend.areFinite(), error, 0.0f));
  }
  return bends;
}

// Raises the numbers of these lanes.
void raise(Lanes& numbers, Mask lanes, Lanes to) {
  numbers = max(numbers, ifElse(lanes, to, 0.0f));
}

// Returns where the corners of triangles would be if the given triangles that they are parts of
// were flat.
std::array<Vec3, 3> cornersOnGiven(const WarpedMesh& mesh, const FourTriangles& triangles) {
  std::array<Vec3, 3> given, corners;
  for (int i = 0; i < 3; ++i) {
    const auto at = [&](std::size_t lane) {
      const Corners& whole = mesh.given[mesh.patches[triangles[lane]].triangle];
      return mesh.warped.data() + 3 * whole[i];
    };
    given[i] = gatherVectors({at(0), at(1), at(2), at(3)});
  }
  for (int i = 0; i < 3; ++i) {
    const Vec3 weights = weightsOf(i, mesh.patches, triangles);
    corners[i] = given[0] * weights[0] + given[1] * weights[1] + given[2] * weights[2];
  }
  return corners;
}

// Raises the needs of triangles across a kink: see `Criterion::kinkFactor`.
void raiseAtKinks(TriangleNeeds& needs, Mask areKinked, const Bends& bends,
                  const TrianglesOnScreen& screen, float tolerance) {
  const std::array<Lanes, 3> lengths = screen.sideLengths();
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const Lanes maxPieces =
        min(criterion.maxPiecesAtKink, lengths[i] / (criterion.minLengthAtKink * tolerance));
    const Lanes wanted = criterion.kinkFactor * bends.squaredSides[i] / (criterion.aim * tolerance);
    const Lanes pieces = min(wanted, maxPieces);
    raise(needs.squaredSides[i], areKinked, pieces * pieces);
  }
}

}  // namespace

TriangleNeeds needsOf(const WarpedMesh& mesh, const FourTriangles& triangles,
                      std::span<const ScreenView> views, float tolerance) {
  const Samples samples = samplesOf(mesh.base, triangles, mesh.warped);
  const PlanarTriangles planar(mesh.base, triangles);
  const Directions directions = directionsOf(planar, mesh.patches, triangles);
  const float aim = criterion.aim * tolerance;
  const bool isCut = !mesh.patches.empty();
  // Beside fronts and kinks, the surface can be flat, so that its bends don't show what a uniform
  // division misses. Then only the given triangles are tested, by the samples themselves.
  const bool canHideBends = !mesh.phases.fronts.empty();
  std::optional<Mask> kinked;
  TriangleNeeds needs;
  for (const ScreenView& view : views) {
    const TrianglesOnScreen screen(view, samples);
    const Mask areVisible = screen.areVisible();
    if (!any(areVisible)) continue;
    // A triangle within which the surface bends back and forth can be close to all samples,
    // although the bends ask for pieces.
    const Lanes flatNeed = screen.flatError() * criterion.beyondFlat / aim;
    const Mask areFlat = logicalAnd(areVisible, le(flatNeed, 1.0f));
    const Mask areBent = logicalAnd(areVisible, logicalNot(areFlat));
    for (Lanes& side : needs.squaredSides) raise(side, areFlat, flatNeed);
    if (canHideBends && isCut) {
      const Mask areGivenFlat = le(screen.errorFrom(cornersOnGiven(mesh, triangles)), aim);
      raise(needs.squaredUniform, areVisible, ifElse(areGivenFlat, 1.0f, INFINITY));
    }
    if (!isCut && !any(areBent)) continue;
    const Bends bends = bendsOf(planar, directions, screen);
    // All triangles have samples, and the worst one decides, so no margin like `aim` is needed.
    if (!canHideBends) raise(needs.squaredUniform, areVisible, bends.error / tolerance);
    for (std::size_t i = 0; i < needs.squaredSides.size(); ++i) {
      raise(needs.squaredSides[i], areBent, bends.squaredSides[i] / aim);
      raise(needs.bentSides[i], areBent, bends.squaredSides[i]);
    }
    if (!canHideBends || !any(areBent)) continue;
    if (!kinked) kinked = areKinked(mesh.base, triangles, mesh.phases);
    raiseAtKinks(needs, logicalAnd(areBent, *kinked), bends, screen, tolerance);
  }
  return needs;
}

}  // namespace warpjet
