// `glslOffset` and `wgslOffset`: make an offset function from source.
import type { Builder } from '../core/expression/builder.js'
import type { Expression } from '../core/expression/expression.js'
import type { UniformValues, Vec3, WarpInputs } from '../core/types/types.js'
import { nearest } from '../errors/nearest.js'
import { markLibraryFunction } from '../errors/operators.js'
import { oneOf } from '../options/kinds.js'
import { Place } from '../options/place.js'
import { object, type KindsOf } from '../options/schema.js'
import { bindExternals, inputNamed, inputTypes } from './bind.js'
import { withSource, type External, type FunctionHead } from './listing.js'
import {
  articleIn,
  glslKinds,
  sourceKinds,
  type GlslOptions,
  type SourceLanguage,
} from './options.js'
import { pack, replay } from './replay.js'

export interface GlslOffsetOptions extends GlslOptions {
  /**
   * Meaning of the function's result: `'offset'` is added to the position, `'position'` is the new position.
   * @default 'offset'
   */
  returns?: 'offset' | 'position'
}

/** An offset function for any host. Its argument must also have the other inputs that the source uses. */
export type GlslOffset<Uniforms extends UniformValues = {}> = (
  inputs: Pick<WarpInputs<Uniforms>, 'glsl' | 'position' | 'uniforms'>,
) => Vec3

export type WgslOffsetOptions = GlslOffsetOptions
export type WgslOffset<Uniforms extends UniformValues = {}> = GlslOffset<Uniforms>

const offsetOptions = object({
  ...glslKinds,
  returns: oneOf(['offset', 'position'], 'offset'),
} satisfies KindsOf<GlslOffsetOptions>)

/**
 * Makes an offset function from source in GLSL ES 3.00 or 1.00, for `createWarp`, `compileWarp`, `chain` and so on. The source
 * is parsed once. The parameters of its function are matched to inputs by name (`position`, `normal`, `uv`, `color`, `millis`, `mouse`,
 * `size` …); a single vec3 parameter is the position, whatever its name. Uniforms of the source are those of the option
 * `uniforms`, or else uniforms of your shader.
 *
 * Throws a `WarpError` with the line and column of a mistake in the source.
 */
export function glslOffset<Uniforms extends UniformValues = {}>(
  source: string,
  options?: GlslOffsetOptions,
): GlslOffset<Uniforms> {
  return offsetOf(new Place('glslOffset'), 'glsl', source, options)
}

/**
 * Makes an offset function from source in WGSL, like `glslOffset` from GLSL. Uniforms are matched by their name in the shader, such
 * as `time` of `var<uniform> time: f32` or `scene.time` of a structure; so are elements of a storage buffer, whose index must be
 * constant or the counter of a loop with constant bounds.
 * Attributes, entry points and functions for fragments may stay in the source; they are ignored unless the function uses them.
 *
 * Throws a `WarpError` with the line and column of a mistake in the source.
 */
export function wgslOffset<Uniforms extends UniformValues = {}>(
  source: string,
  options?: WgslOffsetOptions,
): WgslOffset<Uniforms> {
  return offsetOf(new Place('wgslOffset'), 'wgsl', source, options)
}

const offsetOf = <Uniforms extends UniformValues>(
  place: Place,
  language: SourceLanguage,
  source: string,
  options: GlslOffsetOptions | undefined,
): GlslOffset<Uniforms> =>
  readOffset<Uniforms>(place, language, source, offsetOptions.read(options, place)).offset

/** Valid options; `maxIterations` may be `untilEnd`. */
interface LoweringOptions {
  function: string | undefined
  maxIterations: number
}

interface OffsetLoweringOptions extends LoweringOptions {
  returns: 'offset' | 'position'
}

/**
 * Returns the offset function of a source, and the uniforms and attributes of this source. `cutOff` is the message about a loop that is
 * cut off before its end; empty if there is none.
 */
export function readOffset<Uniforms extends UniformValues>(
  place: Place,
  language: SourceLanguage,
  source: string,
  { returns, ...options }: OffsetLoweringOptions,
): { offset: GlslOffset<Uniforms>; externals: readonly External[]; cutOff: string } {
  const { numbersFor, externals, cutOff } = readNumbers(place, language, source, options, 'vec3')
  const offset: GlslOffset<Uniforms> = markLibraryFunction((inputs) => {
    const result = vectorOf(inputs, numbersFor(inputs as unknown as WarpInputs))
    return returns === 'position' ? result.sub(inputs.position) : result
  })
  return { offset, externals, cutOff }
}

