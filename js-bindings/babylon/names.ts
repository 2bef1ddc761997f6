// The names of a warp in shaders of Babylon.js.
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

/** Defines that say which variation a mesh has: of the normal, and of the texture coordinates. */
export const variationDefines = { normal: 'WARPJET_VARIATION', uv: 'WARPJET_UV_VARIATION' }

/** Defines that select a mesh's code: of normals at pixels, and of the frame of a tangent, by which maps turn the normal. */
export const normalDefines = { pixel: 'WARPJET_PIXEL', frame: 'WARPJET_FRAME' }

/** The defines that depend on the mesh, as they are without one. */
export const meshDefines = Object.fromEntries(
  [...Object.values(variationDefines), ...Object.values(normalDefines)].map((name) => [
    name,
    false,
  ]),
)

/** Writes code of a warp with these names. */
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
