// `glsl.source`: makes a function of GLSL source callable with expressions.
import type { Builder } from '../core/expression/builder.js'
import type { Expression } from '../core/expression/expression.js'
import { isExpression } from '../errors/describe.js'
import { WarpError, describe, describeShape } from '../errors/errors.js'
import { frontEndKey } from '../errors/front-end.js'
import { record } from '../options/kinds.js'
import { Place } from '../options/place.js'
import { object, type KindsOf } from '../options/schema.js'
import { bindExternals } from './bind.js'
import { halvesOf, type GlslValue } from './halves.js'
import { withSource, type FunctionHead, type Named } from './listing.js'
import { article, glslKinds, sourceKinds, type GlslOptions } from './options.js'
import { pack, replay } from './replay.js'

export interface GlslSourceOptions extends GlslOptions {
  /** The values of the source's uniforms, such as the `uniforms` of an offset function. Other uniforms are read from the shader. */
  uniforms?: object
}

/** Calls the function of the source with numbers and expressions. */
export type SourceFunction = (...operands: unknown[]) => Expression

const place = new Place('source')
const sourceOptions = object({
  ...glslKinds,
  uniforms: record<object>('an object of numbers and expressions', { default: {} }),
} satisfies KindsOf<GlslSourceOptions>)

function functionOf(glsl: Builder, source: unknown, options?: GlslSourceOptions): SourceFunction {
  const text = sourceKinds.glsl.read(source, place.part('the source'))
  const { function: chosenName, maxIterations, uniforms } = sourceOptions.read(options, place)
  const listing = withSource(place, { text, language: 'glsl' }, (openSource) => {
    const head = openSource.find(chosenName)
    rejectUnsupportedTypes(head)
    return openSource.list(head, maxIterations)
  })
  const { head, externals } = listing
  const { name, parameters } = head
  const boundExternals = bindExternals(place, glsl, externals, { uniforms: uniforms as never })
  return (...operands) => {
    if (operands.length !== parameters.length)
      throw new WarpError(
        `${name}: expected ${parameters.length} arguments (${parameters.map((each) => each.type).join(', ')}), got ${operands.length}.`,
      )
    const values = operands.map((operand, i) =>
      toParameter(glsl, parameters[i]!, operand, new Place(name).argument(i + 1)),
    )
    const results = replay(glsl, listing, { arguments: values, ...boundExternals })
    return pack(glsl, head.type, results)
  }
}

/** Throws if the function has an out parameter, or a parameter or result of a type that no expression has. */
function rejectUnsupportedTypes({ name, type, parameters }: FunctionHead) {
  if (!/^(?:float|int|uint|bool|vec[234]|mat[234])$/.test(type))
    throw place.error(`${name} returns ${article(type)}, which no expression can be.`)
  for (const each of parameters) {
    if (each.isOut)
      throw place.error(
        `the parameter ${each.name} of ${name} is an out parameter; return a value instead.`,
      )
    if (!/^(?:float|int|uint|bool|vec[234]|mat[234])$/.test(each.type))
      throw place.error(
        `the parameter ${each.name} of ${name} is ${article(each.type)}, which no expression can be.`,
      )
  }
}

/** Converts an operand to a value of a parameter's type. */
function toParameter(glsl: Builder, { type }: Named, operand: unknown, place: Place): GlslValue {
  if (typeof operand === 'number' && /^u?int$/.test(type)) return halvesOf(glsl, operand)
  const value = typeof operand === 'number' ? glsl.val!(operand) : operand
  if (!isExpression(value)) throw place.expected(article(type), describe(operand))
  const expression = value as Expression
  const shape = expression.session.shapeOf(expression)
  const [, base, digit] = /^(\D+)(\d?)$/.exec(type)!
  const size = Number(digit || 1)
  const expectedShape = base === 'mat' ? [size, size] : [1, size]
  if (`${shape}` === `${expectedShape}`) return expression
  throw place.expected(article(type), describeShape(shape))
}

/** Registers the GLSL front end globally, so that `glsl.source` of any copy of warpjet finds it. */
export function registerFrontEnd() {
  Reflect.set(globalThis, frontEndKey, functionOf)
}
