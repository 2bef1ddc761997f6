// Takes the offset of a warp as a graph and returns the warped surface as nodes of the same graph.
// Only this module knows what a warp is.
#pragma once

#include <array>
#include <optional>

#include "algebra/value.hpp"
#include "diff/differentiator.hpp"

namespace warpjet {

// The inputs per vertex. The offset may depend on all of them but the tangent and the gradients.
struct WarpInputs {
  Value position, normal, uv;
  Value tangent;  // a direction, and the sign of the bitangent: 1 or -1
  // The surface gradients of the normal's x, y and z, and of u and v.
  std::array<Value, 5> gradients;
  std::optional<Value> color = {};
};

// The warped directions at a point of the surface.
struct WarpedDirections {
  Value normal;     // unit length; zero where the warp collapses the surface
  Value tangent;    // unit length, orthogonal to the normal; w is the bitangent's sign
  Value direction;  // the tangent's direction, not orthogonalized: for lines, which have no surface
  Expression determinant;
};

struct Warp {
  Value offset, position;
  // `flat` treats normal and uv as constant, `surface` takes into account that they vary over the
  // surface, with the gradients. Both are equal for an offset that depends on neither.
  std::optional<WarpedDirections> flat = {}, surface = {};
  // -1 where the warp mirrors all of space, otherwise 1: see orientation.hpp. Normals are
  // multiplied by it, and the winding order of triangles is reversed where it is -1.
  std::optional<Expression> orientation = {};
  // True if any result needs the gradients.
  bool varies = false;
};

struct WarpOptions {
  bool needsDirections = true;  // if false, only the position is computed
  bool isFlat = true;           // if true, `flat` is computed, too
};

Warp makeWarp(Differentiator& differentiator, const Value& offset, const WarpInputs& inputs,
              const WarpOptions& options = {});

// The steps of makeWarp.

// Returns M = I + J, where J is the Jacobian of the offset with respect to the position: M
// transforms directions. Its determinant is the change of volume; where it isn't positive, the warp
// turns space inside out. `position` must be the three components of one input. All other inputs,
// including normal and uv, are treated as constant.
Value deformation(Differentiator& differentiator, const Value& offset, const Value& position);

// Returns M, updated for an `input` that the offset depends on and that varies over the surface, by
// the chain rule with the offset f: M + df/dinput (dinput/dp), where `gradient` is dinput/dp. Used
// for components of the normal, if the offset is along the normal, and for texture coordinates. The
// resulting M is valid for tangents of the surface.
//
// If the gradients are tangential to the surface, the determinant of M is that of the thin layer
// around the surface in which normal and texture coordinates are constant along each normal: where
// it isn't positive, the two sides of the surface are swapped.
Value varyInput(Differentiator& differentiator, const Value& m, const Value& offset,
                Expression input, const Value& gradient);

// Returns the unit normal of the surface whose tangents M transforms. It is zero where M isn't
// finite, or collapses the surface so that it has no normal. If M's entries are known to be
// moderate in size, a cof(M) n below 1e-19 counts as collapsed, since float32 can't represent its
// square; otherwise it is scaled first.
//
// Tangents u and v of the surface become M u and M v, and (M u) x (M v) = cof(M) (u x v): the
// cofactor matrix, with columns m2 x m3, m3 x m1 and m1 x m2, transforms normals. It equals
// equation 1 of Pagurek van Mossel's "Vertex Shader Domain Warping with Automatic Differentiation"
// (2024) for every choice of tangents. Where M collapses a direction (section 5.1 there), cof(M) n
// can vanish. Where M mirrors, the normal points to the former inner side: `orientation` corrects
// that if all of space is mirrored. Where the surface folds, the normal is continuous without
// correction.
Value warpNormal(const Value& m, const Value& normal);

// Returns the orientation of M (orientation.hpp), if it is known. Only the position, and the inputs
// that the normal is computed from, may vary per vertex.
std::optional<Expression> orientationOf(const Value& m, const Value& normal, const Value& position);
// Returns the warped normal, multiplied by the orientation if it is known.
Value outwardNormal(const Value& m, const Value& normal, const Value& position);

// Returns the unit tangent M t, orthogonalized to `normal`, the warped normal; zero where M
// collapses it. With cof(M) n, the bitangent keeps its sign: if t x b = n, then (M t) x (M b) =
// cof(M) n for every M. With -cof(M) n, the sign flips.
Value warpTangent(const Value& m, const Value& tangent, const Value& normal);

}  // namespace warpjet
