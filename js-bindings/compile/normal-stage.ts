/**
 * Decides where a warp's normals are computed: at vertices, between which the host interpolates, or at pixels. The decision depends on
 * the warp alone, so that it is the same for all shapes.
 */
import type { Variable } from '../core/expression/shapes.js'
import {
  costOf,
  makeProgram,
  type IsFrameConstant,
  type Program,
} from '../core/module/serialized-module.js'
import { runInDouble } from '../cpu/double.js'
import type { NormalStage } from './normals-option.js'
import { resultNumber, type RecordedWarp } from './recorded-warp.js'

/** With `'auto'`, the maximum number of operations on floats per pixel. */
const maxOperations = 4000

/** The typical length of an edge: that of p5's sphere, of radius 1 and with 24 segments. */
const typicalEdge = 0.25

/** A warp bends strongly if interpolated normals are off by more than this, in degrees, at more than one edge in ten. */
const maxAngle = 1

/** The number of edges at which `'auto'` compares normals. */
const edgeCount = 40

/**
 * Returns the stage that `'auto'` selects: `'pixel'` if the normal takes at most `maxOperations` per pixel, and the warp contains noise
 * or bends strongly. A warp that only the GPU can evaluate gets `'vertex'`. `numbersOf` returns the current numbers of a uniform.
 */
export function stageFor(
  recorded: RecordedWarp,
  isFrameConstant: IsFrameConstant | undefined,
  numbersOf: (variable: Variable) => readonly number[] | undefined,
): NormalStage {
  const { module, settings } = recorded
  const results = [resultNumber(recorded, 'normal', settings.surfaceVariation)]
  const { operations, hasNoise, needsGpu } = costOf(module, results, isFrameConstant)
  if (needsGpu || operations > maxOperations) return 'vertex'
  if (hasNoise) return 'pixel'
  const program = makeProgram(module, results)
  if (!program) return 'vertex'
  const values = program.inputs.map((each) => valueOnSphere(each, recorded, numbersOf(each)))
  return bendsStrongly(program, values) ? 'pixel' : 'vertex'
}

/** Returns the numbers of an input at a point of the unit sphere. */
type ValueAt = (point: readonly number[]) => readonly number[]

/**
 * Returns the function that returns the numbers of an input. `numbers` are those of a uniform, which the caller reads only once, since
 * user code may compute them. They are missing for inputs of a draw call, which are taken to be 1.
 */
function valueOnSphere(
  { number, shape: [columns, rows] }: Variable,
  { inputs }: RecordedWarp,
  numbers: readonly number[] = Array<number>(columns * rows).fill(1),
): ValueAt {
  const name = Object.keys(inputs).find((each) => inputs[each as keyof typeof inputs] === number)
  // If all numbers are 0, as for a strength that grows later, the warp would seem flat.
  const constants = numbers.some(Boolean) ? numbers : numbers.map(() => 1)
  return valuesOnSphere[name!] ?? (() => constants)
}

const normalGradientOnSphere = (axis: number) => (point: readonly number[]) =>
  point.map((x, i) => (i === axis ? 1 : 0) - x * point[axis]!)

const valuesOnSphere: Record<string, ValueAt> = {
  position: (point) => point,
  normal: (point) => scale(point, 1 / Math.sqrt(dot(point, point))),
  uv: ([x, y]) => [0.5 + 0.5 * x!, 0.5 + 0.5 * y!],
  color: () => [1, 1, 1, 1],
  tangent: () => [1, 0, 0, 1],
  normalXGradient: normalGradientOnSphere(0),
  normalYGradient: normalGradientOnSphere(1),
  normalZGradient: normalGradientOnSphere(2),
  uGradient: () => [0.5, 0, 0],
  vGradient: () => [0, 0.5, 0],
}

/** Tests whether the normals of `program` change strongly along edges of the typical length, of a sphere of radius 1. */
function bendsStrongly(program: Program, values: readonly ValueAt[]): boolean {
  const normalAt = (point: readonly number[]) =>
    runInDouble(
      program,
      values.flatMap((valueAt) => valueAt(point)),
      3,
    )
  const angles = makeEdges().map(([start, end]) => {
    const middle = scale(add(start, end), 0.5)
    return degreesBetween(add(normalAt(start), normalAt(end)), normalAt(middle))
  })
  const [decile] = angles.sort((a, b) => b - a).slice(edgeCount / 10)
  return decile! > maxAngle
}

type Edge = readonly [start: number[], end: number[]]

/** Returns edges that are spread over the unit sphere, in all directions: a Fibonacci lattice. */
function makeEdges(): Edge[] {
  const goldenAngle = Math.PI * (3 - Math.sqrt(5))
  return Array.from({ length: edgeCount }, (_, i): Edge => {
    const z = 1 - (2 * i + 1) / edgeCount
    const [longitude, direction] = [i * goldenAngle, i * goldenAngle * goldenAngle]
    const start = onSphere(longitude, Math.asin(z))
    const east = [-Math.sin(longitude), Math.cos(longitude), 0]
    const north = cross(start, east)
    const heading = add(scale(east, Math.cos(direction)), scale(north, Math.sin(direction)))
    return [start, add(scale(start, Math.cos(typicalEdge)), scale(heading, Math.sin(typicalEdge)))]
  })
}

const onSphere = (longitude: number, latitude: number) => [
  Math.cos(latitude) * Math.cos(longitude),
  Math.cos(latitude) * Math.sin(longitude),
  Math.sin(latitude),
]

const add = (a: readonly number[], b: readonly number[]) => a.map((x, i) => x + b[i]!)
const scale = (a: readonly number[], factor: number) => a.map((x) => x * factor)
const dot = (a: readonly number[], b: readonly number[]) =>
  a.reduce((sum, x, i) => sum + x * b[i]!, 0)
const cross = ([x, y, z]: readonly number[], [u, v, w]: readonly number[]) => [
  y! * w! - z! * v!,
  z! * u! - x! * w!,
  x! * v! - y! * u!,
]

/** Returns the angle between two vectors, or 0 if one is zero or not finite. */
function degreesBetween(a: readonly number[], b: readonly number[]): number {
  const crossed = cross(a, b)
  const angle = Math.atan2(Math.sqrt(dot(crossed, crossed)), dot(a, b))
  return Number.isFinite(angle) ? (angle * 180) / Math.PI : 0
}
