// Matrices and vectors for oracles, in double precision: matrices of 4×4 as lists of rows, points and directions as [x, y, z].

export const product = (...matrices) =>
  matrices.reduce((a, b) =>
    a.map((row) => b[0].map((_, j) => row.reduce((sum, value, k) => sum + value * b[k][j], 0))),
  )

export const translation = (x, y, z) => [
  [1, 0, 0, x],
  [0, 1, 0, y],
  [0, 0, 1, z],
  [0, 0, 0, 1],
]

export const scaling = (x, y, z) => [
  [x, 0, 0, 0],
  [0, y, 0, 0],
  [0, 0, z, 0],
  [0, 0, 0, 1],
]

/** Rotates by `angle` radians from axis `from` towards axis `to` (0 = x, 1 = y, 2 = z); 0, 1 rotates about z. */
export function rotation(angle, from, to) {
  const matrix = translation(0, 0, 0)
  matrix[from][from] = matrix[to][to] = Math.cos(angle)
  matrix[to][from] = Math.sin(angle)
  matrix[from][to] = -Math.sin(angle)
  return matrix
}

/** Returns the matrix from world to view space, where the eye is the origin and looks along -z. */
export function lookAt(eye, center, up) {
  const z = normalize(subtract(eye, center))
  const x = normalize(cross(up, z))
  const axes = [x, cross(z, x), z].map((axis) => [...axis, -dot(axis, eye)])
  return [...axes, [0, 0, 0, 1]]
}

/** Converts a 3×3 matrix to a 4×4 matrix without translation. */
export const linear = (rows) => [...rows.map((row) => [...row, 0]), [0, 0, 0, 1]]

export const transformPoint = (matrix, p) => matrix.slice(0, 3).map((row) => dot(row, p) + row[3])

/** Returns the unit normal of a surface that `matrix` moves: the inverse transpose of its 3×3 part times `n`. */
export function transformNormal(matrix, n) {
  const [a, b, c] = matrix.slice(0, 3).map((row) => row.slice(0, 3))
  // The rows of the inverse transpose are b × c, c × a and a × b over the determinant.
  const determinant = dot(a, cross(b, c))
  return normalize([cross(b, c), cross(c, a), cross(a, b)].map((row) => dot(row, n) / determinant))
}

export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
export function normalize([x, y, z]) {
  const length = Math.hypot(x, y, z)
  return [x / length, y / length, z / length]
}
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
]

/** Returns the numbers of a matrix in column-major order, as WebGL takes them. */
export const columnMajor = (rows) => [0, 1, 2, 3].flatMap((i) => rows.map((row) => row[i]))
