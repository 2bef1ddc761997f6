// The constants by which the numbers of pieces of edges are chosen: see triangle_needs.cpp. The
// compute passes in WGSL get them from here, too.
#pragma once

namespace warpjet {

struct Criterion {
  // Triangles are invisible if all of their samples are outside of the view times this factor.
  float margin = 1.3f;
  // The min depth of a sample, as a share of the largest depth of its triangle's corners.
  float nearest = 0.1f;
  // The max distance of a sample from the middle of the view, in halves of the view. Samples that
  // are farther away are treated as if they were at this distance.
  float aside = 1.5f;
  // A cell faces away if its signed area on the screen is below minus this share of the product of
  // two of its sides.
  float away = 0.2f;
  // These replace `margin` and `away` for flat triangles between warped corners. A triangle needs
  // no samples if by these values it is invisible, and so are its neighbors.
  float flatMargin = 1.5f;
  float flatAway = 0.5f;
  // The error of an undivided triangle, as a multiple of that at its 15 samples: at least 16/15, as
  // if the surface bends equally in all directions.
  float beyondFlat = 1.2f;
  // A piece of length h errs by h^2 / 8 times the second derivative; a triangle errs most in its
  // middle, by 4/3 of that.
  float error = 4.0f / 3 / 8;
  // A kink at which the slope jumps by j errs by j * h / 4 for pieces of length h. So the number of
  // pieces is this factor times the square of the number that the bend asks for. The bend is
  // measured in the cell that shows it best, where it is 1 to 2 times as large as j says.
  float kinkFactor = 0.75f;
  // The max number of pieces because of a kink, and their min length, in tolerances: where the
  // slope jumps by so much that more would be needed, the surface is a wall.
  float maxPiecesAtKink = 8;
  float minLengthAtKink = 2;
  // The samples of a triangle underestimate its bend, so edges aim at this share of the tolerance.
  // With 0.6, few points of the warps of the gallery err by more than the tolerance, and none by
  // more than 1.07 times as much.
  float aim = 0.6f;
  // The number of pieces is lowered only to a number that would suffice for this many times the
  // need.
  float hysteresis = 1.1f;
  // The min width and height of a triangle, as a share of its sides. Slivers are treated as if they
  // had these: second differences of floats, divided by the square of almost no length, would be
  // rounding errors.
  float minLength = 0.01f;
  // A diagonal is flipped only if that shortens its square by more than this share of the sizes of
  // all terms of the difference, so that rounding doesn't decide.
  float minGain = 0.01f;
};

inline constexpr Criterion criterion;

}  // namespace warpjet
