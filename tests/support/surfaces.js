// Surfaces defined by formulas, and the normals that warps should produce on them: an oracle in double precision that does not use
// derivatives of the warp.
import { cross, dot, normalize } from './browser/matrix.js'

const { sin, cos, PI } = Math

/**
 * Each function returns, at u and v from 0 to 1, { position, normal, shape, uGradient, vGradient }. `shape` has the rows of the derivative
 * of the normal, which is computed from the principal curvatures (do Carmo, Differential Geometry of Curves and Surfaces, section 3.3).
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
      // This gradient is undefined at the poles, where we return zero.
      uGradient: east.map((x) => (sin(b) > 1e-9 ? x / (2 * PI * radius * sin(b)) : 0)),
      vGradient: north.map((x) => x / (PI * radius)),
    }
  },
  torus(u, v, big = 1, small = 0.4) {
    const [a, b] = [2 * PI * u, 2 * PI * v]
    const normal = [cos(a) * cos(b), sin(a) * cos(b), sin(b)]
    const ring = big + small * cos(b)
    const alongRing = [-sin(a), cos(a), 0]
    const aroundTube = [-cos(a) * sin(b), -sin(a) * sin(b), cos(b)]
    return {
      position: [ring * cos(a), ring * sin(a), small * sin(b)],
      normal,
      shape: shapeOf([alongRing, cos(b) / ring], [aroundTube, 1 / small]),
      uGradient: alongRing.map((x) => x / (2 * PI * ring)),
      vGradient: aroundTube.map((x) => x / (2 * PI * small)),
    }
  },
}

/** Returns the derivative of the normal from pairs of a principal direction and its curvature. */
const shapeOf = (...directions) =>
  [0, 1, 2].map((i) =>
    [0, 1, 2].map((k) =>
      directions.reduce((sum, [t, curvature]) => sum + curvature * t[i] * t[k], 0),
    ),
  )

/** Makes a mesh of a surface. Returns { mesh, exact }; `exact` has the exact gradients of normal and uv, from the formula. */
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

/**
 * Returns the normal of the surface that `offset(position, normal, uv)` moves, from finite differences of fourth order; `null` at a pole.
 */
export function movedNormal(surface, offset, u, v) {
  const movedPoint = (u, v) => {
    const { position, normal } = surface(u, v)
    return offset(position, normal, [u, v]).map((x, k) => position[k] + x)
  }
  const slope = (du, dv) => {
    const [twoBefore, before, after, twoAfter] = [-2, -1, 1, 2].map((s) =>
      movedPoint(u + s * du, v + s * dv),
    )
    return before.map((_, k) => (8 * (after[k] - before[k]) - (twoAfter[k] - twoBefore[k])) / 12e-4)
  }
  const normal = cross(slope(1e-4, 0), slope(0, 1e-4))
  const original = surface(u, v)
  const originalNormal = cross(
    ...[
      [1e-4, 0],
      [0, 1e-4],
    ].map(([du, dv]) => surface(u + du, v + dv).position.map((x, k) => x - original.position[k])),
  )
  const side = Math.sign(dot(originalNormal, original.normal))
  return Math.hypot(...originalNormal) < 1e-12 ? null : normalize(normal.map((x) => side * x))
}
