// `glslOffset` and `wgslOffset`: make an offset function from source.
import type { Builder } from '../core/expression/builder.js'
import type { Expression } from '../core/expression/expression.js'
import type { UniformValues, Vec3, WarpInputs } from '../core/types/types.js'
import { nearest } from '../errors/nearest.js'
import { asOwn } from '../errors/operators.js'
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
 * is parsed once. Its function's parameters are matched to inputs by name (`position`, `normal`, `uv`, `color`, `millis`, `mouse`,
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
 * Makes an offset function from source in WGSL, like `glslOffset` from GLSL. A uniform is an input by its name in the shader, such
 * as `time` of `var<uniform> time: f32` or `scene.time` of a structure; so is an element of a storage buffer, by a constant
 * index or the counter of a loop with constant bounds.
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
): GlslOffset<Uniforms> => readOffset<Uniforms>(place, language, source, options).offset

/** Returns the offset function of a source, and the uniforms and attributes that the source has. */
export function readOffset<Uniforms extends UniformValues>(
  place: Place,
  language: SourceLanguage,
  source: string,
  options: GlslOffsetOptions | undefined,
): { offset: GlslOffset<Uniforms>; externals: readonly External[] } {
  const { returns } = offsetOptions.read(options, place)
  const { numbersFor, externals } = readNumbers(place, language, source, options, 'vec3')
  const offset: GlslOffset<Uniforms> = asOwn((inputs) => {
    const result = vectorOf(inputs, numbersFor(inputs as unknown as WarpInputs))
    return returns === 'position' ? result.sub(inputs.position) : result
  })
  return { offset, externals }
}

/** Like `readOffset` of a source whose function returns a mat4: the new position in the first three numbers, `others` behind them. */
export function readPositionWithOthers(
  language: SourceLanguage,
  source: string,
  options: GlslOptions,
): (inputs: WarpInputs) => { offset: Vec3; others: readonly Expression[] } {
  const place = new Place(`${language}Offset`)
  const { numbersFor } = readNumbers(place, language, source, options, 'mat4')
  return (inputs) => {
    const numbers = numbersFor(inputs)
    return {
      offset: vectorOf(inputs, numbers.slice(0, 3)).sub(inputs.position),
      others: numbers.slice(3),
    }
  }
}

const vectorOf = ({ glsl }: Pick<WarpInputs, 'glsl'>, numbers: readonly Expression[]) =>
  pack(glsl as unknown as Builder, 'vec3', numbers) as unknown as WarpInputs['position']

/** Reads a source whose function returns `type` → a function from inputs to the numbers of the result. */
function readNumbers(
  place: Place,
  language: SourceLanguage,
  source: string,
  options: GlslOffsetOptions | undefined,
  type: 'vec3' | 'mat4',
) {
  const text = sourceKinds[language].read(source, place.part('the source'))
  const { function: name, maxIterations } = offsetOptions.read(options, place)
  const listing = withSource(place, { text, language }, (open) => {
    const head = open.find(name)
    rejectOtherHead(place, language, head, type)
    return open.list(head, maxIterations)
  })
  const numbersFor = (given: WarpInputs): Expression[] => {
    const glsl = given.glsl as unknown as Builder
    const operands = listing.head.parameters.map(({ name }) =>
      inputNamed(given, isInput(name) ? name : 'position')!,
    )
    const externals = bindExternals(place, glsl, listing.externals, given)
    return replay(glsl, listing, { arguments: operands, ...externals })
  }
  return { numbersFor, externals: listing.externals }
}

const isInput = (name: string) => name in inputTypes

function unknownParameter(name: string, parameter: string, type: string) {
  const known = Object.keys(inputTypes)
  const meant: Record<string, string> = {
    time: 'millis',
    t: 'millis',
    pos: 'position',
    p: 'position',
  }
  const near = meant[parameter] ?? nearest(parameter, known)
  const advice =
    near && inputTypes[near] === type
      ? `call it ${near}`
      : `it can be ${known.join(', ')}, or a uniform of the source`
  return `the parameter ${parameter} of ${name} has no value; ${advice}.`
}

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
        `the parameter ${parameter.name} of ${name} is ${language === 'wgsl' ? 'a pointer' : 'out or inout'}; an offset function must return its ${language === 'wgsl' ? 'vec3f' : 'vec3'}.`,
      )
    if (parameters.length === 1 && parameter.type === 'vec3' && !isInput(parameter.name)) continue
    const expected = inputTypes[parameter.name]
    if (!expected) throw place.error(unknownParameter(name, parameter.name, parameter.type))
    if (expected !== parameter.type)
      throw place.error(
        `the parameter ${parameter.name} of ${name}: expected ${article(expected)}, the type of the input ${parameter.name}, got ${article(parameter.type)}.`,
      )
  }
}
