// The warp: an offset enters as a graph, and all that becomes of a surface leaves as nodes of the
// same graph. The only room that knows what a warp is.
#pragma once

#include <array>
#include <optional>

#include "algebra/value.hpp"
#include "diff/differentiator.hpp"

namespace warpjet {

// Of each vertex. The offset may depend on all but the tangent and the gradients.
struct WarpInputs {
  Value position, normal, uv;
  Value tangent;  // a direction, and in which direction the bitangent is: 1 or -1
  // Over the surface, of x, y and z of the normal and of u and v: how they vary.
  std::array<Value, 5> gradients;
  std::optional<Value> color = {};
};

// What the warp makes of what lies along the surface.
struct Turned {
  Value normal;     // of length 1, or zero where the warp collapses the surface
  Value tangent;    // of length 1, turned, at right angles to the normal; the bitangent's side
  Value direction;  // the tangent's direction, only turned: for lines, which have no surface
  Expression determinant;
};

struct Warp {
  Value offset, position;
  // Where normal and uv count as constant, and where they vary over the surface as the gradients
  // say; both are the same for an offset that depends on neither.
  std::optional<Turned> flat = {}, surface = {};
  // 1, or -1 where the warp mirrors all of space: see orientation.hpp. Normals are times this, and
  // the order of a triangle's vertices is turned round where it is -1.
  std::optional<Expression> orientation = {};
  // Whether any of it needs the gradients.
  bool varies = false;
};

struct WarpOptions {
  bool turns = true;   // otherwise there is only the position
  bool isFlat = true;  // whether `flat` is wanted too
};

Warp makeWarp(Differentiator& differentiator, const Value& offset, const WarpInputs& inputs,
              const WarpOptions& options = {});

// The parts of it.

// M = I + J, where J is the Jacobian of the offset by the position: what the warp makes of
// directions. Its determinant says how volume grows; where it is not above zero, the warp turns
// space inside out. `position` must be the three components of one input. All other inputs, normal
// and uv among them, count as constant.
Value deformation(Differentiator& differentiator, const Value& offset, const Value& position);

// M where `input`, which the offset depends on too, varies over the surface: by the chain rule
// M + df/dinput (dinput/dp), where `gradient` is the last. The components of the normal vary so,
// for an offset along the normal, and texture coordinates. M then holds for tangents of the
// surface.
//
// If the gradients lie in the surface, the determinant of M is that of the thin layer around it in
// which normal and texture coordinates stay the same along each normal: where it is not above zero,
// the two sides of the surface have changed places.
Value varied(Differentiator& differentiator, const Value& m, const Value& offset, Expression input,
             const Value& gradient);

// The unit normal of the surface whose tangents M turns, or zero where M collapses the surface so
// that it has none, or is not finite. Where M is known to stay moderate, a cof(M) n below 1e-19
// counts as collapsed, since float32 cannot hold its square; else it is scaled first.
//
// Tangents u and v of the surface become M u and M v, and (M u) x (M v) = cof(M) (u x v): the
// cofactor matrix, whose columns are m2 x m3, m3 x m1 and m1 x m2, turns normals. It equals
// equation 1 of Pagurek van Mossel's "Vertex Shader Domain Warping with Automatic Differentiation"
// (2024) for every choice of tangents. Where M collapses a direction (section 5.1 there) cof(M) n
// can vanish. Where M mirrors, it points to what was the inner side: `orientation` puts that right
// where all of space is mirrored. Where the surface folds, it is continuous as it is.
Value turnedNormal(const Value& m, const Value& normal);

// The orientation of M (orientation.hpp), for which all inputs but these two are the same for all
// vertices; and the normal times that, if there is one.
std::optional<Expression> orientationOf(const Value& m, const Value& normal, const Value& position);
Value outwardNormal(const Value& m, const Value& normal, const Value& position);

// The unit tangent M t, less what of it goes along `normal`, the turned one; zero where M collapses
// it. Beside cof(M) n the side of the bitangent stays: with t x b = n, (M t) x (M b) is cof(M) n
// for every M. Beside -cof(M) n it is the other one.
Value turnedTangent(const Value& m, const Value& tangent, const Value& normal);

}  // namespace warpjet
