/**
 * The rows of the benchmark. Each is a mesh and an offset, the offset three times over: as a sketch writes it, as a plain
 * function of numbers (the oracle), and, where that is feasible, as GLSL with its derivatives written by hand.
 *
 *   { name, nodes, mesh, warp, offset, handwritten }
 *
 * `nodes` are the method calls of the sketch, the paper's measure; `mesh()` makes the mesh; `handwritten` are statements that turn
 * `position` and `millis` into `vec3 offset` and the columns `vec3 dx, dy, dz` of its Jacobian.
 */
import { gallery } from '../../tests/warps/gallery.js'
import { stackedSines, stress } from '../../tests/warps/stress.js'
import { airplane } from '../models/airplane.js'
import * as handwritten from './handwritten.js'
import { nestedSines } from './nested-sines.js'
import { sphere } from './sphere.js'

/** The nodes that the paper counts for a sine of the stack, `sum += amplitude * sin(frequency * x + speed * t)`. */
const NODES_OF_A_SINE = 5
const RADIUS = 100
/** Enough that such short warps can be told apart from the pixels. */
const DENSE = 100_000

const stacked = (vertices, sines) => {
  const { waves, ...workload } = stackedSines(sines)
  const nodes = sines * NODES_OF_A_SINE
  return {
    ...workload,
    name: `${vertices.toLocaleString('en')} × ${nodes.toLocaleString('en')}`,
    nodes,
    mesh: () => sphere(vertices, RADIUS),
    handwritten: handwritten.stackedSines(waves),
  }
}

/** The models have p5's y, which points down. Half a turn about x leaves a twist about x what it is. */
function upright({ positions, normals, indices }) {
  const turn = (values) => values.map((value, i) => (i % 3 ? -value : value))
  return { positions: turn(positions), normals: turn(normals), indices }
}

const airplaneTwist = {
  name: 'airplane twist',
  nodes: 15,
  mesh: () => upright(airplane()),
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
  stacked(14_000, 30),
  stacked(500_000, 30),
  stacked(14_000, 300),
  stacked(14_000, 600),
  airplaneTwist,
  wobble,
  nested,
  stacked(2_000_000, 30),
]
