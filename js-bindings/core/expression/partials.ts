// The functions that `glsl.fn` declares, and their partial derivatives.
import { WarpError } from '../../errors/errors.js'
import { isCallable } from '../../options/guards.js'
import { Place } from '../../options/place.js'
import type { Session as CoreSession } from '../../wasm/core.js'
import { Expression, toExpression, type Origin } from './expression.js'

/** A declared function of the host, from numbers to a number. */
export interface HostFunction {
  name: string
  arity: number
  /** One per argument: a number, an expression, or a function that returns one of them from the arguments. */
  derivatives: readonly unknown[] | undefined
}

const maxNesting = 100

/** The declared functions of a session, by number. */
export class HostFunctions {
  private readonly functions: HostFunction[] = []
  /** The depth of recursion: the number of derivatives that are being computed, each of which needs the next. */
  private nesting = 0

  constructor(private readonly origin: Origin) {}

  add(number: number, hostFunction: HostFunction) {
    this.functions[number] = hostFunction
  }

  /** Computes the partial derivatives of a call in the session. */
  partialsOf(session: CoreSession, call: number): Expression[] {
    const called = this.functions[session.functionOfCall(call)]!
    const operands = Array.from(
      { length: called.arity },
      (_, i) => new Expression(this.origin, session.argumentOfCall(call, i)),
    )
    if (this.nesting === maxNesting)
      throw new WarpError(
        `${called.name}: its derivative needs a derivative of itself; write it with calls of functions instead.`,
      )
    this.nesting++
    try {
      return this.partials(called, operands)
    } finally {
      this.nesting--
    }
  }

  private partials({ name, derivatives }: HostFunction, operands: readonly Expression[]) {
    if (!derivatives)
      throw new WarpError(
        `${name}: its derivatives are needed here; pass the option "derivatives" to glsl.fn, one per argument.`,
      )
    return Array.from(derivatives, (given, i) =>
      toExpression(
        this.origin,
        isCallable(given) ? given(...(operands as never[])) : given,
        new Place(name, `derivative ${i + 1}`),
      ),
    )
  }
}
