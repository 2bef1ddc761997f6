/** Reads the options of `createWarp`. */
import {
  normalsKinds,
  type NormalStage,
  type NormalsOption,
  type UniformOptions,
  type UniformValues,
} from '../compile/hosts.js'
import { detailKind, type DetailOption, type DetailSettings } from '../detail/option.js'
import { anything, boolean, oneOf, optional, record, text } from '../options/kinds.js'
import { Place } from '../options/place.js'
import { object, type KindsOf } from '../options/schema.js'
import type { Shader } from './host.js'

/** The p5 material that the warp extends. */
export type WarpType = 'specular' | 'normal'

/**
 * The space of the offset: `local` is the model's own, `world` has the model's transforms applied but not the camera's, and in
 * `camera` the eye is the origin and looks along -z.
 */
export type WarpSpace = 'local' | 'world' | 'camera'

export interface CreateWarpOptions<Uniforms extends UniformValues = UniformValues> {
  /**
   * The `uniforms` of the offset function, each a number, an array of 2 to 4, 9 or 16 numbers, a p5.Vector, a p5.Color, an image, or a
   * function that returns one of these and is called each time the warp is applied. Lists are copied.
   */
  uniforms?: UniformOptions<Uniforms>
  /** Default: `specular`, which is p5's full material, or `normal` while the sketch uses `normalMaterial()`. */
  type?: WarpType
  /** @default 'local' */
  space?: WarpSpace
  /**
   * GLSL to insert above the warp: helper functions, and the uniforms that the offset reads by `glsl.param(…)`. On a WEBGPU canvas,
   * write functions in WGSL, but declare uniforms as in GLSL.
   */
  defs?: string
  /**
   * Where normals are computed: at `'vertex'` and interpolated between vertices, or exactly at each `'pixel'`. `'auto'` selects
   * `'pixel'` if the offset contains noise, or if interpolated normals would be off by more than 1° on a typical mesh (p5's default
   * sphere), unless the normal takes more than 4,000 operations.
   * @default 'auto'
   */
  normals?: NormalsOption
  /**
   * The maximum distance, in pixels of the canvas, between the drawn triangles and the warped surface: shapes are subdivided as finely as
   * their current size on the screen requires. `'auto'` is 1, or 2 on devices that are used by touch. `{ tolerance: 1, curved: true }`
   * also rounds coarse shapes. `false` disables the subdivision. Shapes between beginShape() and endShape(), instances, and shapes under a
   * warp that only the GPU can evaluate are never subdivided.
   * @default false
   */
  detail?: DetailOption
  /**
   * If true, noise fades where its waves cover fewer than four pixels. If false, it keeps its full strength there, and noise that is finer
   * than a pixel sparkles. Normals at vertices are unaffected.
   * @default true
   */
  fadeNoise?: boolean
  /**
   * If true, the normals of an offset that depends on normal or uv account for how these vary over the surface; if false, normal and uv
   * are treated as constant.
   * @default true
   */
  surfaceVariation?: boolean
  /**
   * If true, outlines of shapes, lines and points are warped, too. If false, they are not drawn. Default: true if the sketch has called
   * `stroke()` and the offset reads neither normal, uv nor color, which lines lack.
   */
  stroke?: boolean
  /**
   * Meaning of the offset function's result: `'offset'` is added to the position, `'position'` is the new position, as in
   * `({ glsl, position }) => glsl.rotateY(1).mult(position)`.
   * @default 'offset'
   */
  returns?: 'offset' | 'position'
  /**
   * A shader that the sketch created with `modify` or `buildMaterialShader`, to which the warp is added. The shader keeps its hooks.
   * Uniforms that are set in this shader also apply to the warp's copy of it.
   */
  shader?: object
  /**
   * Order of the warp and the hooks of the option `shader` that change vertices in the same space: with `'first'` the hooks run before
   * the warp, with `'last'` after it.
   * @default 'first'
   */
  hooks?: 'first' | 'last'
  /** With 'warpjet/operators': variables of the sketch that the offset function reads, by name, as in `{ scope: { amount } }`. */
  scope?: Readonly<Record<string, unknown>>
}

/** The options of `createWarp` with defaults filled in. */
export interface OptionsWithDefaults {
  /** The option `uniforms` as the sketch passed it. */
  readonly uniforms: object | undefined
  readonly type: WarpType | undefined
  readonly space: WarpSpace
  readonly defs: string
  readonly normals: NormalsOption
  readonly detail: DetailSettings | undefined
  readonly fadeNoise: boolean
  readonly surfaceVariation: boolean | undefined
  readonly stroke: boolean | undefined
  readonly returns: 'offset' | 'position'
  readonly shader: Shader | undefined
  readonly hooks: 'first' | 'last'
  readonly scope: Readonly<Record<string, unknown>> | undefined
}

export interface WarpSettings extends OptionsWithDefaults {
  /** The stage that computes normals: the option `normals`, with `'auto'` resolved for this warp. */
  readonly stage: NormalStage
}

const place = new Place('createWarp')
const createWarpOptions = object({
  uniforms: anything<UniformOptions<UniformValues>>(),
  type: optional(oneOf(['specular', 'normal'])),
  space: oneOf(['local', 'world', 'camera'], 'local'),
  defs: text('a string of GLSL such as "uniform float size;"', undefined, { default: '' }),
  ...normalsKinds,
  detail: detailKind,
  surfaceVariation: anything<boolean>(),
  stroke: optional(boolean()),
  returns: oneOf(['offset', 'position'], 'offset'),
  shader: anything<object>(),
  hooks: oneOf(['first', 'last'], 'first'),
  scope: optional(
    record<Readonly<Record<string, unknown>>>(
      'an object of variables by name, as in { scope: { amount } },',
    ),
  ),
} satisfies KindsOf<CreateWarpOptions>)

export function readOptions(options?: CreateWarpOptions): OptionsWithDefaults {
  const read = createWarpOptions.read(options, place)
  const { type, shader, defs } = read
  if (shader !== undefined && type !== undefined)
    throw place.error('the options "type" and "shader" exclude each other; leave one of them out.')
  const { uniforms } = read
  const inDefs = uniformsIn(defs)
  for (const name of Object.keys(uniforms ?? {}))
    if (inDefs.has(name))
      throw place.error(
        `the uniform "${name}" is in both options "uniforms" and "defs"; leave it out of one of them.`,
      )
  return { ...read, shader: shader as Shader | undefined }
}

/** Returns all words of the uniform declarations in GLSL such as `uniform float size, amount;`, which include the uniforms' names. */
export const uniformsIn = (defs: string) =>
  new Set((defs.match(/\buniform\b[^;]*/g) ?? []).flatMap((text) => text.match(/\w+/g)!))
