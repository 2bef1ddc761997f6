/**
 * How normal and uv vary over p5's own shapes and all others, by vertex: what turns the light of an offset that
 * depends on them. The shapes that p5 computes by angles have their derivatives here; others are taken triangle by
 * triangle, which is exact where they are flat.
 */
import { type VariationInput, variationNames } from '../inputs/inputs.js'

interface Vector {
  x: number
  y: number
  z: number
}

/** What is used of a p5.Geometry. */
export interface Shape {
  gid?: string
  vertices: Vector[]
  vertexNormals: Vector[]
  uvs: number[] | number[][]
  faces: number[][]
}

type Triple = readonly [number, number, number]

/** By vertex, three numbers for each of `variationNames`. */
export type Variation = Record<VariationInput, Float32Array>

/** The gradients of the normal's three components, of u and of v, at a vertex. */
type Gradients = (p: Triple, n: Triple, u: number) => readonly Triple[]

const none: Triple = [0, 0, 0]
const times = ([x, y, z]: Triple, k: number): Triple => [x * k, y * k, z * k]
const dot = (a: Triple, b: Triple) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
const add = (a: Triple, b: Triple): Triple => [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
const sub = (a: Triple, b: Triple): Triple => add(a, times(b, -1))
const cross = (a: Triple, b: Triple): Triple => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
]

const { PI, hypot, max } = Math

/**
 * At poles and apexes the radius is 0, and u has no bounds to its slope. A vertex there has the u of its own column,
 * so it counts as this far out on it: near enough for the limit, and far enough that rounding errors of a sine, times
 * the slope, stay small.
 */
const least = 3e-5

/**
 * The gradients on a surface of revolution, by its unit directions around and along, its principal curvatures, and
 * how fast v grows along it.
 */
const revolved = (
  around: Triple,
  along: Triple,
  radius: number,
  curvatureAround: number,
  curvatureAlong: number,
  slopeOfV: number,
): readonly Triple[] => [
  ...[0, 1, 2].map((i) =>
    add(times(around, curvatureAround * around[i]!), times(along, curvatureAlong * along[i]!)),
  ),
  times(around, 1 / (2 * PI * radius)),
  times(along, slopeOfV),
]

/**
 * About the y axis, u beginning where z is ahead: by a straight line with v = y + 1/2, or by one that bends like a
 * circle.
 */
const upright =
  (bend = 0, rise = 0): Gradients =>
  ([x, , z], n, u) => {
    const around: Triple = [Math.cos(2 * PI * u), 0, -Math.sin(2 * PI * u)]
    const along = cross(n, around)
    const r = max(hypot(x, z), least)
    return revolved(around, along, r, bend || hypot(n[0], n[2]) / r, bend, rise || along[1])
  }

/** The shapes by the beginning of their names; all are of size 1, which p5 scales. */
const known: Record<string, Gradients> = {
  // (cos φ sin θ, sin φ, cos φ cos θ), with u = θ / 2π and v = φ / π + 1/2.
  ellipsoid: upright(1, 1 / PI),
  // (r cos θ, r sin θ, t sin φ), with r = 1 + t cos φ, u = θ / 2π and v = φ / 2π.
  torus([x, y, z], n) {
    const r = hypot(x, y)
    const around: Triple = [-y / r, x / r, 0]
    const tube = hypot(r - 1, z)
    return revolved(around, cross(n, around), r, (r - 1) / tube / r, 1 / tube, 1 / (2 * PI * tube))
  },
  // Sides and caps: (r sin θ, y, r cos θ), with u = θ / 2π and v = y + 1/2.
  cylinder: upright(),
  cone: upright(),
}

const triple = ({ x, y, z }: Vector): Triple => [x, y, z]

/** Finds out how a shape varies; `name` is p5's, such as `ellipsoid|24|16`. */
export function variationOf(shape: Shape, name: string): Variation {
  const uvs = shape.uvs.flat()
  const positions = shape.vertices.map(triple)
  const normals = positions.map((_, i) => triple(shape.vertexNormals[i] ?? { x: 0, y: 0, z: 0 }))
  const gradients = known[/^\w+(?=\|)/.exec(name)?.[0] ?? '']
  const all = gradients
    ? positions.map((p, i) => gradients(p, normals[i]!, uvs[2 * i]!))
    : byTriangles(positions, normals, uvs, shape.faces)
  return Object.fromEntries(
    variationNames.map((name, k) => [name, Float32Array.from(all.flatMap((each) => each[k]!))]),
  ) as Variation
}

/**
 * Means of the triangles around each vertex, in the tangent plane, with the weights that make the
 * normals of a sphere exact (Max, "Weights for Computing Vertex Normals from Facet Normals", 1999). Vertices of one
 * place and normal share what the normal does, and what the uvs do where these only begin anew, so that such a seam
 * is none of the light.
 */
function byTriangles(
  positions: readonly Triple[],
  normals: readonly Triple[],
  uvs: readonly number[],
  faces: readonly number[][],
): readonly (readonly Triple[])[] {
  const values = positions.map((_, i) => [...normals[i]!, uvs[2 * i] ?? 0, uvs[2 * i + 1] ?? 0])
  // With whom each shares them: by position and normal, and by uv but for whole numbers.
  const [ofNormal, ofUv] = [3, 5].map((count) => {
    const first: Record<string, number> = {}
    return values.map((value, i) => {
      const all = [...positions[i]!, ...value.slice(0, count)]
      return (first[`${all.map((x, k) => Math.round((k < 6 ? x : x % 1) * 1e6))}`] ??= i)
    })
  })
  const sums = values.map((each) => each.map(() => ({ weight: 0, gradient: none })))
  const sumOf = (i: number, k: number) => sums[(k < 3 ? ofNormal : ofUv)![i]!]![k]!
  for (const face of faces) {
    // As a sketch may make them.
    if (!face.every((i) => positions[i])) continue
    const [a, b, c] = face.map((i) => positions[i]!) as unknown as readonly [Triple, Triple, Triple]
    const opposite = [sub(c, b), sub(a, c), sub(b, a)]
    const squares = opposite.map((edge) => dot(edge, edge))
    const up = cross(opposite[0]!, opposite[1]!)
    const twiceSquared = dot(up, up)
    // Two corners at one place, as p5 has them at poles and seams, are so but for rounding errors.
    if (!(twiceSquared > 1e-12 * max(...squares) ** 2)) continue
    const rises = opposite.map((edge) => times(cross(up, edge), 1 / twiceSquared))
    // By corner, its sine over the lengths of its two sides.
    const weights = squares.map(
      (square) => (square * Math.sqrt(twiceSquared)) / squares.reduce((a, b) => a * b),
    )
    values[0]!.forEach((_, k) => {
      const gradient = face.reduce((sum, i, j) => add(sum, times(rises[j]!, values[i]![k]!)), none)
      face.forEach((i, j) => {
        const sum = sumOf(i, k)
        const weight = weights[j]!
        sum.weight += weight
        sum.gradient = add(sum.gradient, times(gradient, weight))
      })
    })
  }
  return values.map((each, i) => {
    const n = normals[i]!
    return each.map((_, k) => {
      const { weight, gradient } = sumOf(i, k)
      const mean = times(gradient, 1 / (weight || 1))
      return sub(mean, times(n, dot(mean, n) / dot(n, n) || 0))
    })
  })
}
