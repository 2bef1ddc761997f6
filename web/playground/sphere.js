/** A sphere by its texture coordinates, with how its normal and they vary over it, for checks of a warp. */
export const across = 96
export const down = 48

/** Radians between a point and its neighbours for differences. */
const STEP = 2e-3

const scaled = (vector, factor) => vector.map((value) => value * factor)

function place(radius, u, v) {
  const [longitude, latitude] = [2 * Math.PI * u, Math.PI * v]
  const [sinU, cosU] = [Math.sin(longitude), Math.cos(longitude)]
  const [sinV, cosV] = [Math.sin(latitude), Math.cos(latitude)]
  const normal = [sinV * sinU, -cosV, sinV * cosU]
  const change = (axis) => {
    const unit = [0, 1, 2].map((i) => Number(i === axis))
    return unit.map((value, i) => (value - normal[axis] * normal[i]) / radius)
  }
  return {
    positions: scaled(normal, radius),
    normals: normal,
    uvs: [u, v],
    colors: [1, 1, 1, 1],
    normalXGradients: change(0),
    normalYGradients: change(1),
    normalZGradients: change(2),
    uGradients: scaled([cosU, 0, -sinU], 1 / (2 * Math.PI * radius * sinV)),
    vGradients: scaled([cosV * sinU, sinV, cosV * cosU], 1 / (Math.PI * radius)),
  }
}

/** Five points for each: itself, two beside it along u, two along v. Without the poles, where u means nothing. */
export function spherePoints(radius) {
  const points = []
  const [du, dv] = [STEP / (2 * Math.PI), STEP / Math.PI]
  for (let j = 0; j < down; j++)
    for (let i = 0; i < across; i++) {
      const [u, v] = [(i + 0.5) / across, (j + 0.5) / down]
      points.push(place(radius, u, v))
      for (const [x, y] of [
        [-du, 0],
        [du, 0],
        [0, -dv],
        [0, dv],
      ])
        points.push(place(radius, u + x, v + y))
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
 * Of a warped sphere, the angles in radians between its normals and those of differences, one for each point of the grid; NaN
 * where one of both has none.
 */
export function normalErrors({ positions, normals }) {
  const count = positions.length / 15
  return Float32Array.from({ length: count }, (_, k) => {
    const at = 5 * k
    const along = difference(positions, at + 2, at + 1)
    // Downwards in v is upwards in space, so that this is outwards.
    const expected = cross(along, difference(positions, at + 4, at + 3))
    const normal = [...normals.subarray(3 * at, 3 * at + 3)]
    const sine = Math.hypot(...cross(expected, normal))
    const cosine = expected.reduce((sum, value, i) => sum + value * normal[i], 0)
    return sine === 0 && cosine === 0 ? NaN : Math.atan2(sine, cosine)
  })
}
