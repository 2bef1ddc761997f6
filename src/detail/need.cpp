#include "detail/need.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "detail/bend.hpp"
#include "detail/criterion.hpp"
#include "detail/kinked.hpp"
#include "detail/tessellation.hpp"
#include "detail/triangles_on_screen.hpp"

namespace warpjet {

namespace {

// The bends of four triangles, for an error of one pixel.
struct Bends {
  // The squared sides in the metric of the bend: see `Needs::squaredSides`.
  std::array<Lanes, 3> squares{0.0f, 0.0f, 0.0f};
  // The error of the given triangles that they are parts of, if these had the same bend everywhere.
  Lanes error = 0.0f;
};

Bends bendsOf(const PlanarTriangles& planar, const Directions& directions,
              const TrianglesOnScreen& screen) {
  Bends bends;
  std::array<Lanes, 3> sum{0.0f, 0.0f, 0.0f};
  for (const Cell& cell : cells) {
    std::array<Vec2, 3> alongSides = screen.secondDifferences(cell);
    for (Vec2& along : alongSides) along *= Lanes(float{sampleIntervals * sampleIntervals});
    const Quadratics bend = bendOf(planar, alongSides);
    const auto ifBent = [isBent = bend.areFinite()](Lanes x) { return ifElse(isBent, x, 0.0f); };
    std::array<Lanes, 6> squares;
    for (std::size_t i = 0; i < squares.size(); ++i) squares[i] = bend.along(directions[i]);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      bends.squares[i] = max(bends.squares[i], ifBent(squares[i]));
      sum[i] += ifBent(squares[i]);
    }
    bends.error = max(bends.error, ifBent(errorOf(squares[3], squares[4], squares[5])));
  }
  for (std::size_t i = 0; i < sum.size(); ++i) {
    Lanes& square = bends.squares[i];
    const Lanes mean = sum[i] / static_cast<float>(cells.size());
    square = (square + criterion.beyondCells * (square - mean)) * criterion.error;
  }
  return bends;
}

// The needs of four triangles.
struct TriangleNeeds {
  std::array<Lanes, 3> sides{0.0f, 0.0f, 0.0f};    // the squares of the numbers of pieces
  std::array<Lanes, 3> squares{0.0f, 0.0f, 0.0f};  // see `Needs::squaredSides`
  Lanes uniform = 0.0f;                            // the square of `Needs::uniformNeed`
};

// Raises the numbers of these lanes.
void raise(Lanes& numbers, Mask lanes, Lanes to) {
  numbers = max(numbers, ifElse(lanes, to, 0.0f));
}

// Returns where the corners of triangles would be if the given triangles that they are parts of
// were flat.
std::array<Vec3, 3> cornersOnGiven(const WarpedMesh& mesh, const FourTriangles& triangles) {
  const auto patchOf = [&](std::size_t lane) -> const Patch& {
    return mesh.patches[triangles[lane]];
  };
  std::array<Vec3, 3> given, corners;
  for (int i = 0; i < 3; ++i) {
    const auto at = [&](std::size_t lane) {
      return mesh.warped.data() + 3 * mesh.given[patchOf(lane).triangle][i];
    };
    given[i] = gatherVectors({at(0), at(1), at(2), at(3)});
  }
  for (int i = 0; i < 3; ++i) {
    const auto at = [&](std::size_t lane) { return patchOf(lane).corners[i].data(); };
    const Vec3 weights = gatherVectors({at(0), at(1), at(2), at(3)});
    corners[i] = given[0] * weights[0] + given[1] * weights[1] + given[2] * weights[2];
  }
  return corners;
}

TriangleNeeds needsOf(const WarpedMesh& mesh, const FourTriangles& triangles,
                      std::span<const ScreenView> views, float tolerance) {
  const Samples samples = samplesOf(mesh.base, triangles, mesh.warped);
  const PlanarTriangles planar(mesh.base, triangles);
  const Directions directions = directionsOf(planar, mesh.patches, triangles);
  const float aim = criterion.aim * tolerance;
  // Beside fronts and kinks, the surface can be flat, so that its bends don't show what a uniform
  // division misses. Then only the given triangles are tested, by the samples themselves.
  const bool hasFronts = !mesh.phases.fronts.empty();
  TriangleNeeds needs;
  for (const ScreenView& view : views) {
    const TrianglesOnScreen screen(view, samples);
    const Mask areVisible = screen.areVisible();
    if (!any(areVisible)) continue;
    // A triangle within which the surface bends back and forth can be close to all samples,
    // although the bends ask for pieces.
    const Lanes errorShare = screen.flatError() * criterion.beyondFlat / aim;
    const Mask areFine = logicalAnd(areVisible, le(errorShare, 1.0f));
    const Mask areRough = logicalAnd(areVisible, logicalNot(areFine));
    for (Lanes& side : needs.sides) raise(side, areFine, errorShare);
    if (hasFronts && !mesh.patches.empty()) {
      const Mask areFlat = le(screen.errorFrom(cornersOnGiven(mesh, triangles)), aim);
      raise(needs.uniform, areVisible, ifElse(areFlat, 1.0f, INFINITY));
    }
    if (mesh.patches.empty() && !any(areRough)) continue;
    const Bends bends = bendsOf(planar, directions, screen);
    // All triangles have samples, and the worst one decides, so no margin like `aim` is needed.
    if (!hasFronts) raise(needs.uniform, areVisible, bends.error / tolerance);
    for (std::size_t i = 0; i < needs.sides.size(); ++i) {
      raise(needs.sides[i], areRough, bends.squares[i] / aim);
      raise(needs.squares[i], areRough, bends.squares[i]);
    }
    if (!any(areRough)) continue;
    const Mask areRoughAtKinks = logicalAnd(areRough, areKinked(mesh.base, triangles, mesh.phases));
    const std::array<Lanes, 3> lengths = screen.sideLengths();
    for (std::size_t i = 0; i < needs.sides.size(); ++i) {
      const Lanes most =
          min(criterion.maxPiecesAtKink, lengths[i] / (criterion.minLengthAtKink * tolerance));
      const Lanes pieces = min(criterion.kinkFactor * bends.squares[i] / aim, most);
      raise(needs.sides[i], areRoughAtKinks, pieces * pieces);
    }
  }
  return needs;
}

}  // namespace

