// The options of `warp` and `warpMaterial`, checked.
import type { UniformExpressions, Vec3, WarpInputs } from '../compile/hosts.js'
import { anything, boolean, kind, oneOf, optional } from '../options/kinds.js'
import { Place } from '../options/place.js'
import { type KindsOf, object } from '../options/schema.js'
import type { PlainOf, ThreeUniforms } from './uniforms.js'

/**
 * What `position` is measured in. `'local'`: the units of the geometry, after morph targets and bones, before the matrix of
 * an instance and that of the object. `'rest'`: likewise, before morph targets and bones. `'world'`: the scene's units,
 * when all of these are done.
 */
export type WarpSpace = 'local' | 'rest' | 'world'

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
  uniforms: object | undefined
  isShared: boolean
  surfaceVariation: false | undefined
}

const options = object({
  space: oneOf(['local', 'rest', 'world'], 'local'),
  uniforms: anything<object>(),
  share: boolean(false),
  surfaceVariation: optional(
    kind<false>('only false', (given) => given === false, {
      advice: () => 'addSurfaceVariation(geometry) says how a geometry varies',
    }),
  ),
} satisfies KindsOf<WarpOptions<object>>)

export function readOptions(method: string, given?: WarpOptions<object>): Settings {
  const { uniforms, share, ...others } = options.read(given, new Place(method))
  return { method, ...others, uniforms: uniforms as never, isShared: share }
}
