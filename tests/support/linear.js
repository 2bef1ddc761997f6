// Operations on vectors (arrays of numbers) and matrices (arrays of rows) in double precision, independent of warpjet.

export const isMatrix = (x) => Array.isArray(x?.[0])
/** Applies a function to each component. */
const mapComponents = (f, ...values) =>
  Array.isArray(values[0])
    ? values[0].map((_, i) => mapComponents(f, ...values.map((v) => v[i])))
    : f(...values)
export const scale = (x, factor) => mapComponents((number) => number * factor, x)

export const add = (a, b) => mapComponents((x, y) => x + y, a, b)
export const subtract = (a, b) => mapComponents((x, y) => x - y, a, b)
export const dot = (a, b) => a.reduce((total, x, i) => total + x * b[i], 0)
export const transpose = (m) => m[0].map((_, i) => m.map((row) => row[i]))
const identity = (n) =>
  Array.from({ length: n }, (_, i) => Array.from({ length: n }, (_, j) => +(i === j)))

export function times(a, b) {
  if (typeof a === 'number') return scale(b, a)
  if (typeof b === 'number') return scale(a, b)
  if (!isMatrix(a))
    throw new Error('expected a matrix or a number, got a vector times a vector or a matrix')
  return isMatrix(b)
    ? a.map((row) => transpose(b).map((column) => dot(row, column)))
    : a.map((row) => dot(row, b))
}

export const cross = (a, b) =>
  [0, 1, 2].map((i) => a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])

/** Returns the determinant and the inverse. Unlike warpjet, which uses minors, this is Gauss-Jordan elimination with pivoting. */
export function invert(m) {
  const n = m.length
  const rows = m.map((row, i) => [...row, ...identity(n)[i]])
  let det = 1
  for (let i = 0; i < n; i++) {
    const best = rows
      .slice(i)
      .reduce((max, row, k) => (Math.abs(row[i]) > Math.abs(rows[max][i]) ? i + k : max), i)
    if (best !== i) [rows[i], rows[best], det] = [rows[best], rows[i], -det]
    const pivot = rows[i][i]
    det *= pivot
    rows[i] = scale(rows[i], 1 / pivot)
    for (let k = 0; k < n; k++) if (k !== i) rows[k] = subtract(rows[k], scale(rows[i], rows[k][i]))
  }
  return { det, inverse: rows.map((row) => row.slice(n)) }
}
