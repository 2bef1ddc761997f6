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

Lanes squareOf(Lanes x) { return x * x; }

// Raises the numbers of these lanes.
void raise(Lanes& numbers, Mask lanes, Lanes to) {
  numbers = max(numbers, ifElse(lanes, to, 0.0f));
}

TriangleNeeds needsOf(const WarpedMesh& mesh, const FourTriangles& triangles,
                      std::span<const ScreenView> views, float tolerance) {
  const Samples samples = samplesOf(mesh.base, triangles, mesh.warped);
  const PlanarTriangles planar(mesh.base, triangles);
  const Directions directions = directionsOf(planar, mesh.patches, triangles);
  const float aim = criterion.aim * tolerance;
  const Mask areBroken = areKinked(mesh.base, triangles, mesh.phases);
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
    if (mesh.patches.empty() && !any(areRough)) continue;
    const Bends bends = bendsOf(planar, directions, screen);
    // All triangles have samples, and the worst one decides, so no margin like `aim` is needed.
    raise(needs.uniform, areVisible, bends.error / tolerance);
    for (std::size_t i = 0; i < needs.sides.size(); ++i) {
      raise(needs.sides[i], areRough, bends.squares[i] / aim);
      raise(needs.squares[i], areRough, bends.squares[i]);
    }
    // Pieces of a kink err by their length, not by its square.
    const Mask areRoughKinks = logicalAnd(areBroken, areRough);
    if (!any(areRoughKinks)) continue;
    raise(needs.uniform, areRoughKinks, squareOf(bends.error / tolerance));
    for (std::size_t i = 0; i < needs.sides.size(); ++i)
      raise(needs.sides[i], areRoughKinks,
            squareOf(min(criterion.kink * bends.squares[i] / aim, criterion.maxAtKinks)));
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
