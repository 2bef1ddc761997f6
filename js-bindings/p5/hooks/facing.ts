import type { Shader } from '../host.js'

/**
 * Where a warp collapses a whole triangle's normals, as `floor` does, there is nothing to interpolate, and p5 would
 * light the triangle by normalize(vec3(0)). Such a place is lit as if it faced the eye.
 */
export const facingTheEye = ({ hooks }: Shader) =>
  'Inputs getPixelInputs' in hooks.fragment && {
    'Inputs getPixelInputs': `(Inputs inputs) {
  if (vNormal == vec3(0.0)) inputs.normal = normalize(-vViewPosition);
  return inputs;
}`,
  }
