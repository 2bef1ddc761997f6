// What p5 documents its shapes to be, as smooth surfaces in double, each beside the code that draws it and, for what
// is built, that which is to be run before, and keeps it in `warps`. `sides` gives places, normals and uvs by two
// parameters, and which side a vertex is on, and where; `edges` are where the second leaves the first without a
// slope. `grain` says how a warp's offset is sized for the shape.
import * as m from './matrix.js'

const { PI, sin, cos, hypot } = Math

/** The size that shapes are drawn at, in pixels. */
export const R = 150

/** One side, whose parameters are u and v themselves. */
const byUv = (at, edges = []) => [
  { at: (u, v) => ({ ...at(u, v), uv: [u, v] }), of: (_, __, [u, v]) => [u, v], edges },
]

const ball = ([a, b, c]) =>
  byUv(
    (u, v) => {
      const [theta, phi] = [2 * PI * u, PI * v - PI / 2]
      const q = [cos(phi) * sin(theta), sin(phi), cos(phi) * cos(theta)]
      return { p: [a * q[0], b * q[1], c * q[2]], n: [q[0] / a, q[1] / b, q[2] / c] }
    },
    [0, 1],
  )

const ring = (size) =>
  byUv((u, v) => {
    const [theta, phi] = [2 * PI * u, 2 * PI * v]
    const r = 1 + 0.3 * cos(phi)
    return {
      p: [r * cos(theta), r * sin(theta), 0.3 * sin(phi)].map((x) => size * x),
      n: [cos(phi) * cos(theta), cos(phi) * sin(theta), sin(phi)].map((x) => x / size),
    }
  })

/** A side that gets narrower, and caps, whose second parameter is the radius. */
const pillar = (size, taper) => {
  const tilt = m.normalize([1, taper, 0])
  const side = {
    at: (u, v) => {
      const [theta, r] = [2 * PI * u, 1 - taper * v]
      return {
        p: [r * sin(theta), v - 0.5, r * cos(theta)].map((x) => size * x),
        n: [tilt[0] * sin(theta), tilt[1], tilt[0] * cos(theta)].map((x) => x / size),
        uv: [u, v],
      }
    },
    of: (_, n, [u, v]) => Math.abs(n[1]) < 0.9 && [u, v],
    edges: taper ? [1] : [],
  }
  const cap = (y) => ({
    at: (u, r) => ({
      p: [r * sin(2 * PI * u), y, r * cos(2 * PI * u)].map((x) => size * x),
      n: [0, (2 * y) / size, 0],
      uv: [u, y + 0.5],
    }),
    of: (p, n, [u]) => n[1] * y > 0.45 && [u, hypot(p[0], p[2]) / size],
    edges: [0],
  })
  return [side, cap(-0.5), cap(0.5)]
}

/**
 * p5 keeps no trace of what it was built of, so that its poles have no more than their triangles; and it leaves the
 * normals as long as the scale of each shape makes them.
 */
const built = (name, code, sides) => ({
  isBuilt: true,
  setup: `warps.${name} = buildGeometry(() => { ${code} })`,
  code: `model(warps.${name})`,
  sides,
  grain: { height: R, length: R, normals: R },
})

/**
 * p5 scales its own shapes, of size 1, to the `scale` of the draw call; what is built has its size in itself.
 * `height` multiplies an offset, and `length` divides positions in it, and `normals` makes normals of unit length.
 * Shapes without `sides` are flat.
 */
export const surfaces = {
  sphere: { code: `sphere(${R})`, sides: ball([1, 1, 1]), scale: [R, R, R] },
  ellipsoid: {
    code: `ellipsoid(${R}, ${0.8 * R}, ${0.6 * R})`,
    sides: ball([1, 1, 1]),
    scale: [R, 0.8 * R, 0.6 * R],
  },
  torus: { code: `torus(${R}, ${0.3 * R})`, sides: ring(1), scale: [R, R, R] },
  cylinder: { code: `cylinder(${R}, ${R})`, sides: pillar(1, 0), scale: [R, R, R] },
  cone: { code: `cone(${R}, ${R})`, sides: pillar(1, 1), scale: [R, R, R] },
  box: { code: `box(${R})`, scale: [R, R, R] },
  plane: {
    code: 'plane(400, 260, 50, 50)',
    scale: [400, 260, 1],
    grain: { height: R, length: 1, normals: 1 },
  },
  'a built sphere': built('ball', `sphere(${R})`, ball([R, R, R])),
  'a built ellipsoid': built(
    'egg',
    `ellipsoid(${R}, ${0.8 * R}, ${0.6 * R})`,
    ball([R, 0.8 * R, 0.6 * R]),
  ),
  'a built torus': built('ring', `torus(${R}, ${0.3 * R})`, ring(R)),
  'a built cylinder': built('pillar', `cylinder(${R}, ${R})`, pillar(R, 0)),
  'a built box': built('crate', `box(${R})`),
}
