// Matrices in column-major order, as in GLSL. scalars.js describes rows.
import { awayFromZero, span } from './row.js'
import { sine } from './tolerances.js'

const entry = span(-1.5, 1.5, { at: [0, 1] })
const sizes = [2, 3, 4]
const indices = (size) => [0, 1, 2, 3].slice(0, size)
const sizeOf = (matrix) => Math.sqrt(matrix.length)
const matrix = (size) => `mat${size}`

/** Returns the matrix of that size with the entries `f(row, column)`. */
const fill = (size, f) =>
  indices(size).flatMap((column) => indices(size).map((row) => f(row, column)))

const at = (m, row, column) => m[column * sizeOf(m) + row]
const rowOf = (m, row) => indices(sizeOf(m)).map((column) => at(m, row, column))
const columnOf = (m, column) => indices(sizeOf(m)).map((row) => at(m, row, column))
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0)
const norm = (list) => Math.sqrt(dot(list, list))
const transpose = (m) => fill(sizeOf(m), (row, column) => at(m, column, row))
export const product = (a, b) =>
  fill(sizeOf(a), (row, column) => dot(rowOf(a, row), columnOf(b, column)))
const timesVector = (m, v) => v.map((_, row) => dot(rowOf(m, row), v))
const vectorTimes = (v, m) => v.map((_, column) => dot(columnOf(m, column), v))
const byEntry = (f) => (a, b) => a.map((x, i) => f(x, b[b.length === 1 ? 0 : i]))

/** Computes the determinant by expansion along the first row. */
function determinant(m) {
  const size = sizeOf(m)
  if (size === 1) return m[0]
  return indices(size).reduce(
    (sum, column) =>
      sum + (column % 2 ? -1 : 1) * at(m, 0, column) * determinant(minor(m, 0, column)),
    0,
  )
}

/** Returns the minor without that row and column. */
const minor = (m, row, column) =>
  m.filter((_, i) => i % sizeOf(m) !== row && Math.floor(i / sizeOf(m)) !== column)

/** Computes the inverse by elimination with pivots, rather than by cofactors like the compiler. */
function inverse(m) {
  const size = sizeOf(m)
  const rows = indices(size).map((row) => [
    ...rowOf(m, row),
    ...indices(size).map((column) => (column === row ? 1 : 0)),
  ])
  for (const k of indices(size)) {
    const below = rows.slice(k)
    const pivot = below.reduce((best, row) => (Math.abs(row[k]) > Math.abs(best[k]) ? row : best))
    rows.splice(k, 0, ...rows.splice(rows.indexOf(pivot), 1))
    rows[k] = rows[k].map((x) => x / pivot[k])
    for (const other of indices(size))
      if (other !== k) {
        const factor = rows[other][k]
        rows[other] = rows[other].map((x, j) => x - factor * rows[k][j])
      }
  }
  return fill(size, (row, column) => rows[row][size + column])
}

const conditionNumber = (m) => [norm(m) * norm(inverse(m))]

/** For `adjust`: increases the diagonal of a matrix that is close to singular. */
const makeRegular = ([m]) => {
  const isClose = Math.abs(determinant(m)) < 0.2
  return [isClose ? m.map((x, i) => x + (i % (sizeOf(m) + 1) ? 0 : 3)) : m]
}

/** Computes a rotation by Rodrigues' formula, with a normalized axis. */
function rotation(axis, angle) {
  const [x, y, z] = axis.map((value) => value / norm(axis))
  const [c, s] = [Math.cos(angle), Math.sin(angle)]
  const rows = [
    [c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s],
    [y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s],
    [z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)],
  ]
  return fill(3, (row, column) => rows[row][column])
}

const forSizes = (row) => sizes.map((size) => ({ domains: [entry], ...row(size) }))

