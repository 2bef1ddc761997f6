#include "mesh/check.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/messages.hpp"

namespace warpjet {

namespace {

// Returns the problem of an array with `width` floats per vertex; an empty array has none.
std::string problemOf(const char* name, const std::vector<float>& numbers, std::size_t width,
                      std::size_t vertices) {
  if (!numbers.empty() && numbers.size() != vertices * width)
    return std::string(name) + " must hold " + std::to_string(width) + " numbers a vertex, " +
           groupDigits(vertices * width) + " for " + groupDigits(vertices) +
           " vertices, but hold " + groupDigits(numbers.size()) + '.';
  const auto invalid = std::find_if_not(numbers.begin(), numbers.end(),
                                        [](float number) { return std::isfinite(number); });
  if (invalid != numbers.end())
    return std::string(name) + " must be finite numbers, but vertex " +
           groupDigits((invalid - numbers.begin()) / width) + " has " +
           (std::isnan(*invalid) ? "NaN" : "Infinity") + '.';
  return {};
}

std::string problemOfIndices(const Mesh& mesh) {
  const std::size_t vertices = mesh.vertexCount();
  if (mesh.indices.empty()) {
    if (vertices % 3 == 0) return {};
    return "without indices every three vertices make a triangle, but there are " +
           groupDigits(vertices) + " vertices.";
  }
  if (mesh.indices.size() % 3 != 0)
    return "every three indices make a triangle, but there are " +
           groupDigits(mesh.indices.size()) + " indices.";
  const std::uint32_t highest = *std::max_element(mesh.indices.begin(), mesh.indices.end());
  if (highest < vertices) return {};
  return "index " + groupDigits(highest) + " has no vertex; there are only " +
         groupDigits(vertices) + " vertices, counted from 0.";
}

}  // namespace

std::string problemOf(const Mesh& mesh) {
  const std::size_t vertices = mesh.vertexCount();
  if (mesh.positions.size() % 3 != 0)
    return "positions must hold 3 numbers a vertex, but hold " +
           groupDigits(mesh.positions.size()) + '.';
  for (const std::string& problem :
       {problemOf("positions", mesh.positions, 3, vertices),
        problemOf("normals", mesh.normals, 3, vertices), problemOf("uvs", mesh.uvs, 2, vertices),
        problemOf("colors", mesh.colors, 4, vertices),
        problemOf("tangents", mesh.tangents, 4, vertices), problemOfIndices(mesh)}) {
    if (!problem.empty()) return problem;
  }
  return {};
}

}  // namespace warpjet
