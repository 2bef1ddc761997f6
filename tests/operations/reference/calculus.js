// Derivatives as expressions. `reference` is the derivative, worked out by hand. The tests also compare the derivatives of these results
// with differences.
// scalars.js describes rows.
import { product } from './matrices.js'
import { span } from './row.js'
import { sine } from './tolerances.js'

const { sin, cos } = Math
const number = span(-2, 2, { at: [0] })
const builderOnly = { only: 'builder', domains: [number] }

export const calculus = [
  {
    ...builderOnly,
    name: 'derivative',
    note: 'of x² sin(xy) with respect to x',
    shapes: [[1, 1]],
    tolerance: sine,
    build: ({ call }, x, y) => call(x.mult(x).mult(x.mult(y).sin()), x),
    reference: ([x], [y]) => [2 * x * sin(x * y) + x * x * y * cos(x * y)],
  },
  {
    ...builderOnly,
    name: 'derivative',
    note: 'twice, of x³ y² with respect to x and y',
    shapes: [[1, 1]],
    build: ({ call }, x, y) => call(call(x.pow(3).mult(y.pow(2)), x), y),
    reference: ([x], [y]) => [6 * x * x * y],
  },
  {
    ...builderOnly,
    name: 'derivative',
    note: 'three times, of sin(2x) with respect to x',
    shapes: [[1]],
    tolerance: sine,
    build: ({ call }, x) => call(call(call(x.mult(2).sin(), x), x), x),
    reference: ([x]) => [-8 * cos(2 * x)],
  },
  {
    ...builderOnly,
    name: 'derivative',
    note: 'of v times v.y with respect to v.y',
    shapes: [[3]],
    result: () => 3,
    build: ({ call }, v) => call(v.mult(v.y()), v.y()),
    reference: ([x, y, z]) => [x, 2 * y, z],
  },
  {
    ...builderOnly,
    name: 'derivative',
    note: 'of a product of matrices with respect to an entry of one',
    shapes: [['mat2', 'mat2']],
    result: () => 'mat2',
    build: ({ call }, m, n) => call(m.mult(n).mult(m), m.column(1).x()),
    // With E, which is 1 in row 0 and column 1 and otherwise 0, the derivative is E n m + m n E.
    reference(m, n) {
      const e = [0, 0, 1, 0]
      const right = product(product(m, n), e)
      return product(product(e, n), m).map((entry, i) => entry + right[i])
    },
  },
  {
    ...builderOnly,
    name: 'gradient',
    note: 'of x y² + x',
    shapes: [[2]],
    result: () => 2,
    build: ({ call }, v) => call(v.x().mult(v.y(), v.y()).add(v.x()), v),
    reference: ([x, y]) => [y * y + 1, 2 * x * y],
  },
  {
    ...builderOnly,
    name: 'gradient',
    note: 'of 1 / length',
    shapes: [[3]],
    domains: [(random) => 0.4 + 2 * random()],
    build: ({ glsl, call }, v) => call(glsl.div(1, v.length()), v),
    reference: (v) => v.map((x) => -x / Math.hypot(...v) ** 3),
  },
  {
    ...builderOnly,
    name: 'gradient',
    note: 'of x y z w',
    shapes: [[4]],
    build: ({ call }, v) => call(v.x().mult(v.y(), v.z(), v.w()), v),
    reference: ([x, y, z, w]) => [y * z * w, x * z * w, x * y * w, x * y * z],
  },
  {
    ...builderOnly,
    name: 'jacobian',
    note: 'of (x² y, x + 3 y)',
    shapes: [[2]],
    result: () => 'mat2',
    build: ({ glsl, call }, v) =>
      call(glsl.vec2(v.x().mult(v.x(), v.y()), v.x().add(v.y().mult(3))), v),
    reference: ([x, y]) => [2 * x * y, 1, x * x, 3],
  },
  {
    ...builderOnly,
    name: 'jacobian',
    note: 'of (y z, z² x, x y²)',
    shapes: [[3]],
    result: () => 'mat3',
    build({ glsl, call }, v) {
      const [x, y, z] = [v.x(), v.y(), v.z()]
      return call(glsl.vec3(y.mult(z), z.mult(z, x), x.mult(y, y)), v)
    },
    // A column for each of x, y and z.
    reference: ([x, y, z]) => [0, z * z, y * y, z, 0, 2 * x * y, y, 2 * x * z, 0],
  },
  {
    ...builderOnly,
    name: 'jacobian',
    note: 'of v times sin(w)',
    shapes: [[4]],
    result: () => 'mat4',
    tolerance: sine,
    build: ({ call }, v) => call(v.mult(v.w().sin()), v),
    reference: (v) => {
      const [s, c] = [sin(v[3]), cos(v[3])]
      return [0, 1, 2, 3].flatMap((column) =>
        v.map((x, row) => (row === column ? s : 0) + (column === 3 ? x * c : 0)),
      )
    },
  },
]
