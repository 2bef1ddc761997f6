// The shapes of p5 as documented: smooth parametric surfaces in double. `code` draws a shape; `setup`, for shapes of buildGeometry,
// runs before and stores the shape in `warps`. `sides` are its smooth parts: `at(s, t)` returns position, normal and uv,
// `parametersOf(p, n, uv)` the parameters of a vertex, or false if it is on another part. `edges` are values of t where u has no
// derivative. `grain` is the scale of a warp's offset for the shape.
import * as m from './matrix.js'

const { PI, sin, cos, hypot } = Math

/** The size of the drawn shapes, in pixels. */
export const radius = 150

/** Makes a shape with one smooth part, whose parameters are u and v. */
const byUv = (at, edges = []) => [
  { at: (u, v) => ({ ...at(u, v), uv: [u, v] }), parametersOf: (_, __, [u, v]) => [u, v], edges },
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

/** Makes a side that narrows by `taper`, from 0 for a cylinder to 1 for a cone, and two caps, whose second parameter is the radius. */
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
    parametersOf: (_, n, [u, v]) => Math.abs(n[1]) < 0.9 && [u, v],
    edges: taper ? [1] : [],
  }
  const cap = (y) => ({
    at: (u, r) => ({
      p: [r * sin(2 * PI * u), y, r * cos(2 * PI * u)].map((x) => size * x),
      n: [0, (2 * y) / size, 0],
      uv: [u, y + 0.5],
    }),
    parametersOf: (p, n, [u]) => n[1] * y > 0.45 && [u, hypot(p[0], p[2]) / size],
    edges: [0],
  })
  return [side, cap(-0.5), cap(0.5)]
}

/**
 * Makes a shape of buildGeometry. p5 does not record how it was built, so a pole has only the data of its triangles; and p5 does not
 * normalize the normals after it has scaled them.
 */
const builtShape = (name, code, sides) => ({
  isBuilt: true,
  setup: `warps.${name} = buildGeometry(() => { ${code} })`,
  code: `model(warps.${name})`,
  sides,
  grain: { height: radius, length: radius, normals: radius },
})

/**
 * Maps names → shapes. p5 scales its own shapes, of size 1, to the `scale` of the draw call; the vertices of built shapes include their
 * size. In `grain`, `height` multiplies the offset, `length` divides the positions that it reads, and `normals` multiplies normals to
 * length 1. Shapes without `sides` consist of flat faces.
 */
export const surfaces = {
  sphere: { code: `sphere(${radius})`, sides: ball([1, 1, 1]), scale: [radius, radius, radius] },
  ellipsoid: {
    code: `ellipsoid(${radius}, ${0.8 * radius}, ${0.6 * radius})`,
    sides: ball([1, 1, 1]),
    scale: [radius, 0.8 * radius, 0.6 * radius],
  },
  torus: {
    code: `torus(${radius}, ${0.3 * radius})`,
    sides: ring(1),
    scale: [radius, radius, radius],
  },
  cylinder: {
    code: `cylinder(${radius}, ${radius})`,
    sides: pillar(1, 0),
    scale: [radius, radius, radius],
  },
  cone: {
    code: `cone(${radius}, ${radius})`,
    sides: pillar(1, 1),
    scale: [radius, radius, radius],
  },
  box: { code: `box(${radius})`, scale: [radius, radius, radius] },
  plane: {
    code: 'plane(400, 260, 50, 50)',
    scale: [400, 260, 1],
    grain: { height: radius, length: 1, normals: 1 },
  },
  'a built sphere': builtShape('ball', `sphere(${radius})`, ball([radius, radius, radius])),
  'a built ellipsoid': builtShape(
    'egg',
    `ellipsoid(${radius}, ${0.8 * radius}, ${0.6 * radius})`,
    ball([radius, 0.8 * radius, 0.6 * radius]),
  ),
  'a built torus': builtShape('ring', `torus(${radius}, ${0.3 * radius})`, ring(radius)),
  'a built cylinder': builtShape('pillar', `cylinder(${radius}, ${radius})`, pillar(radius, 0)),
  'a built box': builtShape('crate', `box(${radius})`),
}
