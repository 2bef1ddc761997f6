// Four triangles at once: each number of these vectors is one of the first triangle, one of the
// second, and so on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "eval/lanes_rounding.hpp"

namespace warpjet {

using Vec2 = glm::vec<2, Lanes>;
using Vec3 = glm::vec<3, Lanes>;
using Vec4 = glm::vec<4, Lanes>;

inline Lanes dot(const Vec2& a, const Vec2& b) { return a.x * b.x + a.y * b.y; }
inline Lanes dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// Returns m * (v, 0).
inline Vec4 transformVector(const glm::mat4& m, const Vec3& v) {
  Vec4 all;
  for (int i = 0; i < 4; ++i)
    all[i] = v.x * Lanes(m[0][i]) + v.y * Lanes(m[1][i]) + v.z * Lanes(m[2][i]);
  return all;
}

// Returns m * (p, 1).
inline Vec4 transformPoint(const glm::mat4& m, const Vec3& p) {
  return transformVector(m, p) + Vec4(m[3]);
}

// Returns number `offset` of each of four arrays. (Setting one lane after another would write them
// to memory and wait for that.)
inline Lanes gather(const std::array<const float*, Lanes::count>& arrays, std::size_t offset = 0) {
  return Lanes::Floats{arrays[0][offset], arrays[1][offset], arrays[2][offset], arrays[3][offset]};
}

// Returns the vectors to which these point.
inline Vec3 gatherVectors(const std::array<const float*, Lanes::count>& vectors) {
  return {gather(vectors, 0), gather(vectors, 1), gather(vectors, 2)};
}

using FourTriangles = std::array<std::uint32_t, Lanes::count>;

// Returns the next four of these triangles. The last one is repeated if there are fewer.
inline FourTriangles fourAt(std::span<const std::uint32_t> triangles, std::size_t first) {
  FourTriangles four;
  for (std::size_t i = 0; i < four.size(); ++i)
    four[i] = triangles[first + i < triangles.size() ? first + i : triangles.size() - 1];
  return four;
}

}  // namespace warpjet
