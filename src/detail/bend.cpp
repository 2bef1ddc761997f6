#include "detail/bend.hpp"

#include "detail/criterion.hpp"

namespace warpjet {

namespace {

// Returns the positions of one corner of the triangles.
Vec3 cornersAt(const BaseMesh& base, const FourTriangles& triangles, int corner) {
  const float* positions = base.attributes()[0].values.data();
  const auto at = [&](std::size_t lane) {
    return positions + 3 * base.triangles()[triangles[lane]][corner];
  };
  return gatherVectors({at(0), at(1), at(2), at(3)});
}

}  // namespace

Vec3 weightsOf(int corner, std::span<const Patch> patches, const FourTriangles& triangles) {
  const auto at = [&](std::size_t lane) { return patches[triangles[lane]].corners[corner].data(); };
  return gatherVectors({at(0), at(1), at(2), at(3)});
}

PlanarTriangles::PlanarTriangles(const BaseMesh& base, const FourTriangles& triangles) {
  const Vec3 origin = cornersAt(base, triangles, 0);
  const Vec3 u = cornersAt(base, triangles, 1) - origin;
  const Vec3 v = cornersAt(base, triangles, 2) - origin;
  const Lanes minLength = criterion.minLength * sqrt(dot(u, u) + dot(v, v));
  width = max(minLength, sqrt(dot(u, u)));
  apex.x = dot(u, v) / width;
  apex.y = max(minLength, sqrt(max(0.0f, dot(v, v) - apex.x * apex.x)));
}

Directions directionsOf(const PlanarTriangles& planar, std::span<const Patch> patches,
                        const FourTriangles& triangles) {
  const Vec2 first(planar.width, 0.0f), second = planar.apex;
  const std::array<Vec2, 3> sides{first, second - first, second};
  if (patches.empty()) return {sides, sides};
  // u and v are the sides of the patch at its first corner, as changes of the weights of corners 1
  // and 2 of the given triangle (y and z), whose sides are (1, 0), (-1, 1) and (0, 1) in these
  // coordinates.
  const Vec3 origin = weightsOf(0, patches, triangles);
  const Vec3 u = weightsOf(1, patches, triangles) - origin;
  const Vec3 v = weightsOf(2, patches, triangles) - origin;
  const Lanes area = u.y * v.z - u.z * v.y;
  const Vec2 wholeFirst = (first * v.z - second * u.z) / area;
  const Vec2 wholeSecond = (second * u.y - first * v.y) / area;
  return {sides, {wholeFirst, wholeSecond - wholeFirst, wholeSecond}};
}

// A difference of numbers that are not finite is NaN.
Mask Quadratics::areFinite() const {
  const Lanes sum = xx + xy + yy;
  return eq(sum - sum, 0.0f);
}

Quadratics bendOf(const PlanarTriangles& planar, const std::array<Vec2, 3>& alongSides) {
  const Lanes perWidth = 1.0f / planar.width, perHeight = 1.0f / planar.apex.y;
  const Lanes x = planar.apex.x;
  Quadratics sum{0.0f, 0.0f, 0.0f};
  for (int k = 0; k < 2; ++k) {
    const Lanes first = alongSides[0][k], second = alongSides[1][k], third = alongSides[2][k];
    const Lanes mixed = 0.5f * (first + third - second);
    const Lanes xx = first * perWidth * perWidth;
    const Lanes xy = (mixed * perWidth - xx * x) * perHeight;
    const Lanes yy = ((third - xx * x * x) * perHeight - 2.0f * xy * x) * perHeight;
    sum.xx += xx * xx + xy * xy;
    sum.xy += xy * (xx + yy);
    sum.yy += xy * xy + yy * yy;
  }
  const Lanes root = sqrt(max(0.0f, sum.xx * sum.yy - sum.xy * sum.xy));
  const Lanes scale = 1.0f / sqrt(sum.xx + sum.yy + 2.0f * root);
  return {(sum.xx + root) * scale, sum.xy * scale, (sum.yy + root) * scale};
}

Lanes errorOf(Lanes a, Lanes b, Lanes c) {
  const Lanes longest = max(max(a, b), c), sum = a + b + c;
  const Lanes squaredArea = 4.0f * (a * b + b * c + c * a) - sum * sum;  // times 16
  const Mask isObtuse = le(sum - longest, longest);
  return ifElse(isObtuse, longest / 8.0f, a * b * c / squaredArea / 2.0f);
}

}  // namespace warpjet
