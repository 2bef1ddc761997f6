// The options of `compileWarp`: their types, checks and defaults.
import { inputSizes, type InputName, variationInputs } from '../core/inputs/inputs.js'
import { type Target, checkTarget } from '../core/module/kept-module.js'
import type { CompileOptions } from '../core/module/result.js'
import type { UniformOptions, UniformValues } from '../core/types/types.js'
import { WarpError, describe } from '../errors/errors.js'
import { checkCallback, checkOptions } from '../options/options.js'
import { shaderNames } from './shader-names.js'

/** The host shader's expression for each input; its name unless given. */
export type InputNames = Partial<Record<InputName, string>>

/** The names of the results: `warpedPosition`, `warpedNormal`, `warpedTangent` and `offset` unless given. */
export interface OutputNames {
  position?: string
  normal?: string
  tangent?: string
  offset?: string
}

export interface WarpOptions<
  Uniforms extends UniformValues = UniformValues,
> extends CompileOptions {
  /** What the offset function reads as `uniforms`, with the values that count on the CPU unless others are given; your
   * shader declares and sets them, under the same names. */
  uniforms?: UniformOptions<Uniforms>
  /** What your shader calls the inputs, as in `{ position: 'aPosition' }`; each by its own name unless given. */
  names?: InputNames
  /** What the text calls the results, as in `{ position: 'moved' }`. */
  outputs?: OutputNames
  /** `false` leaves the normal out. */
  normals?: boolean
  /** `true` also turns the tangent, a vec4 as in glTF. */
  tangents?: boolean
  /**
   * `true`: the shader has the attributes `normalXGradient`, `normalYGradient`, `normalZGradient`, `uGradient` and
   * `vGradient`, vec3s that say how normal and uv vary over the surface, as `surfaceVariation` of 'warpjet/mesh' computes
   * them; the text reads those that the offset makes it need. Otherwise normal and uv count as constant; `false` says that this will do.
   */
  surfaceVariation?: boolean
  /**
   * `true`: what is the same for a whole frame is computed on the CPU, in double, by `frameUniforms`, and the text reads it as
   * uniforms `warpjetFrame0`, …: then float32 keeps its digits however long a page runs.
   */
  perFrame?: boolean
  /** `true`: comments say which lines of the sketch each statement comes from. */
  debug?: boolean
}

/** Names that a text uses in place of those of the options. */
export interface TextOptions {
  names?: InputNames | undefined
  outputs?: OutputNames | undefined
}

/** The options that decide what is recorded and written. */
export interface RecordOptions extends TextOptions {
  target?: Target | undefined
  normals?: boolean | undefined
  tangents?: boolean | undefined
  surfaceVariation?: boolean | undefined
  debug?: boolean | undefined
  /** `true` also records the Jacobian of the offset. */
  jacobian?: boolean | undefined
}

/** The options with their defaults. */
export type Settings = ReturnType<typeof settingsOf>

export function settingsOf(method: string, options: RecordOptions, defaults = publicOutputs) {
  const { normals = true, tangents = false, surfaceVariation = false } = options
  const { debug = false, jacobian = false } = options
  const isAccepted = options.surfaceVariation === false
  const target = checkTarget(options.target)
  const shown = { normals, tangents, surfaceVariation }
  const names = namesOf(shown, options.names)
  const outputs: Record<keyof typeof shaderNames | keyof OutputNames, string> = {
    ...shaderNames,
    ...defaults,
    ...withoutGaps(options.outputs),
  }
  return { method, target, debug, jacobian, ...shown, isAccepted, names, outputs }
}

/** Names of results where the user reads them. */
const publicOutputs: Record<keyof OutputNames, string> = {
  offset: 'offset',
  position: 'warpedPosition',
  normal: 'warpedNormal',
  tangent: 'warpedTangent',
}

/** Throws a `WarpError` for options of `compileWarp` that are none, or wrong. */
export function checkWarpOptions(
  method: string,
  offset: unknown,
  options: Omit<WarpOptions, 'uniforms'>,
) {
  checkCallback(method, offset)
  checkOptions(method, options, [
    'uniforms',
    'target',
    'names',
    'outputs',
    'normals',
    'tangents',
    'surfaceVariation',
    'perFrame',
    'debug',
  ])
  checkNames(method, options)
  const { normals = true, tangents = false, surfaceVariation = false } = options
  const { perFrame = false, debug = false } = options
  const choices = { normals, tangents, surfaceVariation, perFrame, debug }
  for (const [name, value] of Object.entries(choices))
    if (typeof value !== 'boolean')
      throw new WarpError(
        `${method}: the option "${name}" must be true or false, but is ${describe(value)}.`,
      )
  if (tangents && !normals)
    throw new WarpError(
      `${method}: tangents are turned with the normal; leave "normals: false" out.`,
    )
}

type Shown = Record<'normals' | 'tangents' | 'surfaceVariation', boolean>

function namesOf({ tangents, surfaceVariation }: Shown, given: InputNames | undefined) {
  const names: Record<string, string> = {}
  for (const name of Object.keys(inputSizes)) {
    const isLeftOut = name === 'tangent' ? !tangents : name in variationInputs && !surfaceVariation
    names[name] = isLeftOut ? hidden(name) : (given?.[name as InputName] ?? name)
  }
  return names
}

export function checkNames(method: string, { names, outputs }: TextOptions) {
  checkOptions(`${method} names`, names, Object.keys(inputSizes))
  checkOptions(`${method} outputs`, outputs, ['position', 'normal', 'tangent', 'offset'])
}

/** The name of an input that the text does not read, though the CPU may. User code has no such name. */
const hidden = (name: string) => `_warpjet_${name}`

export const withoutGaps = <Options extends object>(options?: Options) =>
  Object.fromEntries(
    Object.entries(options ?? {}).filter(([, value]) => value !== undefined),
  ) as Options
