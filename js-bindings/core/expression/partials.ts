// The partial derivatives of a function of the host, as the sketch declared them.
import { WarpError } from '../../errors/errors.js'
import { isCallable } from '../../options/guards.js'
import { Place } from '../../options/place.js'
import { type Expression, type Origin, toExpression } from './expression.js'

/** A function of the host from numbers to a number, as the sketch declared it. */
export interface HostFunction {
  name: string
  arity: number
  /** One for each argument: a number, an expression, or a function from the arguments to one of them. */
  derivatives: readonly unknown[] | undefined
}

/** The derivatives of a call by each of its operands. */
export function partialsOf(
  session: Origin,
  { name, derivatives }: HostFunction,
  operands: readonly Expression[],
): Expression[] {
  if (!derivatives)
    throw new WarpError(
      `${name}: its derivatives are needed here; give glsl.fn the option "derivatives", one for each argument.`,
    )
  return Array.from(derivatives, (given, i) =>
    toExpression(
      session,
      isCallable(given) ? given(...(operands as never[])) : given,
      new Place(name, `derivative ${i + 1}`),
    ),
  )
}
