// Where a warp stands among others: its inputs at a place that is itself computed.
import type { Glsl, Scalar, Vec3, WarpInputs } from '../core/types/types.js'

/** What the normals at a place are turned from: the vertex, an input, and its normal. */
interface Surface {
  position: Vec3
  normal: Vec3
  /** -1 or 1, by how many spaces that mirror lie between. */
  side?: Scalar | number
}

/** No list of functions has it: -1 or 1 if the offset mirrors all of space or does not, 0 if it may mirror parts of it. */
interface Orienting {
  orientation(offset: Vec3, normal: Vec3, position: Vec3): Scalar
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
  const normal = () => (turned ??= outwardNormal(inputs.glsl, position, surface))
  return Object.defineProperties({} as WarpInputs, {
    ...Object.getOwnPropertyDescriptors(inputs),
    position: { value: position, enumerable: true },
    normal: { get: normal, enumerable: true },
  })
}

/** The unit normal at `place`, on the outer side. If the orientation of the whole is unknown, that of its spaces counts. */
function outwardNormal(glsl: Glsl, place: Vec3, { position, normal, side }: Surface): Vec3 {
  const offset = place.sub(position)
  const turned = glsl.adjustNormal(offset, normal, position)
  if (side === undefined) return turned
  const known = (glsl as unknown as Orienting).orientation(offset, normal, position)
  return turned.mult(known.eq(0).ifElse(side, 1))
}
