// What a warp on the CPU is handed: arrays of vertices, uniforms, a box. Checked here, all in one sentence each.
import { WarpError, describe } from './errors.js'
import { type VertexInput, drawInputs, vertexInputs } from './inputs.js'
import { isList } from './options.js'

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

/** The place of the first that is no number, or none that a float32 can hold; -1 if all are well. */
function firstNotFinite(numbers: ArrayLike<unknown>): number {
  if (numbers instanceof Float32Array) {
    // A finite number makes 0 here, any other NaN: several times as fast as asking each.
    let zero = 0
    for (let i = 0; i < numbers.length; i++) zero += numbers[i]! * 0
    if (zero === 0) return -1
  }
  for (let i = 0; i < numbers.length; i++) {
    const number = numbers[i]
    if (!(typeof number === 'number' && Number.isFinite(Math.fround(number)))) return i
  }
  return -1
}

/** How many vertices there are; throws for arrays that do not fit or hold something else than finite numbers. */
export function checkVertices(method: string, mesh: unknown): number {
  if (typeof mesh !== 'object' || mesh === null || !('positions' in mesh))
    throw new WarpError(
      `${method}: a mesh with an array of positions was expected, but ${describe(mesh)} came.`,
    )
  const arrays = mesh as Record<string, unknown>
  let vertices = 0
  for (const [input, name] of Object.entries(arrayNames)) {
    const size = vertexInputs[input as VertexInput]
    const numbers = arrays[name]
    if (numbers === undefined && name !== 'positions') continue
    if (!isList(numbers))
      throw new WarpError(
        `${method}: ${name} must be a flat array of ${size} numbers a vertex, but is ${describe(numbers)}.`,
      )
    if (name === 'positions' && numbers.length % 3 !== 0)
      throw new WarpError(
        `${method}: positions must have three numbers a vertex, but has ${numbers.length} numbers.`,
      )
    if (name === 'positions') vertices = numbers.length / 3
    if (numbers.length !== vertices * size)
      throw new WarpError(
        `${method}: ${name} must have ${size} numbers a vertex, ${vertices * size} for these positions, but has ${numbers.length}.`,
      )
    const wrong = firstNotFinite(numbers)
    if (wrong >= 0)
      throw new WarpError(
        `${method}: ${name}[${wrong}], of vertex ${Math.floor(wrong / size)}, must be a finite number, but is ${inWords(numbers[wrong])}.`,
      )
  }
  return vertices
}

const inWords = (value: unknown) => (typeof value === 'number' ? value : describe(value))

/** `count` finite numbers, as an array. */
export function readNumbers(place: string, value: unknown, count: number): number[] {
  const list = count === 1 && typeof value === 'number' ? [value] : value
  if (isList(list) && list.length === count && firstNotFinite(list) < 0) return Array.from(list)
  const expected = count === 1 ? 'a finite number' : `an array of ${count} finite numbers`
  const came =
    isList(list) && list.length === count
      ? `has ${inWords(list[firstNotFinite(list)])} among them`
      : `is ${describe(value)}`
  throw new WarpError(`${place} must be ${expected}, but ${came}.`)
}

/** Refuses a uniform that is none of the inputs of a draw call and no parameter of the warp. */
export function checkUniforms(method: string, uniforms: unknown, parameters: Iterable<string>) {
  if (uniforms === undefined) return
  if (typeof uniforms !== 'object' || uniforms === null || isList(uniforms))
    throw new WarpError(
      `${method}: uniforms must be an object, such as { millis: 1200 }, but is ${describe(uniforms)}.`,
    )
  if ('uniforms' in uniforms)
    throw new WarpError(
      `${method}: the uniforms are to be given by themselves, as in { millis: 1200 }, not as { uniforms: … }.`,
    )
  const known = new Set([...Object.keys(drawInputs), ...parameters])
  for (const name of Object.keys(uniforms))
    if (!known.has(name))
      throw new WarpError(
        `${method}: the warp has no uniform "${name}"; there are ${[...known].join(', ')}.`,
      )
}

export type Range = readonly [low: number, high: number]

/** The range of each coordinate of a box. */
export function readRanges(method: string, name: string, box: unknown, count: number): Range[] {
  if (typeof box !== 'object' || box === null)
    throw new WarpError(
      `${method}: ${name} must be { min, max }, each of ${count} numbers, but is ${describe(box)}.`,
    )
  const { min, max } = box as Box
  const low = readNumbers(`${method}: ${name}.min`, min, count)
  const high = readNumbers(`${method}: ${name}.max`, max, count)
  return low.map((least, i) => {
    if (least <= high[i]!) return [least, high[i]!]
    throw new WarpError(
      `${method}: ${name}.min[${i}] is ${least}, above ${name}.max[${i}], which is ${high[i]}.`,
    )
  })
}
