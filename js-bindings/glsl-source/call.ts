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
  /** The values of the source's uniforms, such as the `uniforms` of an offset function; uniforms it lacks are the shader's own. */
  uniforms?: object
}

/** Calls the function with numbers and expressions. */
export type SourceFunction = (...operands: unknown[]) => Expression

const place = new Place('source')
const sourceOptions = object({
  ...glslKinds,
  uniforms: record<object>('an object of numbers and expressions', { default: {} }),
} satisfies KindsOf<GlslSourceOptions>)

function functionOf(glsl: Builder, source: unknown, given?: GlslSourceOptions): SourceFunction {
  const text = sourceKinds.glsl.read(source, place.part('the source'))
  const options = sourceOptions.read(given, place)
  const listing = withSource(place, { text, language: 'glsl' }, (open) => {
    const head = open.find(options.function)
    rejectOtherTypes(head)
    return open.list(head, options.maxIterations)
  })
  const { head, externals } = listing
  const { name, parameters } = head
  const outside = bindExternals(place, glsl, externals, { uniforms: options.uniforms as never })
  return (...operands) => {
    if (operands.length !== parameters.length)
      throw new WarpError(
        `${name}: expected ${parameters.length} arguments (${parameters.map((each) => each.type).join(', ')}), got ${operands.length}.`,
      )
    const given = operands.map((operand, i) =>
      toParameter(glsl, parameters[i]!, operand, new Place(name).argument(i + 1)),
    )
    return pack(glsl, head.type, replay(glsl, listing, { arguments: given, ...outside }))
  }
}

function rejectOtherTypes({ name, type, parameters }: FunctionHead) {
  if (!/^(?:float|int|uint|bool|vec[234]|mat[234])$/.test(type))
    throw place.error(`${name} returns ${article(type)}, which no expression can be.`)
  for (const each of parameters) {
    if (each.isOut)
      throw place.error(`the parameter ${each.name} of ${name} is out; return a value.`)
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
  const [, word, digit] = /^(\D+)(\d?)$/.exec(type)!
  const size = Number(digit || 1)
  const wanted = word === 'mat' ? [size, size] : [1, size]
  if (`${shape}` === `${wanted}`) return expression
  throw place.expected(article(type), describeShape(shape))
}

/** Registers the front end, such that `glsl.source` of any copy of warpjet finds it. */
export function registerFrontEnd() {
  Reflect.set(globalThis, frontEndKey, functionOf)
}
