// Methods of p5.Vector that are composed of operations. Expressions never change, so each method returns a new one.
import { describeShape } from '../../errors/describe.js'
import { Place } from '../../options/place.js'
import { toExpression, type Expression } from './expression.js'
import type { Session } from './session.js'

type Methods = Record<string, (...operands: unknown[]) => Expression>
type Operand = Expression & Methods

const methodsOf = (expression: Expression) => expression as Operand

const shapeOf = (x: Expression) => x.session.shapeOf(x)

/** Converts the operand of a method to an expression. */
const operandOf = (x: Expression, place: Place, value: unknown) =>
  methodsOf(toExpression(x.session, value, place, 1))

function rejectOtherCount(place: Place, given: readonly unknown[], counts: readonly number[]) {
  const [count] = counts
  if (!counts.includes(given.length))
    throw place.expected(`${count} argument${count === 1 ? '' : 's'}`, `${given.length}`)
}

/** Returns the number of components of a vector. Throws if this number is not one of `sizes`. */
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

/** Makes a method of vectors with one operand or none. */
function vectorMethod(
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
  rem(x, ...divisor) {
    rejectOtherCount(new Place('rem'), divisor, [1, shapeOf(x)[1]])
    const quotient = methodsOf(methodsOf(x.div!(...divisor)).trunc!())
    return x.sub!(quotient.mult!(...divisor))
  },
  heading: vectorMethod('heading', 0, (v) => {
    const { x, y } = v as unknown as Record<'x' | 'y', Operand>
    return y.atan!(x)
  }),
  // 1e-30 prevents 0 / 0 for a zero vector and a limit of 0.
  limit: vectorMethod('limit', 1, (v, max) =>
    v.mult!(max.div!(methodsOf(max.max!(v.length!())).max!(1e-30))),
  ),
  setMag: vectorMethod('setMag', 1, (v, length) => methodsOf(v.normalize!()).mult!(length)),
  /** The angle has the sign of the cross product's z, as in p5. */
  angleBetween: vectorMethod(
    'angleBetween',
    1,
    (a, b, rows) => {
      const cosine = a.dot!(b)
      if (rows === 2) {
        // The z of the cross product.
        const { yx } = b as unknown as { yx: Operand }
        return methodsOf(a.dot!(yx.mult!(1, -1))).atan!(cosine)
      }
      const normal = methodsOf(a.cross!(b))
      const z = methodsOf(componentsOf(normal)[2]!)
      const angle = methodsOf(methodsOf(normal.length!()).atan!(cosine))
      return methodsOf(z.lt!(0)).ifElse!(angle.neg!(), angle)
    },
    [2, 3],
  ),
}

const rotate = new Place('rotate')

/** Rotates a vec2, as p5 does. */
export function rotateVec2(v: Expression, ...given: unknown[]): Expression {
  rejectOtherCount(rotate, given, [1])
  const angle = operandOf(v, rotate, given[0])
  const sine = methodsOf(angle.sin!())
  const { yx } = v as unknown as { yx: Operand }
  return methodsOf(methodsOf(v).mult!(angle.cos!())).add!(yx.mult!(sine.neg!(), sine))
}

export const isVec2 = (x: Expression) => shapeOf(x).join() === '1,2'

const letters = ['x', 'y', 'z', 'w'] as const

const array = new Place('array')

/** Returns the components of a vector as an array. */
export function componentsOf(v: Expression): Expression[] {
  const rows = rowsOf(v, array, allSizes)
  const components = v as unknown as Record<string, Expression>
  return letters.slice(0, rows).map((letter) => components[letter]!)
}