const products = forSizes((size) => ({
  name: 'mult',
  note: 'of matrices',
  shapes: [[matrix(size), matrix(size)]],
  result: ([shape]) => shape,
  reference: product,
})).concat(
  forSizes((size) => ({
    name: 'mult',
    note: 'matrix times vector',
    shapes: [[matrix(size), size]],
    result: () => size,
    reference: timesVector,
  })),
  forSizes((size) => ({
    name: 'mult',
    note: 'row vector times matrix',
    shapes: [[size, matrix(size)]],
    result: () => size,
    reference: vectorTimes,
  })),
  forSizes((size) => ({
    name: 'mult',
    note: 'matrix times number',
    shapes: [[matrix(size), 1]],
    result: ([shape]) => shape,
    reference: byEntry((x, factor) => x * factor),
  })),
  forSizes((size) => ({
    name: 'mult',
    note: 'number times matrix',
    shapes: [[1, matrix(size)]],
    result: ([, shape]) => shape,
    reference: ([factor], m) => m.map((x) => factor * x),
  })),
)

const byEntries = [
  ['add', byEntry((x, y) => x + y)],
  ['sub', byEntry((x, y) => x - y)],
].map(([name, reference]) => ({
  name,
  note: 'of matrices',
  shapes: sizes.map((size) => [matrix(size), matrix(size)]),
  result: ([shape]) => shape,
  domains: [entry],
  reference,
}))

/** Makes a row for an operation on a single matrix. */
const ofMatrix = (name, reference, more) => ({
  name,
  note: 'of a matrix',
  shapes: sizes.map((size) => [matrix(size)]),
  result: ([shape]) => shape,
  domains: [entry],
  reference,
  ...more,
})

/** Makes rows for m.column(i) or m.row(i), for every i. */
const columnOrRow = (name, reference) =>
  sizes.flatMap((size) =>
    indices(size).map((i) => ({
      name,
      note: `number ${i}`,
      shapes: [[matrix(size)]],
      result: () => size,
      domains: [entry],
      build: ({ call }, m) => call(m, i),
      reference: (m) => reference(m, i),
    })),
  )

const join = (...lists) => lists.flat()

const constructors = sizes.flatMap((size) => {
  const name = matrix(size)
  const row = (shapes, note, reference, more) => ({
    name,
    note,
    only: 'builder',
    shapes: [shapes],
    result: () => name,
    domains: [entry],
    reference,
    ...more,
  })
  return [
    row(Array(size).fill(size), 'of columns', join),
    row(Array(size * size).fill(1), 'of numbers', join),
    row([1], 'a diagonal', ([x]) => fill(size, (i, j) => (i === j ? x : 0))),
    row(Array(size).fill(size), 'of rows', (...rows) => transpose(rows.flat()), {
      name: `${name}Rows`,
    }),
  ]
})

const rotations = [
  ['rotateX', [1, 0, 0]],
  ['rotateY', [0, 1, 0]],
  ['rotateZ', [0, 0, 1]],
].map(([name, axis]) => ({
  name,
  shapes: [[1]],
  result: () => 'mat3',
  domains: [span(-7, 7, { at: [0] })],
  tolerance: sine,
  reference: ([angle]) => rotation(axis, angle),
}))

export const matrices = [
  ...constructors,
  ...products,
  {
    name: 'mult',
    note: 'two matrices and a vector, in one call',
    shapes: [['mat3', 'mat3', 3]],
    result: () => 3,
    domains: [entry],
    reference: (a, b, v) => timesVector(product(a, b), v),
  },
  ...byEntries,
  ofMatrix('neg', (m) => m.map((x) => -x)),
  ofMatrix(
    'div',
    byEntry((x, divisor) => x / divisor),
    {
      note: 'matrix by number',
      shapes: sizes.map((size) => [matrix(size), 1]),
      domains: [entry, awayFromZero(0.3, 2)],
    },
  ),
  ofMatrix('transpose', transpose),
  ofMatrix('determinant', (m) => [determinant(m)], { result: () => 1 }),
  ofMatrix('inverse', inverse, {
    adjust: makeRegular,
    sensitivity: {
      value: conditionNumber,
      derivative: conditionNumber,
      because: 'the condition number ‖m‖ ‖m⁻¹‖',
    },
  }),
  ...columnOrRow('column', columnOf),
  ...columnOrRow('row', rowOf),
  ...rotations,
  {
    name: 'rotate',
    shapes: [[3, 1]],
    result: () => 'mat3',
    domains: [span(-2, 2), span(-7, 7, { at: [0] })],
    adjust: ([axis, angle]) => [norm(axis) < 0.2 ? axis.map((x) => x + 1) : axis, angle],
    tolerance: sine,
    reference: (axis, [angle]) => rotation(axis, angle),
  },
]
