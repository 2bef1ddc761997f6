// `glsl.repeat`: its function is called once, and the expressions that it returns become the body of a loop.
import { describe, describeShape, isExpression } from '../../errors/describe.js'
import { callable, wholeNumber } from '../../options/kinds.js'
import { Place } from '../../options/place.js'
import { toExpression, type Expression } from './expression.js'
import type { Session } from './session.js'

/** A state: an operand, or a record of operands. */
type State = unknown

const isRecord = (state: State): state is Record<string, unknown> =>
  typeof state === 'object' && state !== null && !isExpression(state) && !Array.isArray(state)

const place = new Place('repeat')
const body = callable<(...all: unknown[]) => unknown>('a function (state, i) => …')
const count = wholeNumber({ max: 2 ** 31 - 1 })

export function repeat(
  session: Session,
  [steps, start, step, ...others]: readonly unknown[],
): unknown {
  if (others.length > 0)
    throw place.error(
      `it takes a count, a state and a function; ${describe(others[0])} is too many.`,
    )
  if (isExpression(steps))
    throw place.error(
      'argument 1 is an expression, but the number of steps must be a number; pass its maximum, and keep the state by ifElse after the last step.',
    )
  const times = count.read(steps, place.argument(1))
  const next = body.read(step, place.argument(3))
  const state = new StateShape(session, start)
  const results = session.repeat(times, state.starts, (parts, i) =>
    state.partsOfNext(next(state.assemble(parts), i)),
  )
  return state.assemble(results)
}

/** The shape of a loop's state: an expression, or several by name. */
class StateShape {
  /** Missing for a state that is one expression. */
  private readonly names: readonly string[] | undefined
  /** The names of the parts in messages. */
  private readonly labels: readonly string[]
  readonly starts: readonly Expression[]

  constructor(
    private readonly session: Session,
    start: State,
  ) {
    this.names = isRecord(start) ? Object.keys(start) : undefined
    if (this.names?.length === 0)
      throw place.argument(2).expected('an object that holds a state', 'an empty object')
    this.labels = this.names?.map((name) => `"${name}"`) ?? ['the state']
    this.starts = this.partsOf(start, 'start')
  }

  /** Returns the state that consists of these parts. */
  assemble(parts: readonly Expression[]): unknown {
    return this.names ? Object.fromEntries(this.names.map((name, i) => [name, parts[i]])) : parts[0]
  }

  /** Returns the parts of the state that the function returned. */
  partsOfNext(state: State): Expression[] {
    const { names } = this
    if (state === undefined)
      throw place.error(
        'the function must return the next state, but returns nothing; put a return before it.',
      )
    if (names && !isRecord(state))
      throw place.error(
        `the function must return an object with ${names.join(', ')}, like the start, but returns ${describe(state)}.`,
      )
    if (!names && isRecord(state))
      throw place.error(
        `the function must return one state, like the start, but returns ${describe(state)}.`,
      )
    const keys = names ? Object.keys(state as object) : []
    const missing = names?.find((name) => !keys.includes(name))
    if (missing !== undefined)
      throw place.error(`the function must return "${missing}" too, which is part of the start.`)
    const unknown = keys.find((key) => !names!.includes(key))
    if (unknown !== undefined)
      throw place.error(
        `the function returns "${unknown}", but the start has ${names!.join(', ')}; add it there too.`,
      )
    const nexts = this.partsOf(state, 'next value')
    nexts.forEach((next, i) => this.rejectOtherShape(next, i))
    return nexts
  }

  private rejectOtherShape(next: Expression, i: number) {
    const [startShape, nextShape] = [this.starts[i]!, next].map((each) =>
      describeShape(this.session.shapeOf(each)),
    )
    if (startShape !== nextShape)
      throw place.error(
        `${this.labels[i]} starts as ${startShape}, but the function returns ${nextShape} for it; start with ${nextShape}.`,
      )
  }

  /** Returns the parts of a state, in the order of the start. */
  private partsOf(state: State, what: string): Expression[] {
    const parts = this.names
      ? this.names.map((name) => (state as Record<string, unknown>)[name])
      : [state]
    return parts.map((part, i) =>
      toExpression(this.session, part, place.part(`the ${what} of ${this.labels[i]}`)),
    )
  }
}
