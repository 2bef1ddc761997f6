// The corners of OBJ faces: the elements of the file's lists that they refer to, and the vertices
// that they become.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "graph/none.hpp"
#include "mesh/obj/buckets.hpp"
#include "mesh/text/lines.hpp"

namespace warpjet {

// Indices into the lists of positions, uvs, normals and material colors, counted from 0, or `none`.
struct ObjCorner {
  std::uint32_t position, uv, normal, color = none;

  bool operator==(const ObjCorner&) const = default;
};

// The current lengths of the lists.
struct ObjCounts {
  std::size_t positions, uvs, normals;
};

// Parses the corners of a face: v, v/vt, v//vn or v/vt/vn, counted from 1 or, if negative, from the
// end. Returns whether all the uvs and normals that they refer to exist; missing ones are omitted.
// Throws a FileProblem.
bool readCorners(TextLine& line, const ObjCounts& counts, std::vector<ObjCorner>& corners);

// Assigns a vertex to each combination that faces use.
class ObjVertices {
 public:
  explicit ObjVertices(std::size_t maxCount) : buckets_(maxCount) {}

  std::uint32_t vertexOf(const ObjCorner& corner);

  const std::vector<ObjCorner>& all() const { return corners_; }

 private:
  Buckets buckets_;
  std::vector<ObjCorner> corners_;
};

}  // namespace warpjet
