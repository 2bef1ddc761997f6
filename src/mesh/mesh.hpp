// A triangle mesh as flat arrays: the data that files are read into, warps transform, and exports
// write.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace warpjet {

// An image as stored in its file: encoded, with its MIME type.
struct Image {
  std::vector<std::uint8_t> bytes;
  std::string mimeType;

  bool operator==(const Image&) const = default;
};

// The base color is linear, red, green, blue and alpha from 0 to 1, and multiplies the texture. The
// normal texture is in tangent space, as in glTF.
struct Material {
  std::array<float, 4> baseColor{1, 1, 1, 1};
  std::optional<Image> baseColorTexture = {}, normalTexture = {};

  bool operator==(const Material&) const = default;
};

// Numbers per vertex: positions and normals 3, uvs 2, colors 4 (linear, 0 to 1), tangents 4 (the
// last is the bitangent's sign, 1 or -1). All but positions may be empty. Three indices form a
// triangle; without indices, vertices are in the order of the triangles.
struct Mesh {
  std::vector<float> positions, normals, uvs, colors, tangents;
  // Empty until surface/variation.hpp fills them: the gradients over the surface of x, y and z of
  // the normal, and of u and v, each with 3 floats per vertex.
  std::array<std::vector<float>, 5> gradients;
  std::vector<std::uint32_t> indices;
  // One per vertex, or empty: 1 if a material of an .obj sets the color, 0 if the file has none. p5
  // draws the latter in its fill color.
  std::vector<std::uint8_t> painted;
  std::optional<Material> material;

  std::size_t vertexCount() const { return positions.size() / 3; }
  std::size_t triangleCount() const {
    return (indices.empty() ? vertexCount() : indices.size()) / 3;
  }
  // Returns the vertices of triangle i.
  std::array<std::uint32_t, 3> corners(std::size_t i) const {
    const auto first = static_cast<std::uint32_t>(3 * i);
    if (indices.empty()) return {first, first + 1, first + 2};
    return {indices[first], indices[first + 1], indices[first + 2]};
  }
};

}  // namespace warpjet
