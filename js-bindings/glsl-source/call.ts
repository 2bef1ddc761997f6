// `glsl.source`: a function of shader text among a sketch's own expressions.
import { WarpError, describe, describeShape } from '../errors/errors.js'
import { checkOptions } from '../options/options.js'
import { isExpression } from '../errors/describe.js'
import { frontEndKey } from '../errors/front-end.js'
import type { Builder } from '../core/expression/builder.js'
import type { Expression } from '../core/expression/expression.js'
import { bindExternals } from './bind.js'
import { type Given, halvesOf } from './halves.js'
import { type FunctionHead, type Named, withSource } from './listing.js'
import { type GlslOptions, article, checkSource, readIterations, readName } from './options.js'
import { pack, replay } from './replay.js'

export interface GlslSourceOptions extends GlslOptions {
  /** What the uniforms of the text are, as an offset function gets it; those that it lacks are the shader's own. */
  uniforms?: object
}

/** Calls the function with numbers and expressions, as often as the sketch likes. */
export type SourceFunction = (...operands: unknown[]) => Expression

function readSource(glsl: Builder, source: unknown, options: GlslSourceOptions = {}) {
  checkSource('source', source)
  checkOptions('source', options, ['function', 'maxIterations', 'uniforms'])
  const { uniforms = {} } = options
  if (typeof uniforms !== 'object' || uniforms === null)
    throw new WarpError(
      `source: the option "uniforms" must be an object of numbers and expressions, but is ${describe(uniforms)}.`,
    )
  const listing = withSource('source', source, (text) => {
    const head = text.find(readName('source', options.function))
    checkCallable(head)
    return text.list(head, readIterations('source', options.maxIterations))
  })
  const { head, externals } = listing
  const outside = bindExternals('source', glsl, externals, { uniforms: uniforms as never })
  const call: SourceFunction = (...operands) => {
    const { name, parameters } = head
    if (operands.length !== parameters.length)
      throw new WarpError(
        `${name}: it takes ${parameters.length} arguments (${parameters.map((each) => each.type).join(', ')}), but ${operands.length} came.`,
      )
    const given = operands.map((operand, i) => argument(glsl, name, parameters[i]!, operand, i + 1))
    return pack(glsl, head.type, replay(glsl, listing, { arguments: given, ...outside }))
  }
  return call
}

function checkCallable({ name, type, parameters }: FunctionHead) {
  if (!/^(?:float|int|uint|bool|vec[234]|mat[234])$/.test(type))
    throw new WarpError(`source: ${name} gives ${article(type)}, which no expression can be.`)
  for (const each of parameters) {
    if (each.isOut)
      throw new WarpError(`source: the parameter ${each.name} of ${name} is out; return a value.`)
    if (!/^(?:float|int|uint|bool|vec[234]|mat[234])$/.test(each.type))
      throw new WarpError(
        `source: the parameter ${each.name} of ${name} is ${article(each.type)}, which no expression can be.`,
      )
  }
}

function argument(
  glsl: Builder,
  name: string,
  { type }: Named,
  operand: unknown,
  place: number,
): Given {
  const refuse = (came: string): never => {
    throw new WarpError(`${name}: argument ${place} must be ${article(type)}, but is ${came}.`)
  }
  if (typeof operand === 'number' && /^u?int$/.test(type)) return halvesOf(glsl, operand)
  const value = typeof operand === 'number' ? glsl.val!(operand) : operand
  if (!isExpression(value)) return refuse(describe(operand))
  const expression = value as Expression
  const shape = expression.session.shapeOf(expression)
  const [, word, digit] = /^(\D+)(\d?)$/.exec(type)!
  const size = Number(digit || 1)
  const wanted = word === 'mat' ? [size, size] : [1, size]
  return `${shape}` === `${wanted}` ? expression : refuse(describeShape(shape))
}

/** So that `glsl.source` finds it, in whichever copy of warpjet. */
export function registerFrontEnd() {
  Reflect.set(globalThis, frontEndKey, readSource)
}