std::uint32_t roundUp(float need) {
  const auto found = std::find_if(pieceCounts.begin(), pieceCounts.end(), [&](std::uint32_t count) {
    return static_cast<float>(count) >= need;
  });
  return found == pieceCounts.end() ? maxPieces : *found;
}

bool Needs::update(const WarpedMesh& mesh, std::span<const ScreenView> views, float tolerance) {
  const BaseMesh& base = mesh.base;
  needs_.assign(base.edgeCount(), 0);
  float squaredUniformNeed = 0;
  squaredSides_.assign(base.triangles().size(), {});
  pieces_.resize(base.edgeCount(), 1);
  for (std::size_t first = 0; first < mesh.triangles.size(); first += Lanes::count) {
    const FourTriangles triangles = fourAt(mesh.triangles, first);
    const TriangleNeeds needs = needsOf(mesh, triangles, views, tolerance);
    for (std::size_t lane = 0; lane < triangles.size(); ++lane) {
      const std::uint32_t t = triangles[lane];
      squaredUniformNeed = std::max(squaredUniformNeed, needs.uniform[lane]);
      for (int i = 0; i < 3; ++i) {
        float& need = needs_[base.edgeOf(t, i)];
        need = std::max(need, needs.sides[i][lane]);
        squaredSides_[t][i] = needs.squares[i][lane];
      }
    }
  }
  uniformNeed_ = std::sqrt(squaredUniformNeed);
  bool isChanged = false;
  for (std::size_t edge = 0; edge < needs_.size(); ++edge) {
    const float need = std::sqrt(needs_[edge]);
    const std::uint32_t next =
        std::clamp(pieces_[edge], roundUp(need), roundUp(need * criterion.hysteresis));
    isChanged |= next != pieces_[edge];
    pieces_[edge] = next;
  }
  return isChanged;
}

}  // namespace warpjet
