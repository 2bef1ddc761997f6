/** The normal of a collapsed surface. If a warp collapses a surface, as `floor` does, its normal is zero, which cannot be lit. */
import type { Target } from '../../compile/hosts.js'

/**
 * Returns GLSL that defines `warpjetFacing`, which returns the geometric normal of the drawn triangle, on the side of the eye, at a point
 * in view space. Call it outside of branches, where screen-space derivatives are defined. WebGL 1 has no such derivatives without an
 * extension; there the function returns the direction to the eye, which in a parallel projection (w is 1) is the z axis everywhere.
 */
export const facingInGlsl = (target: Target) => `vec3 warpjetFacing(vec3 viewPosition) {
  vec3 toEye = abs(gl_FragCoord.w - 1.0) < 1e-6 ? vec3(0.0, 0.0, 1.0) : -viewPosition;
${
  target === 'glsl100'
    ? '  return normalize(toEye);'
    : `  vec3 normal = cross(dFdx(viewPosition), dFdy(viewPosition));
  if (normal == vec3(0.0)) return normalize(toEye);
  return normalize(dot(normal, toEye) < 0.0 ? -normal : normal);`
}
}`

/** The function `warpjetFacing` in WGSL. */
export const facingInWgsl = `fn warpjetFacing(viewPosition: vec3<f32>) -> vec3<f32> {
  let isParallel = camera.uProjectionMatrix[3][3] == 1.0;
  let toEye = select(-viewPosition, vec3<f32>(0.0, 0.0, 1.0), isParallel);
  let normal = cross(dpdx(viewPosition), dpdy(viewPosition));
  if (all(normal == vec3<f32>())) { return normalize(toEye); }
  return normalize(select(normal, -normal, dot(normal, toEye) < 0.0));
}`
