import type { Shader } from '../host.js'

/**
 * Returns hooks that light a collapsed triangle as if it faced the eye. If a warp collapses a whole triangle, as `floor` does, its
 * normals are zero, and p5 would light it by normalize(vec3(0)).
 */
export const zeroNormalHooks = ({ hooks }: Shader) =>
  'Inputs getPixelInputs' in hooks.fragment && {
    'Inputs getPixelInputs': `(Inputs inputs) {
  if (vNormal == vec3(0.0)) inputs.normal = normalize(-vViewPosition);
  return inputs;
}`,
  }
