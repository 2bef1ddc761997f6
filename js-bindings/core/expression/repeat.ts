// `glsl.repeat`: its function is called once, and what it made of the state becomes the body of a loop.
import type { Session } from './session.js'
import { isExpression } from '../../errors/describe.js'
import { WarpError, describe } from '../../errors/errors.js'
import { isCallable } from '../../options/options.js'
import { type Expression, toExpression } from './expression.js'

/** A state: one operand, or a record of them. */
type State = unknown

const isRecord = (state: State): state is Record<string, unknown> =>
  typeof state === 'object' && state !== null && !isExpression(state) && !Array.isArray(state)

export function repeat(session: Session, given: readonly unknown[]): unknown {
  const refuse = (why: string): never => {
    throw new WarpError(`repeat: ${why}`)
  }
  const [count, start, body, ...others] = given
  if (others.length > 0)
    refuse(`it takes a count, a state and a function; ${describe(others[0])} is too many.`)
  if (isExpression(count))
    refuse(
      'argument 1 is an expression, but how often a loop runs must be a number; give the most it can be, and let ifElse keep the state from then on.',
    )
  if (!(Number.isInteger(count) && (count as number) >= 0 && (count as number) < 2 ** 31))
    refuse(`argument 1 must be a whole number, 0 or above, but is ${describe(count)}.`)
  if (!isCallable(body))
    return refuse(`argument 3 must be a function (state, i) => …, but is ${describe(body)}.`)

  const names = isRecord(start) ? Object.keys(start) : undefined
  if (names?.length === 0) refuse('argument 2 must hold a state, but is an empty object.')
  const called = (name: string) => (names ? `"${name}"` : 'the state')
  /** What the parts of a state are, in the order in which it starts. */
  const partsOf = (state: State, verb: string): Expression[] => {
    if (!names) return [toExpression(session, 'repeat', state, `what the state ${verb}`)]
    return names.map((name) =>
      toExpression(
        session,
        'repeat',
        (state as Record<string, unknown>)[name],
        `what ${called(name)} ${verb}`,
      ),
    )
  }
  const stateOf = (parts: readonly Expression[]): unknown =>
    names ? Object.fromEntries(names.map((name, i) => [name, parts[i]])) : parts[0]
  const returned = (state: unknown): Expression[] => {
    if (state === undefined)
      refuse(
        'the function must return the next state, but returns nothing; put a return before it.',
      )
    if (names && !isRecord(state))
      refuse(
        `the function must return an object with ${names.join(', ')}, as the state starts, but returns ${describe(state)}.`,
      )
    if (!names && isRecord(state))
      refuse(`the function must return one state, as it starts, but returns ${describe(state)}.`)
    const keys = names ? Object.keys(state as object) : []
    const missing = names?.find((name) => !keys.includes(name))
    if (missing !== undefined)
      refuse(`the function must return "${missing}" too, which the state starts with.`)
    const unknown = keys.find((key) => !names!.includes(key))
    if (unknown !== undefined)
      refuse(
        `the function returns "${unknown}", but the state starts with ${names!.join(', ')}; start with it too.`,
      )
    return partsOf(state, 'becomes')
  }
  const starts = partsOf(start, 'starts as')
  return stateOf(
    session.repeat(
      count as number,
      starts,
      (parts, step) => returned((body as (...all: unknown[]) => unknown)(stateOf(parts), step)),
      names?.map(called) ?? ['the state'],
    ),
  )
}
