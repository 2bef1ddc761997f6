/** The normal of a collapsed surface. If a warp collapses a surface, as `floor` does, its normal is zero, which cannot be lit. */
import type { Target } from '../../compile/hosts.js'

/**
 * Returns GLSL that defines `warpjetFacing`: the geometric normal at a point in view space, as the triangle is drawn, on the side of
 * the eye. It is called outside of branches, where derivatives on the screen are defined. WebGL 1 has none without an extension; there
 * it is the direction of the eye.
 */
export const facingInGlsl = (target: Target) => `vec3 warpjetFacing(vec3 viewPosition) {
${
  target === 'glsl100'
    ? '  return normalize(-viewPosition);'
    : `  vec3 normal = cross(dFdx(viewPosition), dFdy(viewPosition));
  if (normal == vec3(0.0)) return normalize(-viewPosition);
  return normalize(dot(normal, viewPosition) > 0.0 ? -normal : normal);`
}
}`

/** Does the same as `facingInGlsl`. */
export const facingInWgsl = `fn warpjetFacing(viewPosition: vec3<f32>) -> vec3<f32> {
  let normal = cross(dpdx(viewPosition), dpdy(viewPosition));
  if (all(normal == vec3<f32>())) { return normalize(-viewPosition); }
  return normalize(select(normal, -normal, dot(normal, viewPosition) > 0.0));
}`
