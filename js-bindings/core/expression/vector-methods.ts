// Methods of p5.Vector that are no operation of their own. Expressions never change, so each gives a new one.
import { WarpError } from '../../errors/errors.js'
import { describeShape } from '../../errors/describe.js'
import { type Expression, toExpression } from './expression.js'
import type { Session } from './session.js'

type Methods = Record<string, (...operands: unknown[]) => Expression>
type Operand = Expression & Methods

const methodsOf = (expression: Expression) => expression as Operand

const shapeOf = (x: Expression) => x.session.shapeOf(x)

/** The operand of a method as an expression. */
const operandOf = (x: Expression, method: string, value: unknown) =>
  methodsOf(toExpression(x.session, method, value, 1))

/** A vector of one of these sizes. */
function checkVector(x: Expression, method: string, sizes: readonly number[]) {
  const [columns, rows] = shapeOf(x)
  if (columns === 1 && sizes.includes(rows)) return rows
  throw new WarpError(
    `${method}: expected ${sizes.map((size) => `a vec${size}`).join(' or ')}, got ${describeShape([columns, rows])}.`,
  )
}

function checkCount(method: string, given: readonly unknown[], counts: readonly number[]) {
  if (counts.includes(given.length)) return
  const [count] = counts
  throw new WarpError(
    `${method}: expected ${count} argument${count === 1 ? '' : 's'}, got ${given.length}.`,
  )
}

const allSizes = [2, 3, 4]

/** Maps a method's name to its composition. Each takes a vector; `rem` and `copy` also take a number. */
export const vectorMethods: Readonly<
  Record<string, (x: Operand, ...others: unknown[]) => Expression>
> = {
  copy(x, ...others) {
    checkCount('copy', others, [0])
    return (x.session as Session).copyOf(x)
  },
  /** The result has the sign of x, as JavaScript's `%` has. */
  rem(x, ...by) {
    checkCount('rem', by, [1, shapeOf(x)[1]])
    const whole = methodsOf(methodsOf(x.div!(...by)).trunc!())
    return x.sub!(whole.mult!(...by))
  },
  heading(v, ...others) {
    checkCount('heading', others, [0])
    checkVector(v, 'heading', allSizes)
    const { x, y } = v as unknown as Record<'x' | 'y', Operand>
    return y.atan!(x)
  },
  limit(v, ...given) {
    checkCount('limit', given, [1])
    checkVector(v, 'limit', allSizes)
    const most = operandOf(v, 'limit', given[0])
    // A limit of 0 makes 0 of a zero vector, too.
    return v.mult!(most.div!(methodsOf(most.max!(v.length!())).max!(1e-30)))
  },
  setMag(v, ...given) {
    checkCount('setMag', given, [1])
    checkVector(v, 'setMag', allSizes)
    return methodsOf(v.normalize!()).mult!(operandOf(v, 'setMag', given[0]))
  },
  /** p5 gives the angle the sign of the z of the cross product. */
  angleBetween(a, ...given) {
    checkCount('angleBetween', given, [1])
    const rows = checkVector(a, 'angleBetween', [2, 3])
    const b = operandOf(a, 'angleBetween', given[0])
    const cosine = a.dot!(b)
    if (rows === 2) {
      // The z of the cross product.
      const { yx } = b as unknown as { yx: Operand }
      return methodsOf(a.dot!(yx.mult!(1, -1))).atan!(cosine)
    }
    const turn = methodsOf(a.cross!(b))
    const z = methodsOf(partsOf(turn)[2]!)
    const angle = methodsOf(methodsOf(turn.length!()).atan!(cosine))
    return methodsOf(z.lt!(0)).ifElse!(angle.neg!(), angle)
  },
}

/** A vec2 turned, as p5 turns it. */
export function rotated(v: Expression, ...given: unknown[]): Expression {
  checkCount('rotate', given, [1])
  const angle = operandOf(v, 'rotate', given[0])
  const sine = methodsOf(angle.sin!())
  const { yx } = v as unknown as { yx: Operand }
  return methodsOf(methodsOf(v).mult!(angle.cos!())).add!(yx.mult!(sine.neg!(), sine))
}

export const isVec2 = (x: Expression) => shapeOf(x).join() === '1,2'

const letters = ['x', 'y', 'z', 'w'] as const

/** The components of a vector, in a list of JavaScript's. */
export function partsOf(v: Expression): Expression[] {
  const rows = checkVector(v, 'array', allSizes)
  const parts = v as unknown as Record<string, Expression>
  return letters.slice(0, rows).map((letter) => parts[letter]!)
}
