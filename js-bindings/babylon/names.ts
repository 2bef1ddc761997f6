// The names that a warp's code uses in shaders of Babylon.js.
import { shaderNames, variationNames, type HostWarp, type Result } from '../compile/hosts.js'

/** Maps inputs of the offset function → their names in shaders. */
export const names: Readonly<Record<string, string>> = {
  position: 'positionUpdated',
  normal: 'normalUpdated',
  uv: 'uvUpdated',
  color: 'warpjetColor',
  tangent: 'tangentUpdated',
  millis: shaderNames.millis,
  ...Object.fromEntries(variationNames.map((name) => [name, `warpjet_${name}`])),
}

/** Defines that are set if a mesh has the surface variation of its normals, and of its texture coordinates. */
export const variationDefines = { normal: 'WARPJET_VARIATION', uv: 'WARPJET_UV_VARIATION' }

/** Defines that select code for a mesh: `pixel` for normals at pixels, `frame` for the tangent frame, which normal maps need. */
export const normalDefines = { pixel: 'WARPJET_PIXEL', frame: 'WARPJET_FRAME' }

/** The initial values of the defines that depend on the mesh. */
export const meshDefines = Object.fromEntries(
  [...Object.values(variationDefines), ...Object.values(normalDefines)].map((name) => [
    name,
    false,
  ]),
)

/** Writes the code of a warp with these names. */
export const textOf = (
  warp: HostWarp,
  stage: 'vertex' | 'fragment',
  results: Result[],
  isWGSL: boolean,
) =>
  warp[stage === 'fragment' ? 'fragmentText' : 'text'](
    isWGSL ? 'wgsl' : 'glsl300',
    results,
    isWGSL ? { names: { millis: `uniforms.${shaderNames.millis}` } } : {},
  )
