// Checks the inputs of a warp on the CPU: arrays of vertices, uniforms, a box.
import { describe } from '../../errors/errors.js'
import { isList } from '../../options/guards.js'
import { describeNumber, finiteFloat, firstWrong, readNumbers } from '../../options/numbers.js'
import type { Place } from '../../options/place.js'
import { rejectUnknownOptions } from '../../options/schema.js'
import { unknownUniform } from './declared-uniforms.js'
import { drawInputs, vertexInputs, type VertexInput } from './inputs.js'

/** Flat arrays of vertices. */
export interface Vertices {
  /** 3 numbers per vertex. */
  positions: ArrayLike<number>
  /** 3 numbers per vertex, normally of length 1. */
  normals?: ArrayLike<number>
  /** 2 numbers per vertex. */
  uvs?: ArrayLike<number>
  /** 4 numbers per vertex: red, green, blue and alpha from 0 to 1. */
  colors?: ArrayLike<number>
  /** 4 numbers per vertex, as in glTF: a direction, and 1 or -1 for the side of the bitangent. */
  tangents?: ArrayLike<number>
  /** 3 numbers per vertex each: how normals and uvs vary over the surface, as `surfaceVariation` of 'warpjet/mesh' computes it.
   * Needed for exact normals of an offset that depends on normals or uvs. Default: 0. */
  normalXGradients?: ArrayLike<number>
  normalYGradients?: ArrayLike<number>
  normalZGradients?: ArrayLike<number>
  uGradients?: ArrayLike<number>
  vGradients?: ArrayLike<number>
}

/** Maps a name → a number, or the numbers of a vector or, column by column, of a matrix. */
export type Uniforms = Readonly<Record<string, number | ArrayLike<number>>>

export interface Box {
  /** The minimum x, y and z. */
  min: ArrayLike<number>
  /** The maximum x, y and z. */
  max: ArrayLike<number>
  /** The range of texture coordinates. Default: 0 to 1. */
  uvs?: { min: ArrayLike<number>; max: ArrayLike<number> }
}

/** Maps an input of the offset function → its array in a mesh. */
export const arrayNames: Record<VertexInput, keyof Vertices> = {
  position: 'positions',
  normal: 'normals',
  uv: 'uvs',
  color: 'colors',
  tangent: 'tangents',
  normalXGradient: 'normalXGradients',
  normalYGradient: 'normalYGradients',
  normalZGradient: 'normalZGradients',
  uGradient: 'uGradients',
  vGradient: 'vGradients',
}

const sizes = Object.entries(arrayNames).map(([input, name]) => ({
  name,
  size: vertexInputs[input as VertexInput],
}))

/** Arrays that need no further check. They are Float32Arrays, since these cannot grow afterwards. */
const checked = new WeakSet<Float32Array>()

/** Marks an array as checked: results of a warp need no check when they are passed to another warp. */
export const markChecked = (numbers: Float32Array) => void checked.add(numbers)

/**
 * Returns a mesh that `evaluate` accepts although numbers are not finite, for hosts that draw such vertices anyway. Arrays with such
 * numbers are copied.
 */
export function allowNonFinite(mesh: Vertices): Vertices {
  const arrays = Object.entries(mesh).map(([name, numbers]: [string, ArrayLike<number>]) => {
    const isFinite = numbers instanceof Float32Array && checked.has(numbers)
    if (isFinite || firstWrong(numbers, finiteFloat) < 0) return [name, numbers] as const
    const copy = Float32Array.from(numbers)
    markChecked(copy)
    return [name, copy] as const
  })
  return Object.fromEntries(arrays) as unknown as Vertices
}

/** Counts the vertices. Throws for arrays whose lengths do not match. Arrays that are passed for the first time must hold only finite
 * numbers. */
export function countVertices(place: Place, mesh: unknown): number {
  if (typeof mesh !== 'object' || mesh === null || !('positions' in mesh))
    throw place.expected('a mesh with an array of positions', describe(mesh))
  if ('uniforms' in mesh)
    throw place.error(
      `uniforms are an option, not a part of the mesh, as in ${place.method}(mesh, { uniforms: { millis: 1200 } }).`,
    )
  const arrays = mesh as Record<string, unknown>
  let vertices = 0
  for (const { name, size } of sizes) {
    const numbers = arrays[name]
    if (numbers === undefined && name !== 'positions') continue
    if (!isList(numbers))
      throw place
        .part(name)
        .expected(`a flat array of ${size} numbers per vertex`, describe(numbers))
    const { length } = numbers
    if (name === 'positions' && length % 3 !== 0)
      throw place.part(name).expected('3 numbers per vertex', `${length} numbers`)
    if (name === 'positions') vertices = length / 3
    if (length !== vertices * size)
      throw place
        .part(name)
        .expected(
          `${size} numbers per vertex, ${vertices * size} for these positions,`,
          `${length}`,
        )
    const isFloats = numbers instanceof Float32Array
    if (isFloats && checked.has(numbers)) continue
    const wrongIndex = firstWrong(numbers, finiteFloat)
    if (wrongIndex >= 0)
      throw place
        .part(`${name}[${wrongIndex}], of vertex ${Math.floor(wrongIndex / size)}`)
        .expected('a finite number', describeNumber(numbers[wrongIndex]))
    if (isFloats) markChecked(numbers)
  }
  return vertices
}

const adviceForUniform = (name: string) => `if it is a uniform, write { uniforms: { ${name}: … } }.`

/** Returns the option `uniforms`. Throws for an option that is not among `known`. */
export function uniformsOf(
  place: Place,
  options: unknown,
  known: readonly string[] = ['uniforms'],
): Uniforms | undefined {
  rejectUnknownOptions(options, known, place, adviceForUniform)
  return (options as { uniforms?: Uniforms } | undefined)?.uniforms
}

/** Throws for a uniform that is neither an input of a draw call nor a parameter of the warp. */
export function checkUniforms(place: Place, uniforms: unknown, parameters: ReadonlySet<string>) {
  if (uniforms === undefined) return
  if (typeof uniforms !== 'object' || uniforms === null || isList(uniforms))
    throw place
      .part('uniforms')
      .expected('an object, such as { millis: 1200 },', describe(uniforms))
  for (const name in uniforms) {
    if (Object.hasOwn(drawInputs, name) || parameters.has(name)) continue
    if (!Object.hasOwn(uniforms, name)) continue
    const known = new Set([...Object.keys(drawInputs), ...parameters])
    throw unknownUniform(place, name, [...known])
  }
}

export type Range = readonly [low: number, high: number]

/** Reads `{ min, max }` as the range of each coordinate. */
export function readRanges(place: Place, box: unknown, count: number): Range[] {
  if (typeof box !== 'object' || box === null)
    throw place.expected(`{ min, max }, each of ${count} numbers,`, describe(box))
  const { min, max } = box as Box
  const name = place.subject
  const low = readNumbers(place.part(`${name}.min`), min, count)
  const high = readNumbers(place.part(`${name}.max`), max, count)
  return low.map((start, i) => {
    const end = high[i]!
    if (start <= end) return [start, end]
    throw place.error(`${name}.min[${i}] is ${start}, above ${name}.max[${i}], which is ${end}.`)
  })
}
