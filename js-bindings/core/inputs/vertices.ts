// What a warp on the CPU is handed: arrays of vertices, uniforms, a box. Checked here, all in one sentence each.
import { describe } from '../../errors/errors.js'
import { type VertexInput, drawInputs, vertexInputs } from './inputs.js'
import { finiteFloat, firstWrong, inWords, readNumbers } from '../../options/numbers.js'
import { isList } from '../../options/guards.js'
import { Place } from '../../options/place.js'
import { rejectUnknownOptions } from '../../options/schema.js'

/** Flat arrays, so many numbers a vertex. */
export interface Vertices {
  /** Three. */
  positions: ArrayLike<number>
  /** Three, usually of length 1. */
  normals?: ArrayLike<number>
  /** Two. */
  uvs?: ArrayLike<number>
  /** Four, red, green, blue and alpha from 0 to 1. */
  colors?: ArrayLike<number>
  /** Four, as in glTF: a direction, and 1 or -1 for the side of the bitangent. */
  tangents?: ArrayLike<number>
  /** Three each: how normals and uvs vary over the surface, as `surfaceVariation` of 'warpjet/mesh' gives it. An offset that
   * depends on them needs it for right normals; what is missing counts as 0. */
  normalXGradients?: ArrayLike<number>
  normalYGradients?: ArrayLike<number>
  normalZGradients?: ArrayLike<number>
  uGradients?: ArrayLike<number>
  vGradients?: ArrayLike<number>
}

/** By name: a number, or the numbers of a vector or, column by column, of a matrix. */
export type Uniforms = Readonly<Record<string, number | ArrayLike<number>>>

export interface Box {
  /** The least x, y and z. */
  min: ArrayLike<number>
  max: ArrayLike<number>
  /** The range of texture coordinates, if they are not from 0 to 1. */
  uvs?: { min: ArrayLike<number>; max: ArrayLike<number> }
}

/** The arrays of a mesh, by what the offset function calls them. */
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

/** Arrays that held finite numbers when they were checked, or that a warp wrote; others of the same kind can get longer. */
const checked = new WeakSet<Float32Array>()

/** What a warp has written is not checked when it comes back. */
export const noteChecked = (numbers: Float32Array) => void checked.add(numbers)

/** Lets `evaluate` accept numbers that are not finite, for hosts that draw such vertices all the same. Copies their arrays. */
export function allowNonFinite(mesh: Vertices): Vertices {
  const arrays = Object.entries(mesh).map(([name, numbers]: [string, ArrayLike<number>]) => {
    const isFinite = numbers instanceof Float32Array && checked.has(numbers)
    if (isFinite || firstWrong(numbers, finiteFloat) < 0) return [name, numbers] as const
    const copy = Float32Array.from(numbers)
    noteChecked(copy)
    return [name, copy] as const
  })
  return Object.fromEntries(arrays) as unknown as Vertices
}

/** Counts the vertices. Throws for arrays that do not fit, or hold something else than finite numbers when they come for the
 * first time. */
export function checkVertices(at: Place | string, mesh: unknown): number {
  if (typeof mesh !== 'object' || mesh === null || !('positions' in mesh))
    throw Place.of(at).expected('a mesh with an array of positions', describe(mesh))
  if ('uniforms' in mesh)
    throw Place.of(at).error(
      `uniforms stand beside the mesh, not in it, as in ${Place.of(at).method}(mesh, { uniforms: { millis: 1200 } }).`,
    )
  const arrays = mesh as Record<string, unknown>
  let vertices = 0
  for (const { name, size } of sizes) {
    const numbers = arrays[name]
    if (numbers === undefined && name !== 'positions') continue
    if (!isList(numbers))
      throw Place.of(at)
        .part(name)
        .expected(`a flat array of ${size} numbers a vertex`, describe(numbers))
    const { length } = numbers
    if (name === 'positions' && length % 3 !== 0)
      throw Place.of(at).part(name).expected('three numbers a vertex', `${length} numbers`)
    if (name === 'positions') vertices = length / 3
    if (length !== vertices * size)
      throw Place.of(at)
        .part(name)
        .expected(`${size} numbers a vertex, ${vertices * size} for these positions,`, `${length}`)
    const isFloats = numbers instanceof Float32Array
    if (isFloats && checked.has(numbers)) continue
    const wrong = firstWrong(numbers, finiteFloat)
    if (wrong >= 0)
      throw Place.of(at)
        .part(`${name}[${wrong}], of vertex ${Math.floor(wrong / size)}`)
        .expected('a finite number', `${inWords(numbers[wrong])}`)
    if (isFloats) noteChecked(numbers)
  }
  return vertices
}

const adviceForUniform = (name: string) => `if it is a uniform, write { uniforms: { ${name}: … } }.`

/** The uniforms of options that hold only what is `known`. */
export function uniformsOf(
  at: Place | string,
  options: unknown,
  known: readonly string[] = ['uniforms'],
): Uniforms | undefined {
  rejectUnknownOptions(options, known, at, adviceForUniform)
  return (options as { uniforms?: Uniforms } | undefined)?.uniforms
}

/** Throws for a uniform that is none of the inputs of a draw call and no parameter of the warp. */
export function checkUniforms(at: Place | string, given: unknown, parameters: ReadonlySet<string>) {
  if (given === undefined) return
  if (typeof given !== 'object' || given === null || isList(given))
    throw Place.of(at)
      .part('uniforms')
      .expected('an object, such as { millis: 1200 },', describe(given))
  for (const name in given) {
    if (Object.hasOwn(drawInputs, name) || parameters.has(name)) continue
    if (!Object.hasOwn(given, name)) continue
    const known = new Set([...Object.keys(drawInputs), ...parameters])
    throw Place.of(at).error(
      `the warp has no uniform "${name}"; there are ${[...known].join(', ')}.`,
    )
  }
}

export type Range = readonly [low: number, high: number]

/** The range of each coordinate of a box of that name. */
export function readRanges(at: Place | string, name: string, box: unknown, count: number): Range[] {
  const place = Place.of(at).part(name)
  if (typeof box !== 'object' || box === null)
    throw place.expected(`{ min, max }, each of ${count} numbers,`, describe(box))
  const { min, max } = box as Box
  const low = readNumbers(place.part(`${name}.min`), min, count)
  const high = readNumbers(place.part(`${name}.max`), max, count)
  return low.map((least, i) => {
    if (least <= high[i]!) return [least, high[i]!]
    throw place.error(
      `${name}.min[${i}] is ${least}, above ${name}.max[${i}], which is ${high[i]}.`,
    )
  })
}
