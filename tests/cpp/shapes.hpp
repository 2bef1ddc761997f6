// Meshes for tests of the mesh module, computed by formulas.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"

namespace warpjet {

inline void append(std::vector<float>& to, std::initializer_list<double> numbers) {
  for (const double number : numbers) to.push_back(static_cast<float>(number));
}

// Returns a square from -size/2 to size/2 in x and y, facing z, with 2 steps² triangles and uvs
// from 0 to 1.
inline Mesh gridPlane(int steps, double size) {
  Mesh mesh;
  for (int j = 0; j <= steps; ++j) {
    for (int i = 0; i <= steps; ++i) {
      const double u = double(i) / steps, v = double(j) / steps;
      append(mesh.positions, {(u - 0.5) * size, (v - 0.5) * size, 0});
      append(mesh.normals, {0, 0, 1});
      append(mesh.uvs, {u, v});
    }
  }
  const auto row = static_cast<std::uint32_t>(steps + 1);
  for (std::uint32_t j = 0; j + 1 < row; ++j) {
    for (std::uint32_t i = 0; i + 1 < row; ++i) {
      const std::uint32_t a = j * row + i;
      for (const std::uint32_t corner : {a, a + 1, a + row + 1, a, a + row + 1, a + row})
        mesh.indices.push_back(corner);
    }
  }
  return mesh;
}

// Returns a cube whose faces share no vertices: each has 4 vertices with their own normals, uvs and
// color.
inline Mesh cubeOfFaces(double size) {
  Mesh mesh;
  for (std::uint32_t face = 0; face < 6; ++face) {
    const std::uint32_t axis = face / 2;
    const double sign = face % 2 == 0 ? 1 : -1;
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
      const double u = corner == 1 || corner == 2 ? 1 : 0, v = corner >= 2 ? 1 : 0;
      std::array<double, 3> position{}, normal{};
      position[axis] = normal[axis] = sign;
      position[(axis + 1) % 3] = sign * (2 * u - 1);
      position[(axis + 2) % 3] = 2 * v - 1;
      for (double& x : position) x *= size / 2;
      append(mesh.positions, {position[0], position[1], position[2]});
      append(mesh.normals, {normal[0], normal[1], normal[2]});
      append(mesh.uvs, {u, v});
      append(mesh.colors, {face / 6.0, 0, 1, 1});
    }
    for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
      mesh.indices.push_back(4 * face + corner);
  }
  return mesh;
}

// Returns a cube of 8 vertices and 12 triangles, without normals.
inline Mesh cube(double size) {
  const Mesh faces = cubeOfFaces(size);
  Mesh mesh;
  std::map<std::array<float, 3>, std::uint32_t> numbers;
  for (const std::uint32_t i : faces.indices) {
    const float* const p = faces.positions.data() + 3 * i;
    const std::array<float, 3> position{p[0], p[1], p[2]};
    const auto [entry, isNew] =
        numbers.try_emplace(position, static_cast<std::uint32_t>(numbers.size()));
    if (isNew) mesh.positions.insert(mesh.positions.end(), p, p + 3);
    mesh.indices.push_back(entry->second);
  }
  return mesh;
}

// Returns a sphere of rings and sectors, as modeling tools export it: the uvs have a seam along one
// meridian, and each pole is a row of vertices.
inline Mesh sphereWithSeam(int sectors, int rings, double radius) {
  const double pi = std::numbers::pi;
  Mesh mesh;
  for (int j = 0; j <= rings; ++j) {
    for (int i = 0; i <= sectors; ++i) {
      // The last column has exactly the positions of the first one.
      const double longitude = 2 * pi * (i % sectors) / sectors, latitude = pi * j / rings;
      const double around = j == 0 || j == rings ? 0 : std::sin(latitude);
      const double x = around * std::cos(longitude), z = around * std::sin(longitude),
                   y = std::cos(latitude);
      append(mesh.positions, {radius * x, radius * y, radius * z});
      append(mesh.normals, {x, y, z});
      append(mesh.uvs, {double(i) / sectors, double(j) / rings});
      append(mesh.tangents, {-std::sin(longitude), 0, std::cos(longitude), 1});
    }
  }
  const auto row = static_cast<std::uint32_t>(sectors + 1);
  for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rings); ++j) {
    for (std::uint32_t i = 0; i + 1 < row; ++i) {
      const std::uint32_t a = j * row + i;
      if (j > 0) mesh.indices.insert(mesh.indices.end(), {a, a + 1, a + row + 1});
      if (j + 1 < static_cast<std::uint32_t>(rings))
        mesh.indices.insert(mesh.indices.end(), {a, a + row + 1, a + row});
    }
  }
  return mesh;
}

// Returns an icosahedron whose triangles are split into four, `levels` times, with the vertices
// projected onto the sphere.
inline Mesh icosphere(int levels, double radius) {
  using Corner = std::array<double, 3>;
  const double g = std::numbers::phi;
  std::vector<Corner> points{{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                             {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                             {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  std::vector<std::uint32_t> indices{0, 11, 5, 0, 5,  1,  0,  1,  7,  0,  7, 10, 0, 10, 11,
                                     1, 5,  9, 5, 11, 4,  11, 10, 2,  10, 7, 6,  7, 1,  8,
                                     3, 9,  4, 3, 4,  2,  3,  2,  6,  3,  6, 8,  3, 8,  9,
                                     4, 9,  5, 2, 4,  11, 6,  2,  10, 8,  6, 7,  9, 8,  1};
  for (; levels > 0; --levels) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [entry, isNew] =
          middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(points.size()));
      if (isNew) {
        const Corner p = points[a], q = points[b];
        points.push_back({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
      }
      return entry->second;
    };
    std::vector<std::uint32_t> finer;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
      const std::uint32_t a = indices[i], b = indices[i + 1], c = indices[i + 2];
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
    }
    indices = finer;
  }
  Mesh mesh;
  mesh.indices = indices;
  for (const auto& [x, y, z] : points) {
    const double length = std::hypot(x, y, z);
    append(mesh.positions, {radius * x / length, radius * y / length, radius * z / length});
    append(mesh.normals, {x / length, y / length, z / length});
  }
  return mesh;
}

}  // namespace warpjet
