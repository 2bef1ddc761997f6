// Methods of p5.Vector that are no operation of their own. Expressions never change, so each gives a new one.
import { describeShape } from '../../errors/describe.js'
import { Place } from '../../options/place.js'
import { type Expression, toExpression } from './expression.js'
import type { Session } from './session.js'

type Methods = Record<string, (...operands: unknown[]) => Expression>
type Operand = Expression & Methods

const methodsOf = (expression: Expression) => expression as Operand

const shapeOf = (x: Expression) => x.session.shapeOf(x)

/** The operand of a method as an expression. */
const operandOf = (x: Expression, place: Place, value: unknown) =>
  methodsOf(toExpression(x.session, value, place, 1))

function rejectOtherCount(place: Place, given: readonly unknown[], counts: readonly number[]) {
  const [count] = counts
  if (!counts.includes(given.length))
    throw place.expected(`${count} argument${count === 1 ? '' : 's'}`, `${given.length}`)
}

/** The number of components of a vector, which must be one of these sizes. */
function rowsOf(x: Expression, place: Place, sizes: readonly number[]) {
  const [columns, rows] = shapeOf(x)
  if (columns === 1 && sizes.includes(rows)) return rows
  throw place.expected(
    sizes.map((size) => `a vec${size}`).join(' or '),
    describeShape([columns, rows]),
  )
}

type Composition = (x: Operand, ...others: unknown[]) => Expression

const allSizes = [2, 3, 4]

/** A method of vectors that takes one operand, or none. */
function ofVector(
  name: string,
  count: 0 | 1,
  compose: (v: Operand, operand: Operand, rows: number) => Expression,
  sizes = allSizes,
): Composition {
  const place = new Place(name)
  return (v, ...given) => {
    rejectOtherCount(place, given, [count])
    const rows = rowsOf(v, place, sizes)
    return compose(v, count ? operandOf(v, place, given[0]) : v, rows)
  }
}

/** Maps a method's name to its composition. Each takes a vector; `rem` and `copy` also take a number. */
export const vectorMethods: Readonly<Record<string, Composition>> = {
  copy(x, ...others) {
    rejectOtherCount(new Place('copy'), others, [0])
    return (x.session as Session).copyOf(x)
  },
  /** The result has the sign of x, as JavaScript's `%` has. */
  rem(x, ...by) {
    rejectOtherCount(new Place('rem'), by, [1, shapeOf(x)[1]])
    const whole = methodsOf(methodsOf(x.div!(...by)).trunc!())
    return x.sub!(whole.mult!(...by))
  },
  heading: ofVector('heading', 0, (v) => {
    const { x, y } = v as unknown as Record<'x' | 'y', Operand>
    return y.atan!(x)
  }),
  // A limit of 0 makes 0 of a zero vector, too.
  limit: ofVector('limit', 1, (v, max) =>
    v.mult!(max.div!(methodsOf(max.max!(v.length!())).max!(1e-30))),
  ),
  setMag: ofVector('setMag', 1, (v, length) => methodsOf(v.normalize!()).mult!(length)),
  /** p5 gives the angle the sign of the z of the cross product. */
  angleBetween: ofVector(
    'angleBetween',
    1,
    (a, b, rows) => {
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
    [2, 3],
  ),
}

const rotate = new Place('rotate')

/** A vec2 turned, as p5 turns it. */
export function rotated(v: Expression, ...given: unknown[]): Expression {
  rejectOtherCount(rotate, given, [1])
  const angle = operandOf(v, rotate, given[0])
  const sine = methodsOf(angle.sin!())
  const { yx } = v as unknown as { yx: Operand }
  return methodsOf(methodsOf(v).mult!(angle.cos!())).add!(yx.mult!(sine.neg!(), sine))
}

export const isVec2 = (x: Expression) => shapeOf(x).join() === '1,2'

const letters = ['x', 'y', 'z', 'w'] as const

const array = new Place('array')

/** The components of a vector, in a list of JavaScript's. */
export function partsOf(v: Expression): Expression[] {
  const rows = rowsOf(v, array, allSizes)
  const parts = v as unknown as Record<string, Expression>
  return letters.slice(0, rows).map((letter) => parts[letter]!)
}
