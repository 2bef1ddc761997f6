// Reads flat arrays as points.
#pragma once

#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace warpjet {

inline glm::vec3 at(const std::vector<float>& numbers, std::size_t vertex) {
  return {numbers[3 * vertex], numbers[3 * vertex + 1], numbers[3 * vertex + 2]};
}

inline float distance(const std::vector<float>& positions, std::size_t a, std::size_t b) {
  return glm::distance(at(positions, a), at(positions, b));
}

// Returns a normal whose length is the area of the parallelogram, twice that of the triangle.
inline glm::vec3 areaVector(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
  return glm::cross(b - a, c - a);
}

inline float angleBetween(glm::vec3 a, glm::vec3 b) {
  // Kahan's formula, accurate also for small angles.
  const glm::vec3 u = a * glm::length(b), v = b * glm::length(a);
  return 2 * std::atan2(glm::length(u - v), glm::length(u + v));
}

}  // namespace warpjet
