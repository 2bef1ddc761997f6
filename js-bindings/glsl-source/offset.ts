// `glslOffset`: a function of shader text as an offset function.
import { asOwn } from '../errors/operators.js'
import { WarpError, describe } from '../errors/errors.js'
import { nearest } from '../errors/nearest.js'
import { checkOptions } from '../options/options.js'
import type { Builder } from '../core/expression/builder.js'
import type { UniformValues, Vec3, WarpInputs } from '../core/types/types.js'
import { bindExternals, inputNamed, inputTypes } from './bind.js'
import { type FunctionHead, withSource } from './listing.js'
import { type GlslOptions, article, checkSource, readIterations, readName } from './options.js'
import { pack, replay } from './replay.js'

export interface GlslOffsetOptions extends GlslOptions {
  /** What the function gives: how far a vertex moves, or where it moves to. `'offset'` unless given. */
  returns?: 'offset' | 'position'
}

/** An offset function that any host takes: what the text reads beside the position, it finds by itself. */
export type GlslOffset<Uniforms extends UniformValues = {}> = (
  inputs: Pick<WarpInputs<Uniforms>, 'glsl' | 'position' | 'uniforms'>,
) => Vec3

/**
 * An offset function from a text in GLSL ES 3.00 or 1.00, for whatever takes one: `createWarp`, `compileWarp`, `chain`.
 * The text is read here, once. Parameters of its function are inputs by name (`position`, `normal`, `uv`, `color`,
 * `millis`, `mouse`, `size` …); a single vec3 is the position, whatever its name. Uniforms of the text are those of the
 * option `uniforms`, or else of your shader.
 *
 * Throws a `WarpError` with the line and column of what is wrong in the text.
 */
export function glslOffset<Uniforms extends UniformValues = {}>(
  source: string,
  options: GlslOffsetOptions = {},
): GlslOffset<Uniforms> {
  checkSource('glslOffset', source)
  checkOptions('glslOffset', options, ['function', 'maxIterations', 'returns'])
  const { returns = 'offset' } = options
  if (returns !== 'offset' && returns !== 'position')
    throw new WarpError(
      `glslOffset: the option "returns" must be 'offset' or 'position', but is ${describe(returns)}.`,
    )
  const listing = withSource('glslOffset', source, (text) => {
    const head = text.find(readName('glslOffset', options.function))
    checkHead(head)
    return text.list(head, readIterations('glslOffset', options.maxIterations))
  })
  const { head } = listing
  return asOwn((inputs) => {
    const given = inputs as unknown as WarpInputs
    const glsl = inputs.glsl as unknown as Builder
    const operands = head.parameters.map(({ name }) =>
      inputNamed(given, isInput(name) ? name : 'position')!,
    )
    const externals = bindExternals('glslOffset', glsl, listing.externals, given)
    const numbers = replay(glsl, listing, { arguments: operands, ...externals })
    const result = pack(glsl, head.type, numbers) as unknown as WarpInputs['position']
    return returns === 'position' ? result.sub(inputs.position) : result
  })
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
      : `there are ${known.join(', ')}, and uniforms of the text`
  return `glslOffset: nothing gives the parameter ${parameter} of ${name} its value; ${advice}.`
}

function checkHead({ name, type, parameters }: FunctionHead) {
  if (type !== 'vec3')
    throw new WarpError(
      `glslOffset: ${name} must give a vec3, how far a vertex moves, but gives ${type === 'void' ? 'nothing' : article(type)}; ${
        type === 'void' ? 'return it' : 'differentiate takes other functions'
      }, or name another one by the option "function".`,
    )
  for (const parameter of parameters) {
    if (parameter.isOut)
      throw new WarpError(
        `glslOffset: the parameter ${parameter.name} of ${name} is out or inout; an offset function gives its vec3 back.`,
      )
    if (parameters.length === 1 && parameter.type === 'vec3' && !isInput(parameter.name)) continue
    const expected = inputTypes[parameter.name]
    if (!expected) throw new WarpError(unknownParameter(name, parameter.name, parameter.type))
    if (expected !== parameter.type)
      throw new WarpError(
        `glslOffset: the parameter ${parameter.name} of ${name} is ${article(parameter.type)}, but ${parameter.name} is ${article(expected)}.`,
      )
  }
}
