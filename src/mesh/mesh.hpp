// A triangle mesh as flat arrays: what files are read into, what warps move, what is written.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace warpjet {

// A picture as its file has it: encoded, with its MIME type.
struct Image {
  std::vector<std::uint8_t> bytes;
  std::string mimeType;

  bool operator==(const Image&) const = default;
};

// The base colour is linear, red, green, blue and alpha from 0 to 1, and multiplies the texture.
struct Material {
  std::array<float, 4> baseColor{1, 1, 1, 1};
  std::optional<Image> baseColorTexture;

  bool operator==(const Material&) const = default;
};

// So many numbers a vertex: positions and normals 3, uvs 2, colors 4 (linear, 0 to 1), tangents 4
// (the last is the bitangent's sign, 1 or -1). All but positions may be empty. Three indices make a
// triangle; none at all means that the vertices stand in the order of the triangles.
struct Mesh {
  std::vector<float> positions, normals, uvs, colors, tangents;
  // 3 each: how x, y and z of the normal and u and v vary over the surface, once
  // surface/variation.hpp has found that out.
  std::array<std::vector<float>, 5> gradients;
  std::vector<std::uint32_t> indices;
  // One for each vertex, or empty: 1 where a material of an .obj gives the colour, 0 where the file
  // gives none. p5 draws the latter in its fill colour.
  std::vector<std::uint8_t> painted;
  std::optional<Material> material;

  std::size_t vertexCount() const { return positions.size() / 3; }
  std::size_t triangleCount() const {
    return (indices.empty() ? vertexCount() : indices.size()) / 3;
  }
  // The vertices of the i-th triangle.
  std::array<std::uint32_t, 3> corners(std::size_t i) const {
    const auto first = static_cast<std::uint32_t>(3 * i);
    if (indices.empty()) return {first, first + 1, first + 2};
    return {indices[first], indices[first + 1], indices[first + 2]};
  }
};

}  // namespace warpjet
