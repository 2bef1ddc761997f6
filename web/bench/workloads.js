/**
 * The rows of the benchmark. Each is a mesh and an offset in three forms: an offset function, a plain function of numbers for
 * the oracle, and, if that is feasible, GLSL with handwritten derivatives.
 *
 *   { name, nodes, mesh, warp, offset, handwritten }
 *
 * `nodes` counts the method calls of the offset function, the paper's measure; `mesh()` makes the mesh; `handwritten` are statements
 * that compute, from `position` and `millis`, `vec3 offset` and the columns `vec3 dx, dy, dz` of its Jacobian.
 */
import { gallery } from '../../tests/warps/gallery.js'
import { stackedSines, stress } from '../../tests/warps/stress.js'
import { airplane } from '../models/airplane.js'
import * as handwritten from './handwritten.js'
import { nestedSines } from './nested-sines.js'
import { sphere } from './sphere.js'

/** The number of nodes that the paper counts per sine of the stack, `sum += amplitude * sin(frequency * x + speed * t)`. */
const NODES_PER_SINE = 5
const RADIUS = 100
/** Enough vertices that the cost of short warps is visible beside that of the pixels. */
const DENSE = 100_000

const makeStack = (vertices, sines) => {
  const { waves, ...workload } = stackedSines(sines)
  const nodes = sines * NODES_PER_SINE
  return {
    ...workload,
    name: `${vertices.toLocaleString('en')} × ${nodes.toLocaleString('en')}`,
    nodes,
    mesh: () => sphere(vertices, RADIUS),
    handwritten: handwritten.stackedSines(waves),
  }
}

/** Rotates a model, whose y points down as in p5, by half a turn about x, which leaves a twist about x unchanged. */
function turnUpright({ positions, normals, indices }) {
  const turn = (values) => values.map((value, i) => (i % 3 ? -value : value))
  return { positions: turn(positions), normals: turn(normals), indices }
}

const airplaneTwist = {
  name: 'airplane twist',
  nodes: 15,
  mesh: () => turnUpright(airplane()),
  offset: gallery['airplane-twist'].offset,
  warp({ glsl, position, millis }) {
    const [x, y, z] = [position.x(), position.y(), position.z()]
    const angle = millis.div(1200).sin().mult(x).mult(0.015)
    const [sin, cos] = [angle.sin(), angle.cos()]
    const turnedY = y.mult(cos).sub(z.mult(sin))
    const turnedZ = y.mult(sin).add(z.mult(cos))
    return glsl.vec3(x, turnedY, turnedZ).sub(position)
  },
  handwritten: handwritten.airplaneTwist,
}

const wobble = {
  ...stress.find(({ name }) => name === 'wobble'),
  nodes: 75,
  mesh: () => sphere(DENSE, RADIUS),
  handwritten: handwritten.wobble,
}

const nested = {
  ...nestedSines,
  name: '3 chains of 24 nested sines',
  nodes: 3 * 24 * 3,
  mesh: () => sphere(DENSE, RADIUS),
}

export const workloads = [
  makeStack(14_000, 30),
  makeStack(500_000, 30),
  makeStack(14_000, 300),
  makeStack(14_000, 600),
  airplaneTwist,
  wobble,
  nested,
  makeStack(2_000_000, 30),
]
