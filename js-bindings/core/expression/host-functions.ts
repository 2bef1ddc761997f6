// `glsl.fn`: functions of the host's shader, used like built-in ones.
import type { Session, HostFunction } from './session.js'
import { WarpError, describe } from '../../errors/errors.js'
import { type Expression, expressionAsText, toExpression } from './expression.js'
import { checkOptions } from '../../options/options.js'
import { languages } from '../../wasm/tables.js'

const families = [...new Set(Object.values(languages))]

/** A text by itself is one of the language that is asked for. */
function sourcesOf(source: unknown, language: string): [language: string, text: string][] {
  const all = source && typeof source === 'object' ? source : { [language]: source }
  return families
    .map((family): [string, unknown] => [family, Reflect.get(all, family)])
    .filter((each): each is [string, string] => typeof each[1] === 'string')
}

/** Checks the options of `glsl.fn` and gives the function that the sketch calls. */
export function declareFunction(session: Session, options: unknown) {
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
  const language = languages[session.target]
  const sources = new Map(sourcesOf(source, language))
  if (!sources.has(language))
    throw new WarpError(
      `fn: the option "source" of ${name} must be a text of ${language.toUpperCase()} for the target ${session.target}, or an object { ${language}: … } with one, but is ${describe(source)}.`,
    )
  if ([...sources.values()].some((text) => text.includes(expressionAsText)))
    throw new WarpError(
      `fn: the option "source" of ${name} has an expression in its text; make it an argument of the function.`,
    )
  const isList = Array.isArray(derivatives) && derivatives.length === arity
  if (derivatives !== undefined && !isList)
    throw new WarpError(
      `fn: the option "derivatives" of ${name} must be an array of ${arity as number}, one for each argument, but is ${describe(derivatives)}.`,
    )
  const declared = { name, arity: arity as number, derivatives } as HostFunction
  const number = session.addFunction(declared, sources)
  return (...operands: unknown[]): Expression =>
    session.callFunction(
      number,
      name,
      operands.map((operand, i) => toExpression(session, name, operand, i + 1)),
    )
}
