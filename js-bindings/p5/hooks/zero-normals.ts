import type { Target } from '../../compile/hosts.js'
import type { Shader } from '../host.js'
import { facingInGlsl } from './facing.js'

/**
 * Returns hooks that light a collapsed triangle, whose normals at vertices are zero, by its geometric normal; `false` if the shader has no
 * hook for pixels.
 */
export const zeroNormalHooks = ({ hooks }: Shader, target: Target) =>
  'Inputs getPixelInputs' in hooks.fragment && {
    fragmentDeclarations: facingInGlsl(target),
    'Inputs getPixelInputs': `(Inputs inputs) {
  vec3 warpjetFacingNormal = warpjetFacing(vViewPosition);
  if (vNormal == vec3(0.0)) inputs.normal = warpjetFacingNormal;
  return inputs;
}`,
  }
