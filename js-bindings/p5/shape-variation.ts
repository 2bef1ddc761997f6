/**
 * How normal and uv vary over p5's own shapes and all others, by vertex: what turns the light of an offset that depends on them.
 * The shapes that p5 computes by angles have their derivatives here; others are taken triangle by triangle, which is exact where
 * they are flat.
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
type Gradients = (p: Triple, n: Triple) => readonly Triple[]

const none: Triple = [0, 0, 0]
const times = ([x, y, z]: Triple, k: number): Triple => [x * k, y * k, z * k]
const dot = (a: Triple, b: Triple) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
const add = (a: Triple, b: Triple): Triple => [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
const sub = (a: Triple, b: Triple): Triple => [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
const cross = (a: Triple, b: Triple): Triple => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
]
const axes: readonly Triple[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
]

/** At a pole or an apex, where all u meet, u has no gradient. */
const least = 1e-6

/** The shapes by the beginning of their names; all are of size 1, which p5 scales. */
const known: Record<string, Gradients> = {
  // (cos φ sin θ, sin φ, cos φ cos θ), with u = θ / 2π and v = φ / π + 1/2.
  ellipsoid(p) {
    const [x, y, z] = p
    const r = Math.hypot(x, z)
    if (r < least) return [...axes.map((axis) => sub(axis, times(p, dot(axis, p)))), none, none]
    return [
      ...axes.map((axis) => sub(axis, times(p, dot(axis, p)))),
      times([z, 0, -x], 1 / (2 * Math.PI * r * r)),
      times([(-y * x) / r, r, (-y * z) / r], 1 / Math.PI),
    ]
  },
  // (r cos θ, r sin θ, t sin φ), with r = 1 + t cos φ, u = θ / 2π and v = φ / 2π.
  torus([x, y, z], n) {
    const r = Math.hypot(x, y)
    const around: Triple = [-y / r, x / r, 0]
    const along = cross(around, n)
    const tube = Math.hypot(r - 1, z)
    const outwards = (r - 1) / tube
    return [
      ...axes.map((_, i) =>
        add(times(around, (outwards * around[i]!) / r), times(along, along[i]! / tube)),
      ),
      times(around, 1 / (2 * Math.PI * r)),
      times(along, -1 / (2 * Math.PI * tube)),
    ]
  },
  cylinder: round,
  cone: round,
}

/** Sides and caps: (r sin θ, y, r cos θ), with u = θ / 2π and v = y + 1/2. */
function round([x, , z]: Triple, n: Triple): readonly Triple[] {
  const r = Math.hypot(x, z)
  if (r < least) return [none, none, none, none, none]
  const around: Triple = [z / r, 0, -x / r]
  const outwards = (n[0] * x + n[2] * z) / r
  const up = cross(n, around)
  return [
    ...axes.map((_, i) => times(around, (outwards * around[i]!) / r)),
    times(around, 1 / (2 * Math.PI * r)),
    times(up, up[1]),
  ]
}

const triple = ({ x, y, z }: Vector): Triple => [x, y, z]

/** Finds out how a shape varies; `name` is p5's, such as `ellipsoid|24|16`. */
export function variationOf(shape: Shape, name: string): Variation {
  const positions = shape.vertices.map(triple)
  const normals = positions.map((_, i): Triple => {
    const normal = shape.vertexNormals[i]
    return normal ? triple(normal) : none
  })
  const gradients = known[/^\w+(?=\|)/.exec(name)?.[0] ?? '']
  const all = gradients
    ? positions.map((p, i) => gradients(p, normals[i]!))
    : byTriangles(positions, normals, shape)
  return Object.fromEntries(
    variationNames.map((name, k) => [name, Float32Array.from(all.flatMap((each) => each[k]!))]),
  ) as Variation
}

/** Means of the triangles around each vertex, by their angles there, in the plane that its normal stands on. */
function byTriangles(
  positions: readonly Triple[],
  normals: readonly Triple[],
  { uvs, faces }: Shape,
): readonly (readonly Triple[])[] {
  const flat = uvs.flat()
  const values = positions.map((_, i) => [...normals[i]!, flat[2 * i] ?? 0, flat[2 * i + 1] ?? 0])
  const sums = positions.map(() => ({
    weight: 0,
    gradients: variationNames.map(() => none),
  }))
  for (const face of faces) {
    // As a sketch may make them.
    if (!face.every((i) => positions[i])) continue
    const corners = face.map((i) => positions[i]!)
    const [a, b, c] = corners as unknown as readonly [Triple, Triple, Triple]
    const up = cross(sub(b, a), sub(c, a))
    const twiceSquared = dot(up, up)
    if (!(twiceSquared > 0)) continue
    const opposite = [sub(c, b), sub(a, c), sub(b, a)].map((edge) =>
      times(cross(up, edge), 1 / twiceSquared),
    )
    const gradients = [0, 1, 2, 3, 4].map((k) =>
      face.reduce((sum, i, j) => add(sum, times(opposite[j]!, values[i]![k]!)), none),
    )
    face.forEach((i, j) => {
      const [to, from] = [corners[(j + 1) % 3]!, corners[(j + 2) % 3]!].map((end) =>
        sub(end, corners[j]!),
      ) as [Triple, Triple]
      const angle = Math.atan2(Math.sqrt(twiceSquared), dot(to, from))
      const sum = sums[i]!
      sum.weight += angle
      sum.gradients = sum.gradients.map((each, k) => add(each, times(gradients[k]!, angle)))
    })
  }
  return sums.map(({ weight, gradients }, i) => {
    const n = normals[i]!
    const squared = dot(n, n)
    return gradients.map((sum) => {
      const mean = weight > 0 ? times(sum, 1 / weight) : none
      return squared > 0 ? sub(mean, times(n, dot(mean, n) / squared)) : mean
    })
  })
}
