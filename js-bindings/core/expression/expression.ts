// What a sketch holds while it writes an offset: the handle of a number, vector or matrix in the wasm. Its methods come
// from `builder.ts`; `types.ts` names them.
import { describeShape, isExpression, vectorOfNumbers } from '../../errors/describe.js'
import { WarpError, describe } from '../../errors/errors.js'
import { operatorsKey } from '../../errors/operators.js'
import type { Shape } from './shapes.js'

const largestFloat32 = 3.4028234663852886e38

/** Nothing that a shader could read, so that it is refused wherever a name is asked for. */
export const expressionAsText = 'an expression of warpjet'

/** The session that an expression is of. */
export interface Origin {
  constant(value: number, method: string): Expression
  shapeOf(value: Expression): Shape
}

export class Expression {
  constructor(
    readonly session: Origin,
    readonly handle: number,
  ) {}

  /**
   * JavaScript asks for this where an operator of its own meets an expression, and as "string" where only a text is wanted:
   * in messages, and by the friendly errors of p5 1.11, which read what they are handed as if it were a number.
   */
  [Symbol.toPrimitive](hint: string): string {
    if (hint === 'string') return expressionAsText
    if (operatorsKey in globalThis)
      throw new WarpError(
        "JavaScript's own + - * / < > and Math functions do not work on expressions here, in a function that warpjet/operators has not read; hand that function to createWarp or operators() itself, or write x.add(1), x.mult(2), x.gt(0).ifElse(a, b), x.sin() in it.",
      )
    throw new WarpError(
      "JavaScript's own + - * / < > and Math functions do not work on expressions; write x.add(1), x.mult(2), x.gt(0).ifElse(a, b), x.sin(), or add the script warpjet.operators.min.js or import 'warpjet/operators', with which they do.",
    )
  }

  /** The components of a vector, as in `const [x, y, z] = position`. */
  *[Symbol.iterator](): Generator<Expression> {
    const [columns, rows] = this.session.shapeOf(this)
    if (columns !== 1 || rows < 2)
      throw new WarpError(
        `An expression is taken apart as in const [x, y, z] = position: expected a vector, got ${describeShape([columns, rows])}.`,
      )
    for (const name of [...'xyzw'].slice(0, rows)) yield Reflect.get(this, name) as Expression
  }

  /** What Node's console prints. */
  [Symbol.for('nodejs.util.inspect.custom')](): string {
    return expressionAsText
  }
}

const isVector = (value: unknown) => Array.isArray(value) || describe(value) === vectorOfNumbers

/**
 * An operand of `method` as an expression of this session. `place` is its name in messages, or the number of the
 * argument.
 */
export function toExpression(
  session: Origin,
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
    return session.constant(operand, method)
  }
  if (!isExpression(operand))
    return refuse(
      `must be a number or an expression, but is ${describe(operand)}${isVector(operand) ? '; write glsl.vec3(x, y, z) for a vector' : ''}.`,
    )
  if (!(operand instanceof Expression))
    return refuse(
      'was made by another copy of warpjet; this page loads two, so take all of warpjet from one place.',
    )
  if (operand.session !== session)
    refuse(
      'comes from another warp; an expression can only be used inside the function that made it.',
    )
  return operand
}
