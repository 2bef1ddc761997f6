/** A sphere for checking a warp: positions, normals and texture coordinates, with the gradients of normals and texture coordinates. */

/** The size of the grid of points. */
export const columns = 96
export const rows = 48

/** The step of finite differences in radians. */
const STEP = 2e-3

const scale = (vector, factor) => vector.map((value) => value * factor)

function createPoint(radius, u, v) {
  const [longitude, latitude] = [2 * Math.PI * u, Math.PI * v]
  const [sinU, cosU] = [Math.sin(longitude), Math.cos(longitude)]
  const [sinV, cosV] = [Math.sin(latitude), Math.cos(latitude)]
  const normal = [sinV * sinU, -cosV, sinV * cosU]
  /** Returns the gradient of a coordinate of the normal. */
  const gradient = (axis) => {
    const unit = [0, 1, 2].map((i) => Number(i === axis))
    return unit.map((value, i) => (value - normal[axis] * normal[i]) / radius)
  }
  return {
    positions: scale(normal, radius),
    normals: normal,
    uvs: [u, v],
    colors: [1, 1, 1, 1],
    normalXGradients: gradient(0),
    normalYGradients: gradient(1),
    normalZGradients: gradient(2),
    uGradients: scale([cosU, 0, -sinU], 1 / (2 * Math.PI * radius * sinV)),
    vGradients: scale([cosV * sinU, sinV, cosV * cosU], 1 / (Math.PI * radius)),
  }
}

/** Makes five points per grid point: itself, two neighbours along u, two along v. Avoids the poles, where u is undefined. */
export function spherePoints(radius) {
  const points = []
  const [du, dv] = [STEP / (2 * Math.PI), STEP / Math.PI]
  for (let j = 0; j < rows; j++)
    for (let i = 0; i < columns; i++) {
      const [u, v] = [(i + 0.5) / columns, (j + 0.5) / rows]
      points.push(createPoint(radius, u, v))
      for (const [x, y] of [
        [-du, 0],
        [du, 0],
        [0, -dv],
        [0, dv],
      ])
        points.push(createPoint(radius, u + x, v + y))
    }
  const mesh = {}
  for (const name of Object.keys(points[0]))
    mesh[name] = Float32Array.from(points.flatMap((point) => point[name]))
  return mesh
}

const difference = (positions, a, b) =>
  [0, 1, 2].map((i) => positions[3 * a + i] - positions[3 * b + i])
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x]

/**
 * Returns the angles in radians between a warped sphere's normals and those of finite differences, one per grid point; NaN if
 * one of the two normals is zero.
 */
export function normalErrors({ positions, normals }) {
  const count = positions.length / 15
  return Float32Array.from({ length: count }, (_, k) => {
    const at = 5 * k
    const along = difference(positions, at + 2, at + 1)
    // v increases with p5's y, which points down, so the cross product points outwards.
    const expected = cross(along, difference(positions, at + 4, at + 3))
    const normal = [...normals.subarray(3 * at, 3 * at + 3)]
    const sine = Math.hypot(...cross(expected, normal))
    const cosine = expected.reduce((sum, value, i) => sum + value * normal[i], 0)
    return sine === 0 && cosine === 0 ? NaN : Math.atan2(sine, cosine)
  })
}
