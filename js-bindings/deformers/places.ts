// Where a warp stands among others: its inputs at a place that is itself computed.
import type { Vec3, WarpInputs } from '../types/types.js'

/** What the normals at a place are turned from: the vertex, an input, and its normal. */
interface Surface {
  position: Vec3
  normal: Vec3
}

/** By the position that a warp is given, unless that is the vertex itself. */
const surfaces = new WeakMap<Vec3, Surface>()

export const surfaceOf = (inputs: WarpInputs): Surface =>
  surfaces.get(inputs.position) ?? { position: inputs.position, normal: inputs.normal }

/**
 * The inputs with another position, and with the unit normal that the surface has there. That is turned by all that lies
 * between the vertex and the position, warps and spaces alike, and not made unless somebody reads it.
 */
export function inputsAt(
  inputs: WarpInputs,
  position: Vec3,
  surface = surfaceOf(inputs),
): WarpInputs {
  surfaces.set(position, surface)
  let turned: Vec3 | undefined
  const normal = () =>
    (turned ??= inputs.glsl.adjustNormal(
      position.sub(surface.position),
      surface.normal,
      surface.position,
    ))
  return Object.defineProperties({} as WarpInputs, {
    ...Object.getOwnPropertyDescriptors(inputs),
    position: { value: position, enumerable: true },
    normal: { get: normal, enumerable: true },
  })
}
