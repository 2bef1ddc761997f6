// Computes the inputs of a warp inside a composition, where the position is itself computed.
import type { Glsl, Scalar, Vec3, WarpInputs } from '../core/types/types.js'

/** The vertex and its normal, from which normals at a computed position are derived. */
interface Surface {
  position: Vec3
  normal: Vec3
  /** -1 if an odd number of the coordinate transforms from the vertex to the position mirror, otherwise 1; absent if there are none. */
  side?: Scalar | number
}

/**
 * An internal method of the builder: returns -1 if the offset mirrors all of space, 1 if it mirrors none of it, and 0 if it may mirror
 * parts.
 */
interface Orienting {
  orientation(offset: Vec3, normal: Vec3, position: Vec3): Scalar
}

/** Maps the computed position that a warp gets → the surface from which it was computed. */
const surfaces = new WeakMap<Vec3, Surface>()

export const surfaceOf = (inputs: WarpInputs): Surface =>
  surfaces.get(inputs.position) ?? { position: inputs.position, normal: inputs.normal }

/**
 * Returns the inputs with another position, and with the unit normal of the surface there. The normal is transformed by all warps
 * and coordinate transforms from the vertex to the position, and computed only if it is read.
 */
export function inputsAt(
  inputs: WarpInputs,
  position: Vec3,
  surface = surfaceOf(inputs),
): WarpInputs {
  surfaces.set(position, surface)
  let warpedNormal: Vec3 | undefined
  const normal = () => (warpedNormal ??= outwardNormal(inputs.glsl, position, surface))
  return Object.defineProperties({} as WarpInputs, {
    ...Object.getOwnPropertyDescriptors(inputs),
    position: { value: position, enumerable: true },
    normal: { get: normal, enumerable: true },
  })
}

/** Returns the outward unit normal at `place`. Where it is unknown whether the whole offset mirrors space, uses `side`. */
function outwardNormal(glsl: Glsl, place: Vec3, { position, normal, side }: Surface): Vec3 {
  const offset = place.sub(position)
  const warpedNormal = glsl.adjustNormal(offset, normal, position)
  if (side === undefined) return warpedNormal
  const orientation = (glsl as unknown as Orienting).orientation(offset, normal, position)
  return warpedNormal.mult(orientation.eq(0).ifElse(side, 1))
}
