// Three-dimensional simplex noise in double precision, with the hash and the gradients of the common implementation for GLSL without
// integers.
const { abs, floor, fround, max, sign } = Math
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
const mod = (x, y) => x - y * floor(x / y)
const scramble = (x) => mod((x * 34 + 1) * x, 289)

const step = fround(2 * fround(0.142857142857))
const start = fround(fround(0.5 * fround(0.142857142857)) - 1)

/**
 * Returns one of 49 directions on an octahedron, of about length 1. Rounds like float32, which decides on which face a point at an edge is.
 */
function gradient(hash) {
  const j = mod(hash, 49)
  const [x, y] = [floor(j / 7), mod(j, 7)].map((k) => fround(fround(k * step) + start))
  const z = fround(fround(1 - abs(x)) - abs(y))
  const folded = z > 0 ? [x, y, z] : [x - sign(x), y - sign(y), z]
  // Like the shaders, approximates 1 / sqrt linearly.
  const scale = 1.79284291400159 - 0.85373472095314 * dot(folded, folded)
  return folded.map((each) => each * scale)
}

export function simplex(p) {
  const skew = (p[0] + p[1] + p[2]) / 3
  const cell = p.map((x) => floor(x + skew))
  const unskew = (cell[0] + cell[1] + cell[2]) / 6
  const first = p.map((x, k) => x - cell[k] + unskew)
  // The path to the opposite corner takes the largest component first.
  const order = [0, 1, 2].sort((a, b) => first[b] - first[a])
  let sum = 0
  const corner = [0, 0, 0]
  for (let step = 0; step < 4; step++) {
    const fromCorner = first.map((x, k) => x - corner[k] + step / 6)
    const [i, j, k] = cell.map((x, axis) => mod(x, 289) + corner[axis])
    const falloff = max(0.6 - dot(fromCorner, fromCorner), 0) ** 4
    sum += falloff * dot(gradient(scramble(scramble(scramble(k) + j) + i)), fromCorner)
    if (step < 3) corner[order[step]] = 1
  }
  return 42 * sum
}
