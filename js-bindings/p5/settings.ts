/** Reads what a sketch hands to `createWarp` after the offset. */
import { WarpError, describe } from '../errors/errors.js'
import { checkOptions } from '../options/options.js'
import type { UniformOptions, UniformValues } from '../core/types/types.js'
import type { Shader } from './host.js'
import {
  type DeclaredUniforms,
  readDeclared,
  withSampling,
} from '../core/inputs/declared-uniforms.js'

/** Which of p5's materials the warp continues. */
export type WarpType = 'specular' | 'normal'

/**
 * The space that the offset lives in: `local` is the model's own, `world` has the model's transforms applied but not
 * the camera, and in `camera` the eye is the origin and looks along -z.
 */
export type WarpSpace = 'local' | 'world' | 'camera'

export interface CreateWarpOptions<Uniforms extends UniformValues = UniformValues> {
  /**
   * What the offset function reads as `uniforms`: a number, an array of 2 to 4, 9 or 16 numbers, a p5.Vector, a p5.Color, an image, or
   * a function that gives one of them each time that the warp is put on. Lists are copied.
   */
  uniforms?: UniformOptions<Uniforms>
  /** Left out: `specular`, p5's full material, or `normal` while the sketch uses `normalMaterial()`. */
  type?: WarpType
  /** Left out: `local`. */
  space?: WarpSpace
  /**
   * GLSL to put above the warp: the uniforms that the offset names by `glsl.param(…)`, helper functions. On a WEBGPU canvas functions are
   * WGSL, and uniforms are declared as in GLSL.
   */
  defs?: string
  /**
   * Normal and uv vary over a surface, and so turns the light of an offset that depends on them; `false`: they count as constant.
   */
  surfaceVariation?: boolean
  /**
   * Whether lines and points are warped too, those of `stroke()`, `line()` and `bezier()`: left out, if the sketch has
   * called `stroke()` and the offset reads neither normal, uv nor color, which lines lack; otherwise they are turned off.
   */
  stroke?: boolean
  /**
   * What the offset function returns: `'offset'`, left out, is how far the vertex is moved; `'position'` is where it goes, as in
   * `({ glsl, position }) => glsl.rotateY(1).mult(position)`.
   */
  returns?: 'offset' | 'position'
  /**
   * A shader that the sketch made by `modify` or `buildMaterialShader`, for the warp to be put on: its hooks are kept. Uniforms that
   * are set of it reach the warp.
   */
  shader?: object
  /**
   * When hooks of the option `shader` run that change vertices in the space of the warp: `'first'`, left out, before the warp, which
   * then moves what they made; or `'last'`, of what the warp made.
   */
  hooks?: 'first' | 'last'
  /** With 'warpjet/operators': variables of the sketch that the offset function reads, by name, as in `{ scope: { amount } }`. */
  scope?: Readonly<Record<string, unknown>>
}

export interface WarpSettings {
  readonly uniforms: DeclaredUniforms
  /** What the shader calls them: numbered, so that any name will do, also one that GLSL or p5 has. */
  readonly labels: ReadonlyMap<string, string>
  readonly type: WarpType | undefined
  readonly space: WarpSpace
  readonly defs: string
  readonly surfaceVariation: boolean | undefined
  readonly stroke: boolean | undefined
  readonly returns: 'offset' | 'position'
  readonly shader: Shader | undefined
  readonly hooks: 'first' | 'last'
  readonly scope: Readonly<Record<string, unknown>> | undefined
}

const types = ['specular', 'normal']
const spaces = ['local', 'world', 'camera']

export function readOptions(options: CreateWarpOptions = {}): WarpSettings {
  checkOptions('createWarp', options, [
    'uniforms',
    'type',
    'space',
    'defs',
    'surfaceVariation',
    'stroke',
    'returns',
    'shader',
    'hooks',
    'scope',
  ])
  const {
    type,
    space = 'local',
    defs = '',
    surfaceVariation,
    stroke,
    returns = 'offset',
    shader,
    hooks = 'first',
    scope,
  } = options
  if (stroke !== undefined && typeof stroke !== 'boolean')
    throw new WarpError(
      `createWarp: the option "stroke" must be true or false, but is ${describe(stroke)}.`,
    )
  if (type !== undefined) mustBeOneOf('type', types, type)
  mustBeOneOf('space', spaces, space)
  if (scope !== undefined && (typeof scope !== 'object' || scope === null || Array.isArray(scope)))
    throw new WarpError(
      `createWarp: the option "scope" must be an object of variables by name, as in { scope: { amount } }, but is ${describe(scope)}.`,
    )
  mustBeOneOf('returns', ['offset', 'position'], returns)
  mustBeOneOf('hooks', ['first', 'last'], hooks)
  if (shader !== undefined && type !== undefined)
    throw new WarpError(
      'createWarp: the options "type" and "shader" both say what to draw with; leave one of them out.',
    )
  if (typeof defs !== 'string')
    throw new WarpError(
      `createWarp: the option "defs" must be a text of GLSL such as "uniform float size;", but is ${describe(defs)}.`,
    )
  const uniforms = withSampling(readDeclared('createWarp', options.uniforms), {
    hasTransform: false,
  })
  const labels = new Map([...uniforms.keys()].map((name, i) => [name, `uWarpjet${i}`]))
  const defined = uniformsIn(defs)
  for (const name of uniforms.keys())
    if (defined.has(name))
      throw new WarpError(
        `createWarp: the uniform "${name}" stands in the options "uniforms" and "defs"; leave it out of one of them.`,
      )
  return {
    uniforms,
    labels,
    type,
    space,
    defs,
    surfaceVariation,
    stroke,
    returns,
    shader: shader as Shader | undefined,
    hooks,
    scope,
  }
}

/** The words of GLSL such as `uniform float size, amount;`, names of uniforms among them. */
export const uniformsIn = (defs: string) =>
  new Set((defs.match(/\buniform\b[^;]*/g) ?? []).flatMap((text) => text.match(/\w+/g)!))

function mustBeOneOf(option: string, choices: string[], value: unknown) {
  if (choices.includes(value as string)) return
  const list = choices.map((choice) => `"${choice}"`).join(' or ')
  throw new WarpError(
    `createWarp: the option "${option}" must be ${list}, but is ${describe(value)}.`,
  )
}
