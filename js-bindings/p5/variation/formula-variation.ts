/** How normal and uv vary over the shapes that p5 computes by angles. */
import { variationNames } from '../../core/inputs/inputs.js'
import type { Shape, Vector } from '../host.js'
import { type Triple, add, cross, times } from '../geometry/triple.js'

/** The gradients of the normal's three components, of u and of v, at a vertex. */
type Gradients = (p: Triple, n: Triple, u: number) => readonly Triple[]

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
const formulas: Record<string, Gradients> = {
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

/** Of the shape that p5 names so, such as `ellipsoid|24|16`, if it is one of them. */
export const formulaOf = (name: string): Gradients | undefined =>
  formulas[/^\w+(?=\|)/.exec(name)?.[0] ?? '']

const triple = ({ x, y, z }: Vector = { x: 0, y: 0, z: 0 }): Triple => [x, y, z]

/** By value that varies, its gradients: three numbers for each vertex. */
export function byFormula(
  { vertices, vertexNormals, uvs }: Shape,
  formula: Gradients,
): Float32Array[] {
  const flat = uvs.flat()
  const all = vertices.map((p, i) => formula(triple(p), triple(vertexNormals[i]), flat[2 * i]!))
  return variationNames.map((_, k) => Float32Array.from(all.flatMap((each) => each[k]!)))
}
