// What a sketch holds while it writes an offset: the numbers of some nodes. A scalar has one, a
// vector two to four. Its methods come from `operations.ts` and `vectors.ts`; `types.ts` names them.
import type { Compilation } from './compilation.js'
import { WarpError, describe } from './errors.js'

export class Expression {
  constructor(
    readonly compilation: Compilation,
    readonly ids: readonly number[],
  ) {}

  /** JavaScript asks for this where an operator of its own meets an expression. */
  [Symbol.toPrimitive](): never {
    throw new WarpError(
      "JavaScript's own + - * / < > and Math functions do not work on expressions; write x.add(1), x.mult(2), x.gt(0).ifElse(a, b), x.sin().",
    )
  }
}

/** What a method was given: numbers or expressions, if the sketch is right. */
export type Operand = Expression | number

export const placeName = (place: string | number) =>
  typeof place === 'number' ? `argument ${place}` : place

/** How the size of an expression is called in messages. */
export function sizeName(size: number): string {
  return size === 1 ? 'a single number' : `a vec${size}`
}

/**
 * An operand of `method` as an expression of this compilation. `place` is its name in messages, or the
 * number of the argument.
 */
export function toExpression(
  compilation: Compilation,
  method: string,
  operand: unknown,
  place: string | number,
): Expression {
  if (typeof operand === 'number')
    return new Expression(compilation, [compilation.constant(operand, method, place)])
  if (!(operand instanceof Expression))
    throw new WarpError(
      `${method}: ${placeName(place)} must be a number or an expression, but is ${describe(operand)}.`,
    )
  if (operand.compilation !== compilation)
    throw new WarpError(
      `${method}: ${placeName(place)} comes from another warp; an expression can only be used inside the function that made it.`,
    )
  return operand
}
