/** Gradients of normal and uv on the shapes that p5 computes from angles, by formulas. */
import { variationNames } from '../../compile/hosts.js'
import { add, cross, times, type Triple } from '../geometry/triple.js'
import type { Shape, Vector } from '../host.js'

/** Returns the gradients of the normal's three components, of u and of v, at a vertex with position p and normal n. */
type Gradients = (p: Triple, n: Triple, u: number) => readonly Triple[]

const { PI, hypot, max } = Math

/**
 * At poles and apexes the radius is 0 and the slope of u unbounded. A vertex there has the u of its own column, so we
 * treat it as this far out on that column: near enough for the limit, and far enough that rounding errors of a sine,
 * times the slope, stay small.
 */
const minRadius = 3e-5

/**
 * Returns the gradients on a surface of revolution from its unit directions around and along, its principal curvatures,
 * and the slope of v along it.
 */
const gradientsOfRevolution = (
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
 * Returns the gradients for revolution about the y axis, where u is 0 in the direction of z. The profile is a straight
 * line with v = y + 1/2, or a circular arc of curvature `bend`.
 */
const revolveAboutY =
  (bend = 0, slopeOfV = 0): Gradients =>
  ([x, , z], n, u) => {
    const around: Triple = [Math.cos(2 * PI * u), 0, -Math.sin(2 * PI * u)]
    const along = cross(n, around)
    const r = max(hypot(x, z), minRadius)
    return gradientsOfRevolution(
      around,
      along,
      r,
      bend || hypot(n[0], n[2]) / r,
      bend,
      slopeOfV || along[1],
    )
  }

/** Maps the first word of p5's name of a shape to its formula. All shapes have size 1 and are scaled by p5. */
const formulas: Record<string, Gradients> = {
  // (cos φ sin θ, sin φ, cos φ cos θ), with u = θ / 2π and v = φ / π + 1/2.
  ellipsoid: revolveAboutY(1, 1 / PI),
  // (r cos θ, r sin θ, t sin φ), with r = 1 + t cos φ, u = θ / 2π and v = φ / 2π.
  torus([x, y, z], n) {
    const r = hypot(x, y)
    const around: Triple = [-y / r, x / r, 0]
    const tube = hypot(r - 1, z)
    return gradientsOfRevolution(
      around,
      cross(n, around),
      r,
      (r - 1) / tube / r,
      1 / tube,
      1 / (2 * PI * tube),
    )
  },
  // Sides and caps: (r sin θ, y, r cos θ), with u = θ / 2π and v = y + 1/2.
  cylinder: revolveAboutY(),
  cone: revolveAboutY(),
}

/** Returns the formula of the shape with p5's name `name`, such as `ellipsoid|24|16`; `undefined` if it has none. */
export const formulaOf = (name: string): Gradients | undefined =>
  formulas[/^\w+(?=\|)/.exec(name)?.[0] ?? '']

const triple = ({ x, y, z }: Vector = { x: 0, y: 0, z: 0 }): Triple => [x, y, z]

/** Returns the gradients of each varying value: 3 floats per vertex. */
export function gradientsByFormula(
  { vertices, vertexNormals, uvs }: Shape,
  formula: Gradients,
): Float32Array[] {
  const flat = uvs.flat()
  const all = vertices.map((p, i) => formula(triple(p), triple(vertexNormals[i]), flat[2 * i]!))
  return variationNames.map((_, k) => Float32Array.from(all.flatMap((each) => each[k]!)))
}
