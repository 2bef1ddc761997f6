// The options of `warp` and `warpMaterial`, checked.
import { WarpError, describe } from '../errors/errors.js'
import { checkOptions } from '../options/options.js'
import type { UniformExpressions, UniformValue, WarpInputs } from '../core/types/types.js'
import type { Vec3 } from '../core/types/expressions.js'
import type { PlainOf, ThreeUniforms } from './uniforms.js'

/**
 * What `position` is measured in. `'local'`: the units of the geometry, after morph targets and bones, before the matrix of
 * an instance and that of the object. `'rest'`: likewise, before morph targets and bones. `'world'`: the scene's units,
 * when all of these are done.
 */
export type WarpSpace = 'local' | 'rest' | 'world'

const spaces: readonly WarpSpace[] = ['local', 'rest', 'world']

export interface WarpOptions<Uniforms extends object = ThreeUniforms> {
  /** `'local'` unless given. */
  space?: WarpSpace
  /** What the offset function reads as `uniforms`: a number, a list of numbers, a vector, colour, matrix or texture of
   * three.js, or a function that gives one of them and is asked for each frame. */
  uniforms?: Uniforms
  /** `true`: the material itself is warped, on every mesh that has it, and not a clone of it. */
  share?: boolean
  /** `false`: normal and uv may count as constant over the surface, and nothing is said if they do. */
  surfaceVariation?: false
}

/** What only p5 has. */
type OfP5 =
  'mouse' | 'mouseX' | 'mouseY' | 'size' | 'width' | 'height' | 'pixelDensity' | 'instance'

/** From a vertex to the offset that moves it; the mouse, the canvas and `instance` are p5's and not there. */
export type ThreeOffset<Values = {}> = (
  inputs: Omit<WarpInputs, 'uniforms' | OfP5> & {
    uniforms: UniformExpressions<PlainOf<Values>>
  },
) => Vec3

export interface Settings {
  method: string
  space: WarpSpace
  uniforms: Readonly<Record<string, UniformValue>> | undefined
  isShared: boolean
  surfaceVariation: false | undefined
}

export function readOptions(method: string, options: WarpOptions<object> = {}): Settings {
  checkOptions(method, options, ['space', 'uniforms', 'share', 'surfaceVariation'])
  const { space = 'local', uniforms, share = false, surfaceVariation } = options
  if (!spaces.includes(space))
    throw new WarpError(
      `${method}: the option "space" must be 'local', 'rest' or 'world', but is ${describe(space)}.`,
    )
  if (typeof share !== 'boolean')
    throw new WarpError(
      `${method}: the option "share" must be true or false, but is ${describe(share)}.`,
    )
  if (surfaceVariation !== undefined && surfaceVariation !== false)
    throw new WarpError(
      `${method}: the option "surfaceVariation" can only be false, but is ${describe(surfaceVariation)}; addSurfaceVariation(geometry) says how a geometry varies.`,
    )
  return { method, space, uniforms: uniforms as never, isShared: share, surfaceVariation }
}
