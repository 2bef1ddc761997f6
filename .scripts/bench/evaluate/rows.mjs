// The warps that `npm run bench -- evaluate` measures, and the same warps with normals written by hand in JavaScript. A function by hand
// takes the vertices as { positions, normals }, the time, and the arrays `out` into which it writes the warped vertices.
import { stackedSines, stress } from '../../../tests/warps/stress.js'

const NODES_PER_SINE = 5
const { sin, cos, sqrt } = Math

/** Writes the warped normal, cof(M) n, normalized. `m` is the Jacobian matrix M of the warped position, in column-major order. */
function transformNormal(m, normals, i, out) {
  const [a, b, c, d, e, f, g, h, k] = m
  const [nx, ny, nz] = [normals[i], normals[i + 1], normals[i + 2]]
  const x = (e * k - f * h) * nx + (h * c - k * b) * ny + (b * f - c * e) * nz
  const y = (f * g - d * k) * nx + (k * a - g * c) * ny + (c * d - a * f) * nz
  const z = (d * h - e * g) * nx + (g * b - h * a) * ny + (a * e - b * d) * nz
  const length = sqrt(x * x + y * y + z * z)
  out[i] = x / length
  out[i + 1] = y / length
  out[i + 2] = z / length
}

/** Rotates about the axis through (0, 0, -500) along x, like `twist` of tests/warps/stress.js. */
function applyTwist({ positions, normals }, millis, out) {
  for (let i = 0; i < positions.length; i += 3) {
    const [x, y, z] = [positions[i], positions[i + 1], positions[i + 2] + 500]
    const angle = 0.02 * x + millis / 1000
    const c = cos(angle)
    const s = sin(angle)
    const movedY = y * c - z * s
    const movedZ = y * s + z * c
    out.positions[i] = x
    out.positions[i + 1] = movedY
    out.positions[i + 2] = movedZ - 500
    // The first column of the Jacobian matrix is (1, -0.02 movedZ, 0.02 movedY), the others are those of the rotation.
    const [nx, ny, nz] = [normals[i], normals[i + 1], normals[i + 2]]
    const ty = c * ny - s * nz
    const tz = s * ny + c * nz
    const tx = nx + 0.02 * (movedZ * ty - movedY * tz)
    const length = sqrt(tx * tx + ty * ty + tz * tz)
    out.normals[i] = tx / length
    out.normals[i + 1] = ty / length
    out.normals[i + 2] = tz / length
  }
}

/** Returns the function by hand for a sum of waves. */
function createSines(waves) {
  const m = new Float64Array(9)
  const moved = new Float64Array(3)
  return ({ positions, normals }, millis, out) => {
    for (let i = 0; i < positions.length; i += 3) {
      m.fill(0)
      for (let k = 0; k < 3; k++) {
        moved[k] = positions[i + k]
        m[4 * k] = 1
      }
      for (const { component, coordinate, frequency, speed, amplitude } of waves) {
        const angle = frequency * positions[i + coordinate] + speed * millis
        const scale = amplitude / waves.length
        moved[component] += scale * sin(angle)
        m[3 * coordinate + component] += scale * frequency * cos(angle)
      }
      out.positions.set(moved, i)
      transformNormal(m, normals, i, out.normals)
    }
  }
}

const stackSines = (nodes) => {
  const { warp, waves } = stackedSines(nodes / NODES_PER_SINE)
  return { warp, byHand: createSines(waves) }
}

/** Maps each name → { warp, byHand }. */
export const warps = {
  twist: { warp: stress.find(({ name }) => name === 'twist').warp, byHand: applyTwist },
  '150 nodes': stackSines(150),
  '1,500 nodes': stackSines(1500),
  '3,000 nodes': stackSines(3000),
}

export const rows = Object.keys(warps).flatMap((name) => [
  { name, vertices: 14_000, rounds: 9 },
  { name, vertices: 500_000, rounds: 3 },
])
