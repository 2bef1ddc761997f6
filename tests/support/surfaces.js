// Surfaces defined by formulas, and the expected results of warps on them: an oracle in double precision that does not use derivatives of
// the warp.
import { cross, dot, normalize } from './browser/matrix.js'

const { sin, cos, PI } = Math

/**
 * Each returns, at u and v from 0 to 1, { position, normal, shape, uGradient, vGradient }: `shape` is the derivative of the
 * normal, by rows, from the principal curvatures (do Carmo, Differential Geometry of Curves and Surfaces, section 3.3).
 */
export const surfaces = {
  sphere(u, v, radius = 1.2) {
    const [a, b] = [2 * PI * u, PI * v]
    const normal = [sin(b) * cos(a), -cos(b), -sin(b) * sin(a)]
    const east = [-sin(a), 0, -cos(a)]
    const north = [cos(b) * cos(a), sin(b), -cos(b) * sin(a)]
    return {
      position: normal.map((x) => radius * x),
      normal,
      shape: shapeOf([east, 1 / radius], [north, 1 / radius]),
      // There is none at the poles.
      uGradient: east.map((x) => (sin(b) > 1e-9 ? x / (2 * PI * radius * sin(b)) : 0)),
      vGradient: north.map((x) => x / (PI * radius)),
    }
  },
  torus(u, v, big = 1, small = 0.4) {
    const [a, b] = [2 * PI * u, 2 * PI * v]
    const normal = [cos(a) * cos(b), sin(a) * cos(b), sin(b)]
    const ring = big + small * cos(b)
    const along = [-sin(a), cos(a), 0]
    const around = [-cos(a) * sin(b), -sin(a) * sin(b), cos(b)]
    return {
      position: [ring * cos(a), ring * sin(a), small * sin(b)],
      normal,
      shape: shapeOf([along, cos(b) / ring], [around, 1 / small]),
      uGradient: along.map((x) => x / (2 * PI * ring)),
      vGradient: around.map((x) => x / (2 * PI * small)),
    }
  },
}

const shapeOf = (...parts) =>
  [0, 1, 2].map((i) =>
    [0, 1, 2].map((k) => parts.reduce((sum, [t, curvature]) => sum + curvature * t[i] * t[k], 0)),
  )

/** Makes a mesh of a surface; `exact` has its exact derivatives, from the formula. */
export function surfaceMesh(surface, columns, rows) {
  const mesh = { positions: [], normals: [], uvs: [], indices: [] }
  const names = [
    'normalXGradients',
    'normalYGradients',
    'normalZGradients',
    'uGradients',
    'vGradients',
  ]
  const exact = Object.fromEntries(names.map((name) => [name, []]))
  for (let j = 0; j <= rows; j++)
    for (let i = 0; i <= columns; i++) {
      const [u, v] = [i / columns, j / rows]
      const { position, normal, shape, uGradient, vGradient } = surface(u, v)
      mesh.positions.push(...position)
      mesh.normals.push(...normal)
      mesh.uvs.push(u, v)
      ;[...shape, uGradient, vGradient].forEach((gradient, k) => exact[names[k]].push(...gradient))
      if (i === columns || j === rows) continue
      const a = j * (columns + 1) + i
      const c = a + columns + 1
      mesh.indices.push(a, a + 1, c + 1, a, c + 1, c)
    }
  return { mesh, exact }
}

/** Returns the normal of the surface moved by `offset(position, normal, uv)`, from finite differences of fourth order; `null` at a pole. */
export function movedNormal(surface, offset, u, v) {
  const at = (u, v) => {
    const { position, normal } = surface(u, v)
    return offset(position, normal, [u, v]).map((x, k) => position[k] + x)
  }
  const slope = (du, dv) => {
    const [d2, d1, u1, u2] = [-2, -1, 1, 2].map((s) => at(u + s * du, v + s * dv))
    return d2.map((_, k) => (8 * (u1[k] - d1[k]) - (u2[k] - d2[k])) / 12e-4)
  }
  const normal = cross(slope(1e-4, 0), slope(0, 1e-4))
  const resting = surface(u, v)
  const rest = cross(
    ...[
      [1e-4, 0],
      [0, 1e-4],
    ].map(([du, dv]) => surface(u + du, v + dv).position.map((x, k) => x - resting.position[k])),
  )
  const side = Math.sign(dot(rest, resting.normal))
  return Math.hypot(...rest) < 1e-12 ? null : normalize(normal.map((x) => side * x))
}
