// The corners of OBJ faces: which elements of the file's lists they name, and the vertices that
// they become.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "graph/none.hpp"
#include "mesh/obj/buckets.hpp"
#include "mesh/text/lines.hpp"

namespace warpjet {

// Places in the lists of positions, uvs, normals and colours of materials, counted from 0, or
// `none`.
struct ObjCorner {
  std::uint32_t position, uv, normal, paint = none;

  bool operator==(const ObjCorner&) const = default;
};

// How long the lists are so far.
struct ObjCounts {
  std::size_t positions, uvs, normals;
};

// The corners of a face: v, v/vt, v//vn or v/vt/vn, counted from 1 or, if negative, from the end.
// Answers whether all the uvs and normals that they name are there; a corner goes without those
// that are not. Throws a FileProblem.
bool readCorners(TextLine& line, const ObjCounts& counts, std::vector<ObjCorner>& corners);

// Gives each combination that faces use its vertex.
class ObjVertices {
 public:
  explicit ObjVertices(std::size_t most) : buckets_(most) {}

  std::uint32_t vertexOf(const ObjCorner& corner);

  const std::vector<ObjCorner>& all() const { return corners_; }

 private:
  Buckets buckets_;
  std::vector<ObjCorner> corners_;
};

}  // namespace warpjet
