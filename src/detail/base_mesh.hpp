// A mesh whose sides can be split without cracks: sides that join the same two places, even if a
// seam separates them, share an edge, and are split into the same number of pieces.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "detail/triangulate.hpp"
#include "mesh/surface/pairs.hpp"

namespace warpjet {

// A point of a triangle, given by the weights of the corners, which add up to 1.
using Weights = std::array<float, 3>;

// The values of all vertices. Attribute 0 of a mesh contains its positions, three numbers each.
struct Attribute {
  std::uint32_t size;   // numbers per vertex
  bool isUnit = false;  // true for normals, which keep their length when they are interpolated
  std::vector<float> values = {};
};

class BaseMesh {
 public:
  // Two vertices in order (see `inOrder`), so that both sides of a seam
  // interpolate from the same end, and get the same bits.
  struct Side {
    std::array<std::uint32_t, 2> ends;
    std::uint32_t edge;
    std::uint32_t triangle;  // the first one that has the side
  };

  BaseMesh(std::vector<Attribute> attributes, std::vector<Corners> triangles);

  std::size_t vertexCount() const { return attributes_[0].values.size() / 3; }
  std::uint32_t edgeCount() const { return edgeCount_; }
  std::span<const Attribute> attributes() const { return attributes_; }
  std::span<const Corners> triangles() const { return triangles_; }
  std::span<const Side> sides() const { return sides_; }
  // The sides of a triangle: side i goes from corner i to the next one, or back.
  const std::array<std::uint32_t, 3>& sidesOf(std::size_t triangle) const {
    return sidesOf_[triangle];
  }
  std::uint32_t edgeOf(std::size_t triangle, int side) const {
    return sides_[sidesOf_[triangle][side]].edge;
  }
  // Returns the index of the side between two vertices; `none` if no triangle has it.
  std::uint32_t sideBetween(std::uint32_t a, std::uint32_t b) const {
    const auto [first, second] = inOrder(a, b);
    return sidesByEnds_.find(first, second);
  }
  // Returns the number of the place of a vertex, which is below `vertexCount`. Vertices at one
  // place, on both sides of a seam, have the same number.
  std::uint32_t placeOf(std::uint32_t vertex) const { return places_[vertex]; }
  // Returns the length of a side at the present positions.
  float lengthOf(std::uint32_t side) const;
  bool startsAt(std::uint32_t side, std::uint32_t vertex) const {
    return sides_[side].ends[0] == vertex;
  }

  // Replaces the values of the vertices. The edges remain those of the first positions.
  void setAttributes(const std::vector<Attribute>& attributes) { attributes_ = attributes; }

  // Converts the weights of a side's ends to weights of the corners of the side's triangle.
  Weights onTriangle(std::uint32_t side, const std::array<float, 2>& weights) const;

  // Returns the index of a sample. Samples divide each side into four. First come all vertices,
  // then three samples for each side, from its first end to its second, then three for each
  // triangle, of which sample i is the one nearest to corner i.
  std::uint32_t sampleOfSide(std::uint32_t side, int i) const {
    return static_cast<std::uint32_t>(vertexCount()) + 3 * side + i;
  }
  std::uint32_t sampleOfTriangle(std::size_t triangle, int i) const {
    return static_cast<std::uint32_t>(vertexCount() + 3 * (sides_.size() + triangle)) + i;
  }

 private:
  void findSides();
  // Returns both vertices, starting with the one whose place has the lower number.
  std::array<std::uint32_t, 2> inOrder(std::uint32_t a, std::uint32_t b) const;

  std::vector<Attribute> attributes_;
  std::vector<Corners> triangles_;
  std::vector<std::array<std::uint32_t, 3>> sidesOf_;
  std::vector<Side> sides_;
  std::vector<std::uint32_t> places_;  // by vertex: see `placesOf`
  Pairs sidesByEnds_;
  std::uint32_t edgeCount_ = 0;
};

}  // namespace warpjet
