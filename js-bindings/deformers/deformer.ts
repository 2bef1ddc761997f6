// From what a caller hands to a deformer to what its formula works with. Constants are checked at once, what is computed
// when the warp is made.
import { WarpError, describe, describeShape } from '../errors/errors.js'
import { asOwn, readOperators } from '../errors/operators.js'
import { checkOptions, isCallable } from '../options/options.js'
import type { Expression } from '../core/expression/expression.js'
import type { OffsetFunction, Vec3, WarpInputs } from '../core/types/types.js'
import { type Kind, isExpression } from './kinds.js'

export type Kinds = Record<string, Kind<unknown>>

/** The values of options by name, as the formula gets them. */
export type Values<All extends Kinds> = {
  [Name in keyof All]: All[Name] extends Kind<infer Value> ? Value : never
}

/** An offset function from its options and its formula, for the deformer of that name. */
export function deformer<All extends Kinds>(
  name: string,
  options: object | undefined,
  kinds: All,
  formula: (inputs: WarpInputs, values: Values<All>) => Vec3,
): OffsetFunction {
  checkDeformerOptions(name, options, kinds)
  const given = (options ?? {}) as Record<string, unknown>
  const all = Object.entries(kinds).map(([option, kind]) =>
    reader(`${name}: the option "${option}"`, kind, given[option]),
  )
  return asOwn((inputs) => {
    const values = all.map((read, i) => [Object.keys(kinds)[i], read(inputs)])
    return formula(inputs, Object.fromEntries(values) as Values<All>)
  })
}

export function checkDeformerOptions(name: string, options: object | undefined, kinds: Kinds) {
  if (Object.keys(options ?? {}).includes('glsl'))
    throw new WarpError(
      `${name}: it makes an offset function; call it with its options, as in createWarp(${name}({})).`,
    )
  checkOptions(name, options, Object.keys(kinds))
}

/** Checks a constant; gives what makes the value inside of a warp. `place` names the option in messages. */
export function reader<Value>(place: string, kind: Kind<Value>, given: unknown) {
  const value = given === undefined ? kind.standard : given
  const isComputed = kind.rows !== 0 && isCallable(value)
  const compute = isComputed ? readOperators(value, { method: place }) : undefined
  const mustBe = isComputed ? returning(place, kind) : being(place, kind)
  const isKnown = kind.rows === 0 || !(isComputed || isExpression(value))
  if (isKnown && !kind.allows(value)) throw new WarpError(mustBe(describe(value)))

  return (inputs: WarpInputs): Value => {
    const result: unknown = compute ? compute(inputs as never) : value
    const wrong =
      kind.rows !== 0 && isExpression(result)
        ? wrongShape(place, kind.rows, result, inputs)
        : !kind.allows(result) && describe(result)
    if (wrong) throw new WarpError(mustBe(wrong))
    return kind.make(inputs.glsl, result as never)
  }
}

const shapes = { 1: 'an expression of one number', 3: 'a vec3' }

const being =
  (place: string, { expected, rows }: Kind<unknown>) =>
  (what: string) =>
    `${place} must be ${expected}${rows === 0 ? '' : `, ${shapes[rows]}, or a function that returns one`}, but is ${what}.`

const returning =
  (place: string, { expected, rows }: Kind<unknown>) =>
  (what: string) =>
    `${place} is a function that must return ${expected}${rows === 0 ? '' : ` or ${shapes[rows]}`}, but returned ${what}.`

/** What an expression is instead of a number or a vec3, or nothing. */
function wrongShape(place: string, expected: 1 | 3, value: unknown, inputs: WarpInputs) {
  const expression = value as Expression
  const { session } = inputs.position as unknown as Expression
  if (expression.session !== session)
    throw new WarpError(
      `${place} comes from another warp; give a function such as ({ millis }) => millis.div(1000), or make the deformer inside of the offset function.`,
    )
  const [columns, rows] = session.shapeOf(expression)
  return columns === 1 && rows === expected ? undefined : describeShape([columns, rows])
}