/**
 * Reads a source whose function returns a mat4, with the new position in its first three numbers. `read` computes the offset and
 * `others`, the remaining 13 numbers; `cutOff` is as for `readOffset`.
 */
export function readPositionWithOthers(
  place: Place,
  language: SourceLanguage,
  source: string,
  options: LoweringOptions,
): {
  read: (inputs: WarpInputs) => { offset: Vec3; others: readonly Expression[] }
  cutOff: string
} {
  const { numbersFor, cutOff } = readNumbers(place, language, source, options, 'mat4')
  const read = (inputs: WarpInputs) => {
    const numbers = numbersFor(inputs)
    return {
      offset: vectorOf(inputs, numbers.slice(0, 3)).sub(inputs.position),
      others: numbers.slice(3),
    }
  }
  return { read, cutOff }
}

const vectorOf = ({ glsl }: Pick<WarpInputs, 'glsl'>, numbers: readonly Expression[]) =>
  pack(glsl as unknown as Builder, 'vec3', numbers) as unknown as WarpInputs['position']

/** Reads a source whose function returns `type`. Returns `numbersFor`, which computes the numbers of the result for inputs. */
function readNumbers(
  place: Place,
  language: SourceLanguage,
  source: string,
  { function: name, maxIterations }: LoweringOptions,
  type: 'vec3' | 'mat4',
) {
  const text = sourceKinds[language].read(source, place.part('the source'))
  const listing = withSource(place, { text, language }, (openSource) => {
    const head = openSource.find(name)
    rejectOtherHead(place, language, head, type)
    return openSource.list(head, maxIterations)
  })
  const numbersFor = (inputs: WarpInputs): Expression[] => {
    const glsl = inputs.glsl as unknown as Builder
    const operands = listing.head.parameters.map(({ name }) =>
      inputNamed(inputs, isInput(name) ? name : 'position')!,
    )
    const externals = bindExternals(place, glsl, listing.externals, inputs)
    return replay(glsl, listing, { arguments: operands, ...externals })
  }
  return { numbersFor, externals: listing.externals, cutOff: listing.cutOff }
}

const isInput = (name: string) => name in inputTypes

/** Returns the message for a parameter that is no input. */
function unknownParameterMessage(name: string, parameter: string, type: string) {
  const inputNames = Object.keys(inputTypes)
  /** Maps common names of parameters → inputs. */
  const commonNames: Record<string, string> = {
    time: 'millis',
    t: 'millis',
    pos: 'position',
    p: 'position',
  }
  const suggestion = commonNames[parameter] ?? nearest(parameter, inputNames)
  const advice =
    suggestion && inputTypes[suggestion] === type
      ? `call it ${suggestion}`
      : `rename it to one of ${inputNames.join(', ')}, or make it a uniform of the source`
  return `the parameter ${parameter} of ${name} has no value; ${advice}.`
}

/** Throws unless the function returns a value of the expected type, and all its parameters are inputs. */
function rejectOtherHead(
  place: Place,
  language: SourceLanguage,
  { name, type, parameters }: FunctionHead,
  expected: string,
) {
  const article = (type: string) => articleIn(language, type)
  if (type !== expected)
    throw place.error(
      `${name}: expected a function that returns ${article('vec3')}, the offset of a vertex, got one that returns ${type === 'void' ? 'nothing' : article(type)}; ${
        type === 'void' ? 'return the offset' : 'differentiate accepts other functions'
      }, or name another function by the option "function".`,
    )
  for (const parameter of parameters) {
    if (parameter.isOut)
      throw place.error(
        `the parameter ${parameter.name} of ${name} is ${language === 'wgsl' ? 'a pointer' : 'an out or inout parameter'}; an offset function must return its ${language === 'wgsl' ? 'vec3f' : 'vec3'}.`,
      )
    if (parameters.length === 1 && parameter.type === 'vec3' && !isInput(parameter.name)) continue
    const inputType = inputTypes[parameter.name]
    if (!inputType) throw place.error(unknownParameterMessage(name, parameter.name, parameter.type))
    if (inputType !== parameter.type)
      throw place.error(
        `the parameter ${parameter.name} of ${name}: expected ${article(inputType)}, the type of the input ${parameter.name}, got ${article(parameter.type)}.`,
      )
  }
}
