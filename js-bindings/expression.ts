// What a sketch holds while it writes an offset: the handle of a number, vector or matrix in the wasm. Its methods come
// from `builder.ts`; `types.ts` names them.
import { WarpError, describe } from './errors.js'
import type { Shape } from './shape.js'

const largestFloat32 = 3.4028234663852886e38

/** The compilation that an expression is of. */
export interface Origin {
  constant(value: number, method: string): Expression
  shapeOf(value: Expression): Shape
}

export class Expression {
  constructor(
    readonly compilation: Origin,
    readonly handle: number,
  ) {}

  /** JavaScript asks for this where an operator of its own meets an expression. */
  [Symbol.toPrimitive](): never {
    throw new WarpError(
      "JavaScript's own + - * / < > and Math functions do not work on expressions; write x.add(1), x.mult(2), x.gt(0).ifElse(a, b), x.sin().",
    )
  }
}

/**
 * An operand of `method` as an expression of this compilation. `place` is its name in messages, or the number of the
 * argument.
 */
export function toExpression(
  compilation: Origin,
  method: string,
  operand: unknown,
  place: string | number,
): Expression {
  const refuse = (why: string): never => {
    throw new WarpError(
      `${method}: ${typeof place === 'number' ? `argument ${place}` : place} ${why}`,
    )
  }
  if (typeof operand === 'number') {
    if (!(Math.abs(operand) <= largestFloat32))
      refuse(`is ${operand}, but a shader can only hold numbers between -3.4e38 and 3.4e38.`)
    if (operand !== 0 && Math.fround(operand) === 0)
      refuse(`is ${operand}, too close to zero for a shader to hold; use 0 instead.`)
    return compilation.constant(operand, method)
  }
  if (!(operand instanceof Expression))
    return refuse(
      `must be a number or an expression, but is ${describe(operand)}${Array.isArray(operand) ? '; write glsl.vec3(x, y, z) for a vector' : ''}.`,
    )
  if (operand.compilation !== compilation)
    refuse(
      'comes from another warp; an expression can only be used inside the function that made it.',
    )
  return operand
}
