import type { Shader } from '../host.js'

/**
 * Where a warp collapses a whole triangle, as `floor` does, its normals are zero, and p5 would light it by normalize(vec3(0)). These
 * hooks light it as if it faced the eye.
 */
export const zeroNormalHooks = ({ hooks }: Shader) =>
  'Inputs getPixelInputs' in hooks.fragment && {
    'Inputs getPixelInputs': `(Inputs inputs) {
  if (vNormal == vec3(0.0)) inputs.normal = normalize(-vViewPosition);
  return inputs;
}`,
  }
