// An expression: the handle of a number, vector or matrix in the wasm. methods.ts installs its methods; core/types has their types.
import { describeShape, isExpression, vectorOfNumbers } from '../../errors/describe.js'
import { WarpError, describe } from '../../errors/errors.js'
import { operatorsKey } from '../../errors/operators.js'
import type { Place } from '../../options/place.js'
import type { Shape } from './shapes.js'

const largestFloat32 = 3.4028234663852886e38

/** The string to which expressions are converted. It is no valid name in a shader, so it is rejected wherever a name is expected. */
export const expressionAsText = 'an expression of warpjet'

/** The session of an expression. */
export interface Origin {
  constant(value: number, place: Place): Expression
  shapeOf(value: Expression): Shape
}

export class Expression {
  constructor(
    readonly session: Origin,
    readonly handle: number,
  ) {}

  /**
   * JavaScript calls this if an operand of its own operators is an expression. The hint is "string" if only a string is needed: in
   * messages, and by the friendly errors of p5 1.11, which read arguments as if they were numbers.
   */
  [Symbol.toPrimitive](hint: string): string {
    if (hint === 'string') return expressionAsText
    if (operatorsKey in globalThis)
      throw new WarpError(
        "JavaScript's own + - * / < > and Math functions do not work on expressions here, in a function that warpjet/operators has not read; pass that function itself to createWarp or operators(), or write x.add(1), x.mult(2), x.gt(0).ifElse(a, b), x.sin() in it.",
      )
    throw new WarpError(
      "JavaScript's own + - * / < > and Math functions do not work on expressions; write x.add(1), x.mult(2), x.gt(0).ifElse(a, b), x.sin(), or add the script warpjet.operators.min.js or import 'warpjet/operators', with which they do.",
    )
  }

  /** Yields the components of a vector, as in `const [x, y, z] = position`. */
  *[Symbol.iterator](): Generator<Expression> {
    const [columns, rows] = this.session.shapeOf(this)
    if (columns !== 1 || rows < 2)
      throw new WarpError(
        `An expression is destructured as in const [x, y, z] = position: expected a vector, got ${describeShape([columns, rows])}.`,
      )
    for (const name of [...'xyzw'].slice(0, rows)) yield Reflect.get(this, name) as Expression
  }

  /** Returns the string that Node's console prints. */
  [Symbol.for('nodejs.util.inspect.custom')](): string {
    return expressionAsText
  }
}

/** Converts an operand to an expression of the session. `place` is the call, `argument` the operand's number among its arguments, if any. */
export function toExpression(
  session: Origin,
  operand: unknown,
  place: Place,
  argument?: number,
): Expression {
  if (typeof operand === 'number' && isFloat32(operand)) return session.constant(operand, place)
  if (operand instanceof Expression && operand.session === session) return operand
  throw invalidOperand(operand, argument === undefined ? place : place.argument(argument))
}

/** Tests for a number that rounds to a finite float32, and to zero only if it is zero. */
const isFloat32 = (x: number) => Math.abs(x) <= largestFloat32 && (x === 0 || Math.fround(x) !== 0)

const isVector = (value: unknown) => Array.isArray(value) || describe(value) === vectorOfNumbers

function invalidOperand(operand: unknown, place: Place): WarpError {
  const errorAbout = (what: string) => place.error(`${place.subject} ${what}`)
  if (typeof operand === 'number')
    return Math.abs(operand) <= largestFloat32
      ? errorAbout(`is ${operand}, too close to zero for a shader to hold; use 0 instead.`)
      : errorAbout(`is ${operand}, but a shader can only hold numbers between -3.4e38 and 3.4e38.`)
  if (!isExpression(operand)) {
    const advice = isVector(operand) ? 'write glsl.vec3(x, y, z) for a vector' : undefined
    return place.expected('a number or an expression', describe(operand), advice)
  }
  return errorAbout(
    operand instanceof Expression
      ? 'comes from another warp; an expression can only be used inside the function that made it.'
      : 'was made by another copy of warpjet; this page loads two copies, so load all of warpjet from one place.',
  )
}
