// `glsl.fn`: functions of the host's shader, called like built-in ones.
import { describe } from '../../errors/describe.js'
import { kind, optional, text, wholeNumber } from '../../options/kinds.js'
import { Place } from '../../options/place.js'
import { rejectUnknownOptions } from '../../options/schema.js'
import { languages } from '../../wasm/tables.js'
import { expressionAsText, toExpression, type Expression } from './expression.js'
import type { Session } from './session.js'

const families = [...new Set(Object.values(languages))]

/** Returns the sources that were passed, each with its language. A plain string is source of `language`. */
function sourcesOf(source: unknown, language: string): [language: string, source: string][] {
  const all = source && typeof source === 'object' ? source : { [language]: source }
  return families
    .map((family): [string, unknown] => [family, Reflect.get(all, family)])
    .filter((each): each is [string, string] => typeof each[1] === 'string')
}

const place = new Place('fn')
const names = ['name', 'source', 'arity', 'derivatives']
const functionName = text()
const arityKind = wholeNumber({ min: 1, max: 16 })

/** Declares a function of the host, and returns the function that the user calls. */
export function declareFunction(session: Session, options: unknown) {
  if (options === undefined)
    throw place.expected('an object { name, source, arity, derivatives }', 'undefined')
  rejectUnknownOptions(options, names, place)
  const passed = options as Record<string, unknown>
  const name = functionName.read(passed.name, place.option('name'))
  const optionPlace = (option: string) => place.part(`the option "${option}" of ${name}`)
  const arity = arityKind.read(passed.arity, optionPlace('arity'))
  const language = languages[session.target]
  const sources = new Map(sourcesOf(passed.source, language))
  if (!sources.has(language))
    throw optionPlace('source').expected(
      `${language.toUpperCase()} source for the target ${session.target}, or an object { ${language}: … } with it,`,
      describe(passed.source),
    )
  if ([...sources.values()].some((code) => code.includes(expressionAsText)))
    throw optionPlace('source').error(
      `the option "source" of ${name} contains an expression; make it an argument of the function.`,
    )
  const derivatives = optional(
    kind<readonly unknown[]>(
      `an array of ${arity}, one for each argument,`,
      (list) => Array.isArray(list) && list.length === arity,
    ),
  ).read(passed.derivatives, optionPlace('derivatives'))
  const number = session.addFunction({ name, arity, derivatives }, sources)
  const call = new Place(name)
  return (...operands: unknown[]): Expression =>
    session.callFunction(
      number,
      name,
      operands.map((operand, i) => toExpression(session, operand, call, i + 1)),
    )
}
