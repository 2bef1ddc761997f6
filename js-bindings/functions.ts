// `glsl.fn`: functions of the host's shader, used like built-in ones.
import type { Compilation, Target } from './compilation.js'
import { WarpError, describe } from './errors.js'
import { type Expression, expressionAsText, toExpression } from './expression.js'
import { checkOptions } from './options.js'

/** A function of the host from numbers to a number, as the sketch declared it. */
export interface HostFunction {
  name: string
  arity: number
  /** One for each argument: a number, an expression, or a function from the arguments to one of them. */
  derivatives: readonly unknown[] | undefined
}

const family = (target: Target) => (target === 'wgsl' ? 'wgsl' : 'glsl')

/** Checks the options of `glsl.fn` and gives the function that the sketch calls. */
export function declareFunction(compilation: Compilation, options: unknown) {
  if (options === undefined)
    throw new WarpError('fn: an object { name, source, arity, derivatives } was expected.')
  checkOptions('fn', options, ['name', 'source', 'arity', 'derivatives'])
  const { name, source, arity, derivatives } = options as Record<string, unknown>
  if (typeof name !== 'string')
    throw new WarpError(`fn: the option "name" must be a text, but is ${describe(name)}.`)
  if (!(Number.isInteger(arity) && (arity as number) >= 1 && (arity as number) <= 16))
    throw new WarpError(
      `fn: the option "arity" of ${name} must be a whole number from 1 to 16, but is ${describe(arity)}.`,
    )
  const wanted = family(compilation.target)
  const text = source && typeof source === 'object' ? Reflect.get(source, wanted) : source
  if (typeof text !== 'string')
    throw new WarpError(
      `fn: the option "source" of ${name} must be a text of ${wanted.toUpperCase()} for the target ${compilation.target}, or an object { ${wanted}: … } with one, but is ${describe(source)}.`,
    )
  if (text.includes(expressionAsText))
    throw new WarpError(
      `fn: the option "source" of ${name} has an expression in its text; make it an argument of the function.`,
    )
  const isList = Array.isArray(derivatives) && derivatives.length === arity
  if (derivatives !== undefined && !isList)
    throw new WarpError(
      `fn: the option "derivatives" of ${name} must be an array of ${arity as number}, one for each argument, but is ${describe(derivatives)}.`,
    )
  const declared = { name, arity: arity as number, derivatives } as HostFunction
  const number = compilation.addFunction(declared, text)
  return (...operands: unknown[]): Expression =>
    compilation.callFunction(
      number,
      name,
      operands.map((operand, i) => toExpression(compilation, name, operand, i + 1)),
    )
}
