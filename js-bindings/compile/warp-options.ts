// The options of `compileWarp`: types, schema and defaults.
import type { Expression } from '../core/expression/expression.js'
import { inputSizes, variationInputs, type InputName } from '../core/inputs/inputs.js'
import type { CompileOptions } from '../core/module/result.js'
import { targetKind, targets, type Target } from '../core/module/serialized-module.js'
import type { UniformOptions, UniformValues } from '../core/types/types.js'
import { anything, boolean, kind, optional, text } from '../options/kinds.js'
import type { Place } from '../options/place.js'
import { object, type KindsOf } from '../options/schema.js'
import type { NormalsOption } from './normals-option.js'
import { shaderNames } from './shader-names.js'

/** Maps an input → the host shader's expression for it. Default: the input's own name. */
export type InputNames = Partial<Record<InputName, string>>

/** The names of the results. */
export interface OutputNames {
  /** @default 'warpedPosition' */
  position?: string
  /** @default 'warpedNormal' */
  normal?: string
  /** @default 'warpedTangent' */
  tangent?: string
  /** @default 'offset' */
  offset?: string
}

export interface WarpOptions<
  Uniforms extends UniformValues = UniformValues,
> extends CompileOptions {
  /** The values that the offset function reads as `uniforms`. Your shader declares and sets uniforms of the same names; on the
   * CPU these values apply unless a call passes others. */
  uniforms?: UniformOptions<Uniforms>
  /** Your shader's names for the inputs, as in `{ position: 'aPosition' }`. Default: their own names. */
  names?: InputNames
  /** Names for the results, as in `{ position: 'moved' }`. */
  outputs?: OutputNames
  /**
   * The stage that computes normals. `true` or `'vertex'`: in `code`. `'pixel'`: only in the code of `emitFragment`, for you to insert in the
   * fragment shader. `'auto'`: in one of the two, depending on the warp; `normals` of the result says which. `false` leaves normals out.
   * @default true
   */
  normals?: boolean | NormalsOption
  /**
   * If true, noise in the code of `emitFragment` fades where its waves cover less than four pixels. If false, it keeps its full strength
   * there, and noise that is finer than a pixel sparkles. In GLSL ES 1.00 it always keeps its full strength.
   * @default true
   */
  fadeNoise?: boolean
  /** If true, the tangent, a vec4 as in glTF, is transformed, too. */
  tangents?: boolean
  /**
   * If true, the shader must have the attributes `normalXGradient`, `normalYGradient`, `normalZGradient`, `uGradient` and
   * `vGradient`, vec3s that say how normal and uv vary over the surface, as `surfaceVariation` of 'warpjet/mesh' computes
   * them; the code reads only those that the normal of this offset needs. Otherwise normal and uv are treated as constant; `false`
   * silences the warning about that.
   */
  surfaceVariation?: boolean
  /**
   * If true, everything that is constant during a frame is computed on the CPU, in double precision, by `frameUniforms`, and the
   * code reads it from uniforms `warpjetFrame0`, …, so that float32 stays precise even if a page runs for weeks.
   */
  perFrame?: boolean
  /** If true, comments say which lines of your code each statement comes from. */
  debug?: boolean
}

/** Names that replace those of the options in one piece of shader code. */
export interface TextOptions {
  names?: InputNames | undefined
  outputs?: OutputNames | undefined
}

/** The options that determine what is recorded and written. */
export interface RecordOptions extends TextOptions {
  target?: Target | undefined
  /** `false` leaves the normal out of the recording; all other values record the normal. */
  normals?: boolean | NormalsOption | undefined
  fadeNoise?: boolean | undefined
  tangents?: boolean | undefined
  surfaceVariation?: boolean | undefined
  debug?: boolean | undefined
  /** If true, the Jacobian of the offset is recorded, too. */
  jacobian?: boolean | undefined
  /** Returns further expressions, which the offset function has made when it was called. They become the results `other0`, `other1` … */
  others?: (() => readonly Expression[]) | undefined
}

const variableName = optional(text('the name of a shader variable'))
const inputKinds = Object.fromEntries(
  Object.keys(inputSizes).map((name) => [name, variableName]),
) as Record<InputName, typeof variableName>

const textKinds = {
  names: object(inputKinds),
  outputs: object({
    position: variableName,
    normal: variableName,
    tangent: variableName,
    offset: variableName,
  } satisfies KindsOf<OutputNames>),
} satisfies KindsOf<TextOptions>

/** The options of `emit`. */
export const textOptions = object(textKinds)

const warpOptions = object({
  uniforms: anything<UniformOptions<UniformValues>>(),
  target: targetKind,
  ...textKinds,
  normals: kind<boolean | NormalsOption>(
    "true, false, 'vertex', 'pixel' or 'auto'",
    (given) => [true, false, 'vertex', 'pixel', 'auto'].includes(given as boolean),
    { default: true },
  ),
  fadeNoise: boolean(true),
  tangents: boolean(false),
  surfaceVariation: optional(boolean()),
  perFrame: boolean(false),
  debug: boolean(false),
} satisfies KindsOf<WarpOptions>)

/** Reads the options of `compileWarp`. */
export function readWarpOptions(given: unknown, place: Place) {
  const options = warpOptions.read(given, place)
  if (options.tangents && !options.normals)
    throw place.error('tangents are transformed with the normal; remove "normals: false".')
  return options
}

/** The options with defaults filled in. */
export type Settings = ReturnType<typeof settingsOf>

export function settingsOf(place: Place, options: RecordOptions, defaults = publicOutputs) {
  const { target = targets[0]!, debug = false, jacobian = false, fadeNoise = true } = options
  const { tangents = false, surfaceVariation = false } = options
  const normals = options.normals !== false
  const isAccepted = options.surfaceVariation === false
  const results = { normals, tangents, surfaceVariation }
  const { others = () => [] } = options
  const names = namesOf(results, options.names)
  const outputs: Record<keyof typeof shaderNames | keyof OutputNames, string> = {
    ...shaderNames,
    ...defaults,
    ...withoutUndefined(options.outputs),
  }
  const recorded = { jacobian, others, ...results }
  return { place, target, debug, fadeNoise, ...recorded, isAccepted, names, outputs }
}

/** The names of results in shader code that is written for users. */
const publicOutputs: Record<keyof OutputNames, string> = {
  offset: 'offset',
  position: 'warpedPosition',
  normal: 'warpedNormal',
  tangent: 'warpedTangent',
}

type ResultFlags = Record<'normals' | 'tangents' | 'surfaceVariation', boolean>

function namesOf({ tangents, surfaceVariation }: ResultFlags, given: InputNames | undefined) {
  const names: Record<string, string> = {}
  for (const name of Object.keys(inputSizes)) {
    const isLeftOut = name === 'tangent' ? !tangents : name in variationInputs && !surfaceVariation
    names[name] = isLeftOut ? hiddenName(name) : (given?.[name as InputName] ?? name)
  }
  return names
}

/** Returns the name of an input that the shader code does not read, although the CPU may. User code never has such a name. */
const hiddenName = (name: string) => `_warpjet_${name}`

/** Removes options that are `undefined`. */
export const withoutUndefined = <Options extends object>(options?: Options) =>
  Object.fromEntries(
    Object.entries(options ?? {}).filter(([, value]) => value !== undefined),
  ) as Options
