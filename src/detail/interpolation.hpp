// Interpolates attributes between the vertices of a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "detail/base_mesh.hpp"
#include "detail/pn_triangles.hpp"

namespace warpjet {

// A triangular part of a triangle of the given mesh: the index of that triangle, and the corners of
// the part by weights of the triangle's corners.
struct Patch {
  std::uint32_t triangle;
  std::array<Weights, 3> corners;
};

// Returns one patch for each triangle, which covers all of it.
std::vector<Patch> makeWholePatches(std::size_t triangles);

// Blends attributes linearly over a triangle; unit vectors keep length 1. On a curved surface,
// positions and normals are those of the PN triangles.
class Interpolation {
 public:
  explicit Interpolation(const BaseMesh& base) : base_(base) {}
  // `patches` has one patch for each triangle of `base`.
  Interpolation(const BaseMesh& base, const PnTriangles* surface, std::span<const Patch> patches)
      : base_(base), surface_(surface), patches_(patches) {}

  const BaseMesh& base() const { return base_; }
  bool isCurved() const { return surface_ != nullptr; }

  // Appends a vertex to all attributes. `weights` are those of the ends of the side. On both sides
  // of a seam, the vertex gets the same bits.
  void appendOnSide(std::vector<Attribute>& to, std::uint32_t side,
                    const std::array<float, 2>& weights) const;
  void appendInside(std::vector<Attribute>& to, std::size_t triangle, const Weights& weights) const;

  std::uint32_t patchOf(std::size_t triangle) const { return patches_[triangle].triangle; }
  // Converts weights in a triangle to weights in the given triangle that its patch is a part of.
  Weights onPatch(std::size_t triangle, const Weights& weights) const;

  // The attributes of samples, which divide each side into four: see `BaseMesh::sampleOfSide`.
  std::vector<Attribute> samples() const;

 private:
  void curve(std::vector<Attribute>& to, std::size_t triangle, const Weights& weights) const;

  const BaseMesh& base_;
  const PnTriangles* surface_ = nullptr;
  std::span<const Patch> patches_;
};

}  // namespace warpjet
